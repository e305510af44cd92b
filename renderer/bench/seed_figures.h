// SPDX-License-Identifier: Apache-2.0
// The figures of R. Thomas and S. K. Semwal, "Ray Tracing using 3D Grid Simulations", 2014, and what the paper states
// of each of them.
#pragma once
#include "renderer/bench/experiments.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proxima {

struct SeedFigure {
    const char* name;
    const char* title;
    const char* scene;
    uint32_t grid;                     ///< voxels along each axis
    bool is_map;                       ///< only the time of the distances is of interest
    std::vector<uint64_t> quick, full; ///< numbers of spheres
    const char* stated;                ///< for charts, a sentence
    const char* saved_of_grid = "";    ///< percent, by the cloud
    const char* saved_of_brute = "";   ///< percent, by the cloud
    const char* map_time = "";
    double map_ms = 0;
};

const std::vector<SeedFigure>& seed_figures();

/// The devices of a report's rows, in their order.
std::vector<std::string> seed_devices(const BenchReport& report);

/// What the paper states beside what was measured.
BesideTable seed_claims(const BenchReport& report);

/// A chart for each figure, and frames a second of the whole loop.
void add_seed_charts(BenchReport& report);

} // namespace proxima
