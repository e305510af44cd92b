// SPDX-License-Identifier: Apache-2.0
// What an experiment found, as a table for people, as JSON and as CSV.
#pragma once
#include "renderer/bench/line_chart.h"
#include "renderer/bench/measure.h"

#include <string>
#include <utility>
#include <vector>

namespace proxima {

/// A smaller table below the first one.
struct BesideTable {
    std::string name; ///< of the JSON's array
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

struct BenchReport {
    std::string name;               ///< "seed"
    std::vector<std::string> notes; ///< sentences: what was measured, how the numbers are to be read
    std::vector<BenchRow> rows;     ///< measured
    BesideTable beside;             ///< without rows: none
    std::vector<std::pair<std::string, std::string>> charts; ///< name without ".svg", and the SVG

    /// Unless there is nothing in it.
    void add_chart(const std::string& chart_name, const LineChart& chart) {
        if (has_points(chart))
            charts.emplace_back(chart_name, to_svg(chart));
    }
};

/// Without the candidates that are not the best.
std::string table_text(const BenchReport& report);
std::string table_json(const BenchReport& report);
/// All rows; a line of column names first.
std::string table_csv(const BenchReport& report);

} // namespace proxima
