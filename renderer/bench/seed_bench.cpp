// SPDX-License-Identifier: Apache-2.0
// Figures 2 to 9 of R. Thomas and S. K. Semwal, "Ray Tracing using 3D Grid Simulations", 2014: its resolutions by the
// renderer's own methods and by the paper's (kernels/baselines), and each method at its own best resolution beside
// them.
#include "renderer/bench/seed_figures.h"

#include <iterator>

namespace proxima {
namespace {

/// The resolutions among which each method has its best.
void add_candidates(const BenchOptions& options, std::vector<BenchRow>& rows) {
    const auto add = [&](const char* method, uint32_t grid, uint32_t brick) {
        rows.push_back(bench_row(options, method, grid, brick));
        rows.back().candidate = true;
    };
    for (const uint32_t grid :
         options.full ? std::vector<uint32_t>{0, 7, 10, 14, 20, 28, 40, 57, 80} : std::vector<uint32_t>{0, 10, 20, 40})
        add("grid", grid, 0);
    for (const uint32_t grid :
         options.full ? std::vector<uint32_t>{10, 20, 28, 40, 57, 80} : std::vector<uint32_t>{20, 40})
        add("cloud", grid, 1);
    for (const uint32_t grid :
         options.full ? std::vector<uint32_t>{0, 40, 80, 112, 160, 224} : std::vector<uint32_t>{0, 80})
        add("cloud", grid, 4);
}

std::vector<BenchRow> rows_of(const SeedFigure& figure, const BenchOptions& options, bool with_best) {
    std::vector<BenchRow> rows;
    if (!figure.is_map)
        for (const char* method : {"brute", "grid"})
            rows.push_back(bench_row(options, method, method[0] == 'g' ? figure.grid : 0));
    rows.push_back(bench_row(options, "cloud", figure.grid, 1));
    if (!figure.is_map)
        rows.push_back(bench_row(options, "paper-grid", figure.grid));
    rows.push_back(bench_row(options, "paper-cloud", figure.grid));
    if (!figure.is_map && with_best)
        add_candidates(options, rows);
    if (figure.is_map)
        for (BenchRow& row : rows) {
            row.frame.width = 64;
            row.frame.height = 36;
            row.counts_lookups = false;
        }
    return rows;
}

// clang-format off
constexpr const char* reading[] = {
    "Beside R. Thomas and S. K. Semwal, \"Ray Tracing using 3D Grid Simulations\", 2014, who used a GTX 570.",
    "Their percentages are read as time saved, 100 (1 - t / t of the other), the mean over the numbers of spheres. Read as",
    "speeds, 91.8 % would be 1.9 times, which does not fit their \"seconds\" against \"milliseconds\". Whether building is in",
    "them is not said: both readings are given.",
    "They leave unsaid: the picture's size, camera, radii and lights (here those of the scene files), the numbers of spheres",
    "in Figures 4 to 9, how long a voxel's list is (here as long as it must be), and their graphs' single values.",
    "paper-grid and paper-cloud are built their way: lists of one length, a thread for each pair of an empty and a filled",
    "voxel, city-block distances, but leaps that miss nothing. The others are the renderer's own, at their resolution; \"best\"",
    "is the resolution, of several, at which the whole frame took least. The loop is motion + build + map + trace."};
// clang-format on

} // namespace

std::vector<BenchRow> seed_rows(const BenchOptions& options, size_t devices) {
    std::vector<BenchRow> rows;
    for (const SeedFigure& figure : seed_figures()) {
        std::vector<uint64_t> counts = options.full ? figure.full : figure.quick;
        if (!options.spheres.empty())
            counts = options.spheres;
        for (const uint64_t spheres : counts)
            for (size_t device = 0; device < devices; ++device)
                for (BenchRow& row : rows_of(figure, options, options.full || spheres == counts.back())) {
                    row.experiment = figure.name;
                    row.scene = figure.scene;
                    row.spheres = spheres;
                    row.device = device;
                    rows.push_back(std::move(row));
                }
    }
    return rows;
}

void conclude_seed(BenchReport& report, BenchScenes&) {
    report.notes.insert(report.notes.end(), std::begin(reading), std::end(reading));
    report.beside = seed_claims(report);
    add_seed_charts(report);
}

} // namespace proxima
