// SPDX-License-Identifier: Apache-2.0
// What leaping saves in scenes from full to empty: the paper expects of emptier scenes that it "should only increase".
#include "renderer/bench/experiments.h"
#include "renderer/bench/structures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

namespace proxima {
namespace {

constexpr const char* scene_names[] = {"lattice", "uniform", "shell", "planes", "clusters", "stadium"};

/// What a second level, or an octree, which the paper names, would look up; counted for the first number of spheres.
void study_structures(BenchReport& report, BenchScenes& scenes) {
    constexpr uint64_t most = 100'000; // it takes seconds on the host
    report.beside = {.name = "structures",
                     .columns = {"scene", "spheres", "structure", "lookups a ray", "spheres tested", "MB"},
                     .rows = {}};
    std::set<std::string> done;
    for (const BenchRow& row : report.rows) {
        if (!done.insert(row.scene).second)
            continue;
        const uint64_t spheres = std::min(row.spheres, most);
        const auto scene = scenes.load(row.scene, spheres, row.frame.width, row.frame.height);
        for (const StructureFigures& figures : count_structures(*scene, 160, 90))
            report.beside.rows.push_back({row.scene, std::to_string(spheres), figures.name,
                                          fmt::format("{:.1f}", figures.lookups), fmt::format("{:.1f}", figures.tests),
                                          fmt::format("{:.2f}", figures.bytes / 1e6)});
    }
    const double spheres = double(std::min(report.rows.front().spheres, most)), slices = std::cbrt(spheres);
    report.notes.push_back(fmt::format("The second table counts, on the host, for camera rays in order of their hits: "
                                       "a grid as ours, a grid with grids in "
                                       "its full voxels,\nan octree of at most 4 spheres a leaf. Slicing extents "
                                       "(Semwal, 1988) cut along one axis: of {:.0f} "
                                       "spheres in {:.0f} slices each has {:.0f}\nor more, whose extents a ray "
                                       "compares before it tests a sphere; they were "
                                       "not counted.",
                                       spheres, slices, spheres / slices));
}

} // namespace

std::vector<BenchRow> sparse_rows(const BenchOptions& options, size_t devices) {
    std::vector<uint64_t> counts{options.full ? 1'000'000u : 5'000u};
    if (!options.spheres.empty())
        counts = options.spheres;
    std::vector<BenchRow> rows;
    for (const char* scene : scene_names)
        for (const uint64_t spheres : counts)
            for (size_t device = 0; device < devices; ++device) {
                const auto add = [&](BenchRow row, bool candidate) {
                    row.experiment = "sparse";
                    row.scene = scene;
                    row.spheres = spheres;
                    row.device = device;
                    row.candidate = candidate;
                    rows.push_back(std::move(row));
                };
                const auto cube = [&](double voxels_a_sphere) {
                    return uint32_t(std::lround(std::cbrt(double(spheres) * voxels_a_sphere)));
                };
                for (const char* method : {"grid", "cloud", "auto"})
                    add(bench_row(options, method), false);
                for (const double voxels : {0.25, 1.0, 4.0, 16.0})
                    add(bench_row(options, "grid", cube(voxels)), true);
                for (const double voxels : {8.0, 64.0, 256.0})
                    add(bench_row(options, "cloud", cube(voxels), 4), true);
            }
    return rows;
}

void conclude_sparse(BenchReport& report, BenchScenes& scenes) {
    study_structures(report, scenes);
    report.notes.emplace_back(
        "best: of several resolutions, from 0.25 to 16 voxels a sphere for grids and 8 to 256 for "
        "clouds of 4^3 voxels a brick.");
    LineChart chart{.title = "What a cloud saves by how far a ray walks",
                    .x_label = "lookups a camera ray, grid",
                    .y_label = "frame by the grid / by the cloud, each at its best",
                    .logarithmic_x = true};
    for (const char* scene : scene_names) {
        const BenchRow *grid = nullptr, *cloud = nullptr, *walk = nullptr;
        for (const BenchRow& row : report.rows) {
            if (row.scene != scene || row.device != 0 || !row.failure.empty())
                continue;
            if (row.best)
                (row.method == "grid" ? grid : cloud) = &row;
            else if (row.method == "grid" && !row.candidate)
                walk = &row;
        }
        if (grid && cloud && walk && walk->lookups && *walk->lookups > 0)
            chart.series.push_back({.name = scene,
                                    .points = {{*walk->lookups, grid->frame_ms / cloud->frame_ms}},
                                    .color = chart.series.size(),
                                    .only_marks = true});
    }
    report.add_chart("sparse", chart);
}

} // namespace proxima
