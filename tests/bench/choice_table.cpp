// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/choice_table.h"
#include "renderer/method_choice.h"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace proxima::bench {
namespace {

constexpr const char* method_names[] = {"grid", "cloud"};

/// The numbers of a row, in the order of the table's columns.
template <class Row, class Visit> void visit_numbers(Row& row, const Visit& visit) {
    visit("primitives", row.space.primitives);
    visit("bricks", row.space.bricks);
    visit("empty", row.space.empty);
    visit("mean_distance", row.space.mean_distance);
    for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud}) {
        auto& timed = row.of[method];
        const std::string name = method_names[size_t(method)];
        visit(name + "_references", timed.work.references);
        visit(name + "_voxels", timed.work.voxels);
        visit(name + "_rays", timed.work.rays);
        visit(name + "_lookups", timed.work.lookups);
        visit(name + "_build_ms", timed.build_ms);
        visit(name + "_map_ms", timed.map_ms);
        visit(name + "_trace_ms", timed.trace_ms);
        visit(name + "_frame_ms", timed.frame_ms);
    }
    visit("trial_frames", row.trial_frames);
    visit("auto_ms", row.auto_ms);
}

SearchMethod read_method(std::istream& in) {
    std::string name;
    std::getline(in, name, '\t');
    return name == method_names[1] ? SearchMethod::cloud : SearchMethod::grid;
}

} // namespace

void write_table(const std::filesystem::path& path, const std::vector<ChoiceRow>& rows) {
    std::ofstream out(path);
    out << "set\tscene\tfirst\tlast";
    ChoiceRow names;
    visit_numbers(names, [&](const std::string& name, const auto&) { out << '\t' << name; });
    out << '\n';
    for (const ChoiceRow& row : rows) {
        out << row.set << '\t' << row.scene << '\t' << method_names[size_t(row.first)] << '\t'
            << method_names[size_t(row.last)];
        visit_numbers(row,
                      [&](const std::string&, const auto& value) { out << fmt::format("\t{:.7g}", double(value)); });
        out << '\n';
    }
    if (!out.flush())
        throw std::runtime_error("cannot write " + path.string());
}

std::vector<ChoiceRow> read_table(const std::filesystem::path& path) {
    std::vector<ChoiceRow> rows;
    std::ifstream in(path);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        ChoiceRow row;
        std::getline(fields, row.set, '\t');
        std::getline(fields, row.scene, '\t');
        row.first = read_method(fields);
        row.last = read_method(fields);
        visit_numbers(row, [&](const std::string&, auto& value) {
            double number = 0;
            fields >> number;
            value = std::decay_t<decltype(value)>(number);
        });
        if (!fields)
            throw std::runtime_error("not a table of choice_bench: " + path.string());
        for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud})
            row.of[method].work.primitives = double(row.space.primitives);
        row.of.cloud.work.bricks = double(row.space.bricks);
        rows.push_back(row);
    }
    if (rows.empty())
        throw std::runtime_error("nothing in " + path.string());
    return rows;
}

double simulated_ms(const DeviceCosts& costs, const ChoiceRow& row, double look_ms, int frames) {
    MethodChoice choice(costs);
    OfMethods<bool> warm;
    double total = 0;
    for (int i = 0; i < frames; ++i) {
        FrameSettings settings;
        settings.width = uint32_t(row.of.grid.work.rays);
        settings.height = 1;
        MethodChoice::Frame frame = choice.begin(settings, row.space.primitives);
        if (frame.looks) {
            choice.see(frame, row.space);
            total += look_ms;
        }
        const double ms = row.of[frame.method].frame_ms;
        bool& is_warm = warm[frame.method];
        total += is_warm || i == 0 ? ms : 2 * ms;
        choice.end(frame, ms, is_warm && !frame.looks);
        is_warm = true;
    }
    return total / frames;
}

} // namespace proxima::bench
