// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/seed_figures.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace proxima {
namespace {

using Value = double BenchRow::*;

/// The rows of a method at the paper's resolution.
std::vector<const BenchRow*> rows_of(const BenchReport& report, const char* figure, const std::string& device,
                                     const std::string& method) {
    std::vector<const BenchRow*> rows;
    for (const BenchRow& row : report.rows)
        if (row.experiment == figure && row.device_name == device && row.method == method && !row.candidate &&
            row.failure.empty())
            rows.push_back(&row);
    return rows;
}

/// Calls `visit(row, other)` for the rows of two methods with as many spheres.
template <class Visit>
void for_each_pair(const std::vector<const BenchRow*>& rows, const std::vector<const BenchRow*>& others,
                   const Visit& visit) {
    for (const BenchRow* row : rows)
        for (const BenchRow* other : others)
            if (row->spheres == other->spheres)
                visit(*row, *other);
}

/// The mean percentage of the other's time that is saved.
std::string saved(const std::vector<const BenchRow*>& rows, const std::vector<const BenchRow*>& others, Value value) {
    double sum = 0;
    int count = 0;
    for_each_pair(rows, others, [&](const BenchRow& row, const BenchRow& other) {
        sum += 100 * (1 - row.*value / (other.*value));
        ++count;
    });
    return count ? fmt::format("{:.1f} %", sum / count) : "-";
}

void add_savings(const BenchReport& report, const SeedFigure& figure, const std::string& device, BesideTable& table) {
    for (const bool over_brute : {false, true})
        for (const std::string prefix : {"", "paper-"}) {
            const std::string method = prefix + "cloud", other = over_brute ? "brute" : prefix + "grid";
            const auto rows = rows_of(report, figure.name, device, method),
                       others = rows_of(report, figure.name, device, other);
            if (!rows.empty())
                table.rows.push_back(
                    {fmt::format("{}, {}: time that {} saves of {}", figure.name, device, method, other),
                     over_brute ? figure.saved_of_brute : figure.saved_of_grid,
                     fmt::format("trace {}, whole frame {}", saved(rows, others, &BenchRow::trace_ms),
                                 saved(rows, others, &BenchRow::frame_ms))});
        }
}

void add_map_times(const BenchReport& report, const SeedFigure& figure, const std::string& device, BesideTable& table) {
    for (const char* method : {"cloud", "paper-cloud"}) {
        double longest = 0;
        for (const BenchRow* row : rows_of(report, figure.name, device, method))
            longest = std::max(longest, row->map_ms);
        if (longest > 0)
            table.rows.push_back({fmt::format("{}, {}: longest time of a map, {}", figure.name, device,
                                              method[0] == 'p' ? "pair by pair" : "pass by pass"),
                                  figure.map_time, fmt::format("{:.3g} ms", longest)});
    }
}

/// The paper's C against its CUDA, of which it gives no number.
void add_devices(const BenchReport& report, const std::string& fast, const std::string& slow, BesideTable& table) {
    const char* figure = seed_figures().front().name;
    for (const char* method : {"brute", "grid", "cloud"}) {
        std::vector<std::string> ratios;
        for_each_pair(rows_of(report, figure, fast, method), rows_of(report, figure, slow, method),
                      [&](const BenchRow& row, const BenchRow& other) {
                          ratios.push_back(fmt::format("{:.1f}", other.frame_ms / row.frame_ms));
                      });
        if (!ratios.empty())
            table.rows.push_back(
                {fmt::format("{}, {}: how many times as fast as {}, by spheres, {}", figure, fast, slow, method),
                 "a clear advantage", fmt::format("{}", fmt::join(ratios, " "))});
    }
}

} // namespace

BesideTable seed_claims(const BenchReport& report) {
    BesideTable table{.name = "claims", .columns = {"claim", "stated", "measured"}, .rows = {}};
    const std::vector<std::string> devices = seed_devices(report);
    for (const std::string& device : devices)
        for (const SeedFigure& figure : seed_figures())
            (figure.is_map ? add_map_times : add_savings)(report, figure, device, table);
    if (devices.size() > 1)
        add_devices(report, devices[0], devices[1], table);
    return table;
}

} // namespace proxima
