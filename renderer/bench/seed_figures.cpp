// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/seed_figures.h"

#include <algorithm>

namespace proxima {

const std::vector<SeedFigure>& seed_figures() {
    static const std::vector<uint64_t> few{10, 100}, some{10, 100, 1000};
    static const std::vector<uint64_t> more{10, 30, 100, 300, 1000, 3000, 10000, 30000};
    static const std::vector<SeedFigure> all{
        {.name = "figure 2/3",
         .title = "clustered spheres, 20^3 voxels",
         .scene = "lattice",
         .grid = 20,
         .is_map = false,
         .quick = {1000, 5000, 15000},
         .full = {1000, 3000, 5000, 7000, 9000, 11000, 13000, 15000},
         .stated = "the cloud saves 0.3 % of the grid's time, 91.8 % of brute force's.",
         .saved_of_grid = "0.3 %",
         .saved_of_brute = "91.8 %"},
        {.name = "figure 4",
         .title = "clustered spheres, 40^3 voxels",
         .scene = "lattice",
         .grid = 40,
         .is_map = false,
         .quick = {1000},
         .full = {500, 1000, 2000, 3000, 4000, 5000},
         .stated = "the cloud saves 6 % of the grid's time, 79 % of brute force's.",
         .saved_of_grid = "6 %",
         .saved_of_brute = "79 %"},
        {.name = "figure 5",
         .title = "two planes of spheres, 40^3 voxels",
         .scene = "planes",
         .grid = 40,
         .is_map = false,
         .quick = {1000, 10000},
         .full = {1000, 2500, 5000, 7500, 10000, 15000},
         .stated = "the cloud saves 6.4 % of the grid's time, 94.2 % of brute force's.",
         .saved_of_grid = "6.4 %",
         .saved_of_brute = "94.2 %"},
        {.name = "figure 6",
         .title = "map of 10^3 voxels",
         .scene = "uniform",
         .grid = 10,
         .is_map = true,
         .quick = some,
         .full = more,
         .stated = "1 ms.",
         .map_time = "1 ms",
         .map_ms = 1},
        {.name = "figure 7",
         .title = "map of 20^3 voxels",
         .scene = "uniform",
         .grid = 20,
         .is_map = true,
         .quick = some,
         .full = more,
         .stated = "350 ms, from where on it levels off.",
         .map_time = "350 ms, from where on it levels off",
         .map_ms = 350},
        {.name = "figure 8",
         .title = "map of 30^3 voxels",
         .scene = "uniform",
         .grid = 30,
         .is_map = true,
         .quick = some,
         .full = more,
         .stated = "the same amount of time as 20^3.",
         .map_time = "the same as 20^3",
         .map_ms = 350},
        {.name = "figure 9",
         .title = "map of 40^3 voxels",
         .scene = "uniform",
         .grid = 40,
         .is_map = true,
         .quick = few,
         .full = more,
         .stated = "over 1.4 s, 1.44 s on average.",
         .map_time = "over 1.4 s, 1.44 s on average",
         .map_ms = 1440},
    };
    return all;
}

std::vector<std::string> seed_devices(const BenchReport& report) {
    std::vector<std::string> names;
    for (const BenchRow& row : report.rows)
        if (std::find(names.begin(), names.end(), row.device_name) == names.end())
            names.push_back(row.device_name);
    return names;
}

} // namespace proxima
