// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/choice_table.h"

#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace proxima::bench {
namespace {

/// The numbers of a row, in the order of the table's columns.
template <class Row, class Visit> void visit_numbers(Row& row, const Visit& visit) {
    auto& work = row.work;
    visit("density", row.density);
    visit("primitives", work.primitives);
    visit("cells", work.cells);
    visit("links", work.links);
    visit("bricks", work.bricks);
    visit("distances", work.distances);
    visit("pixels", work.pixels);
    visit("lookups", work.mean.lookups);
    visit("tests", work.mean.tests);
    visit("together_lookups", work.together.lookups);
    visit("together_tests", work.together.tests);
    visit("build_ms", row.timed.build);
    visit("map_ms", row.timed.map);
    visit("trace_ms", row.timed.trace);
    visit("predicted_build", row.predicted.build);
    visit("predicted_map", row.predicted.map);
    visit("predicted_trace", row.predicted.trace);
}

} // namespace

void write_table(const std::filesystem::path& path, const ChoiceTable& table) {
    std::ofstream out(path);
    out << "set\tscene\tmethod";
    ChoiceRow names;
    visit_numbers(names, [&](const char* name, double) { out << '\t' << name; });
    out << '\n';
    for (const ChoiceRow& row : table.rows) {
        out << row.set << '\t' << row.scene << '\t' << (row.has_cloud ? "cloud" : "grid");
        visit_numbers(row, [&](const char*, double value) { out << fmt::format("\t{:.6g}", value); });
        out << '\n';
    }
    for (const AutoRow& row : table.automatic)
        out << fmt::format("auto\t{}\t{}\t{:.6g}\t{:.6g}\t{:.6g}\n", row.scene, row.has_cloud ? "cloud" : "grid",
                           row.density, row.frame_ms, row.choose_ms);
    if (!out.flush())
        throw std::runtime_error("cannot write " + path.string());
}

ChoiceTable read_table(const std::filesystem::path& path) {
    ChoiceTable table;
    std::ifstream in(path);
    std::string line, method;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::istringstream fields(line);
        ChoiceRow row;
        std::getline(fields, row.set, '\t');
        std::getline(fields, row.scene, '\t');
        std::getline(fields, method, '\t');
        row.has_cloud = method == "cloud";
        if (row.set == "auto") {
            AutoRow own{row.scene, row.has_cloud};
            fields >> own.density >> own.frame_ms >> own.choose_ms;
            table.automatic.push_back(own);
        } else {
            visit_numbers(row, [&](const char*, double& value) { fields >> value; });
            table.rows.push_back(row);
        }
        if (!fields)
            throw std::runtime_error("not a table of choice_bench: " + path.string());
    }
    if (table.rows.empty())
        throw std::runtime_error("nothing in " + path.string());
    return table;
}

} // namespace proxima::bench
