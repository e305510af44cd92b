// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/bench_table.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proxima {
namespace {

using nlohmann::ordered_json;

std::string voxels(const BenchRow& row) {
    const auto [x, y, z] = row.grid;
    if (x == 0)
        return "-";
    const std::string size = x == y && y == z ? fmt::format("{}^3", x) : fmt::format("{}x{}x{}", x, y, z);
    return row.brick > 1 ? fmt::format("{} /{}", size, row.brick) : size;
}

std::string method(const BenchRow& row) {
    return row.best ? row.method + ", best" : row.method == "auto" ? "auto: " + row.used : row.method;
}

constexpr const char* header = "{:<11} {:<8} {:>9} {:<7} {:<12} {:>14} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9}\n";

std::string line(const BenchRow& row) {
    constexpr const char* numbers =
        "{:<11} {:<8} {:>9} {:<7} {:<12} {:>14} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>8} {:>9.1f}\n";
    if (!row.failure.empty())
        return fmt::format("{:<11} {:<8} {:>9} {:<7} {:<12} {}\n", row.experiment, row.scene, row.spheres,
                           row.device_name, row.method, row.failure);
    return fmt::format(fmt::runtime(numbers), row.experiment, row.scene, row.spheres, row.device_name, method(row),
                       voxels(row), row.motion_ms, row.build_ms, row.map_ms, row.trace_ms, row.frame_ms,
                       row.lookups ? fmt::format("{:.1f}", *row.lookups) : "-", double(row.device_bytes) / 1e6);
}

std::string beside_text(const BesideTable& table) {
    if (table.rows.empty())
        return {};
    std::vector<std::vector<std::string>> lines{table.columns};
    lines.insert(lines.end(), table.rows.begin(), table.rows.end());
    std::string text = "\n";
    for (const auto& cells : lines) {
        std::string one;
        for (size_t i = 0; i < cells.size(); ++i) {
            size_t width = 0;
            for (const auto& others : lines)
                width = std::max(width, others[i].size());
            one += i + 1 < cells.size() ? fmt::format("{:<{}}  ", cells[i], width) : cells[i];
        }
        text += one + '\n';
    }
    return text;
}

/// Every column of a row by its name: of the JSON and the CSV.
ordered_json columns(const BenchRow& row) {
    ordered_json object;
    object["experiment"] = row.experiment;
    object["scene"] = row.scene;
    object["spheres"] = row.spheres;
    object["device"] = row.device_name;
    object["method"] = row.method;
    object["used"] = row.used;
    object["candidate"] = row.candidate;
    object["best"] = row.best;
    object["width"] = row.frame.width;
    object["height"] = row.frame.height;
    object["grid"] = fmt::format("{}x{}x{}", row.grid[0], row.grid[1], row.grid[2]);
    object["brick"] = row.brick;
    object["frames"] = row.frames;
    object["motion_ms"] = row.motion_ms;
    object["build_ms"] = row.build_ms;
    object["map_ms"] = row.map_ms;
    object["trace_ms"] = row.trace_ms;
    object["frame_ms"] = row.frame_ms;
    object["lookups"] = row.lookups ? ordered_json(*row.lookups) : ordered_json();
    object["references"] = row.references;
    object["device_bytes"] = row.device_bytes;
    object["picture"] = fmt::format("{:016x}", row.picture);
    object["failure"] = row.failure;
    return object;
}

} // namespace

std::string table_text(const BenchReport& report) {
    std::string text;
    for (const std::string& note : report.notes)
        text += note + '\n';
    text += '\n' + fmt::format(fmt::runtime(header), "experiment", "scene", "spheres", "device", "method", "voxels",
                               "motion", "build", "map", "trace", "frame", "lookups", "MB");
    for (const BenchRow& row : report.rows)
        if (!row.candidate || row.best)
            text += line(row);
    return text + beside_text(report.beside);
}

std::string table_json(const BenchReport& report) {
    ordered_json result;
    result["bench"] = report.name;
    result["version"] = PROXIMA_VERSION;
    result["notes"] = report.notes;
    for (const std::vector<std::string>& cells : report.beside.rows) {
        ordered_json object;
        for (size_t i = 0; i < cells.size(); ++i)
            object[report.beside.columns[i]] = cells[i];
        result[report.beside.name].push_back(object);
    }
    result["rows"] = ordered_json::array();
    for (const BenchRow& row : report.rows)
        result["rows"].push_back(columns(row));
    return result.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

std::string table_csv(const BenchReport& report) {
    std::string text;
    const auto add_line = [&](const ordered_json& object, const auto& cell) {
        bool first = true;
        for (const auto& [name, value] : object.items()) {
            text += (first ? "" : ",") + cell(name, value);
            first = false;
        }
        text += '\n';
    };
    add_line(columns({}), [](const std::string& name, const ordered_json&) { return name; });
    for (const BenchRow& row : report.rows)
        add_line(columns(row), [](const std::string&, const ordered_json& value) { // no cell holds a comma or a quote
            return value.is_null() ? std::string() : value.is_string() ? value.get<std::string>() : value.dump();
        });
    return text;
}

} // namespace proxima
