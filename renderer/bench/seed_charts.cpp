// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/seed_figures.h"

#include <fmt/format.h>
#include <iterator>

namespace proxima {
namespace {

struct Line {
    const char* method;
    const char* name;
    size_t color;
    bool best; ///< the method at its best resolution instead of the paper's
};

constexpr Line lines[] = {{"brute", "brute force", 0, false},
                          {"grid", "grid", 1, false},
                          {"cloud", "cloud", 2, false},
                          {"paper-grid", "grid, paper's way", 3, false},
                          {"paper-cloud", "cloud, paper's way", 4, false},
                          {"grid", "grid at its best", 1, true},
                          {"cloud", "cloud at its best", 2, true}};

/// The curves of a figure's methods on all devices; the second device is dashed.
LineChart chart_of(const BenchReport& report, const SeedFigure& figure, const char* y_label,
                   const std::function<double(const BenchRow&)>& value, bool with_brute) {
    LineChart chart{.title = fmt::format("{}: {}", figure.name, figure.title),
                    .x_label = "spheres",
                    .y_label = y_label,
                    .logarithmic_x = figure.is_map};
    chart.notes = {"Stated by R. Thomas and S. K. Semwal, Ray Tracing using 3D Grid Simulations, 2014 (GTX 570):",
                   figure.stated};
    if (figure.map_ms > 0)
        chart.levels.emplace_back("the paper, GTX 570", figure.map_ms);
    const std::vector<std::string> devices = seed_devices(report);
    for (size_t d = 0; d < devices.size(); ++d)
        for (const Line& line : lines) {
            if (line.color == 0 && !with_brute)
                continue;
            ChartSeries series = curve(
                report.rows, devices[d] + ": " + line.name, line.color,
                [&](const BenchRow& row) {
                    return row.experiment == figure.name && row.device_name == devices[d] &&
                           row.method == line.method && (line.best ? row.best : !row.candidate);
                },
                value);
            series.dashed = d > 0;
            series.only_marks = line.best;
            chart.series.push_back(std::move(series));
        }
    return chart;
}

} // namespace

void add_seed_charts(BenchReport& report) {
    const auto trace = [](const BenchRow& row) { return row.trace_ms; };
    const auto map = [](const BenchRow& row) { return row.map_ms; };
    const auto rate = [](const BenchRow& row) { return 1000 / row.frame_ms; };
    const auto add = [&](const std::string& name, const SeedFigure& figure, const char* label, const auto& value,
                         bool with_brute) {
        report.add_chart(name, chart_of(report, figure, label, value, with_brute));
    };
    for (const SeedFigure& figure : seed_figures()) {
        const std::string number = std::string(figure.name).substr(7, 1);
        if (figure.is_map) {
            add("figure-" + number, figure, "ms for the map", map, false);
            continue;
        }
        add("figure-" + number, figure, "ms to trace", trace, number == "5");
        if (number == "2")
            add("figure-3", figure, "ms to trace", trace, true);
        if (number != "4") // the question of the paper's title
            add("loop-" + std::string(figure.scene), figure, "frames a second: empty, fill, cloud, trace, move", rate,
                true);
    }
}

} // namespace proxima
