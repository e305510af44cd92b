// SPDX-License-Identifier: Apache-2.0
// What a frame takes as scenes grow, and what a map takes as it grows.
#include "renderer/bench/experiments.h"

#include <algorithm>
#include <fmt/format.h>

namespace proxima {
namespace {

constexpr const char* scene_names[] = {"uniform", "planes", "clusters", "shell"};
constexpr const char* methods[] = {"grid", "cloud", "auto"};

} // namespace

std::vector<BenchRow> scale_rows(const BenchOptions& options, size_t devices) {
    std::vector<uint64_t> counts{10'000, 100'000};
    if (options.full)
        counts.insert(counts.end(), {1'000'000, 10'000'000});
    if (!options.spheres.empty())
        counts = options.spheres;
    std::vector<BenchRow> rows;
    const auto add = [&](BenchRow row, const char* experiment, const char* scene, uint64_t spheres, size_t device) {
        row.experiment = experiment;
        row.scene = scene;
        row.spheres = spheres;
        row.device = device;
        rows.push_back(std::move(row));
    };
    for (const char* scene : scene_names)
        for (const uint64_t spheres : counts)
            for (size_t device = 0; device < devices; ++device)
                for (const char* method : methods)
                    add(bench_row(options, method), "scale", scene, spheres, device);
    const std::vector<uint32_t> maps =
        options.full ? std::vector<uint32_t>{40, 80, 128, 256, 512} : std::vector<uint32_t>{40, 128};
    for (const char* scene : {"uniform", "planes"})
        for (const uint32_t grid : maps)
            for (size_t device = 0; device < devices; ++device) {
                BenchRow row = bench_row(options, "cloud", grid, 1);
                row.frame.width = 64;
                row.frame.height = 36;
                row.counts_lookups = false;
                add(row, "map", scene, std::min<uint64_t>(counts.front(), 10'000), device);
            }
    return rows;
}

void conclude_scale(BenchReport& report, BenchScenes&) {
    report.notes.emplace_back("map: the chessboard map alone of a cloud whose bricks are single voxels.");
    for (const char* scene : scene_names) {
        LineChart chart{.title = fmt::format("{}: a frame in which everything moves and is built anew", scene),
                        .x_label = "spheres",
                        .y_label = "ms a frame",
                        .logarithmic_x = true};
        for (size_t i = 0; i < std::size(methods); ++i) {
            const auto wanted = [&](const BenchRow& row) {
                return row.experiment == "scale" && row.scene == scene && row.method == methods[i] && row.device == 0;
            };
            chart.series.push_back(
                curve(report.rows, methods[i], i + 1, wanted, [](const BenchRow& row) { return row.frame_ms; }));
            ChartSeries trace = curve(report.rows, std::string(methods[i]) + ", trace alone", i + 1, wanted,
                                      [](const BenchRow& row) { return row.trace_ms; });
            trace.dashed = true;
            if (std::string(methods[i]) != "auto")
                chart.series.push_back(std::move(trace));
        }
        report.add_chart(fmt::format("scale-{}", scene), chart);
    }
    LineChart maps{.title = "Chessboard maps", .x_label = "voxels", .y_label = "ms for the map", .logarithmic_x = true};
    for (const char* scene : {"uniform", "planes"}) {
        ChartSeries series{.name = scene, .points = {}, .color = maps.series.size()};
        for (const BenchRow& row : report.rows)
            if (row.experiment == "map" && row.scene == scene && row.device == 0 && row.map_ms > 0)
                series.points.emplace_back(double(row.grid[0]) * row.grid[1] * row.grid[2], row.map_ms);
        maps.series.push_back(std::move(series));
    }
    report.add_chart("maps", maps);
}

} // namespace proxima
