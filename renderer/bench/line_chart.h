// SPDX-License-Identifier: Apache-2.0
// Curves over a common axis as an SVG drawing.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace proxima {

struct ChartSeries {
    std::string name;
    std::vector<std::pair<double, double>> points; ///< both positive where the axis is logarithmic
    size_t color = 0;                              ///< of a palette
    bool dashed = false;
    bool only_marks = false;
};

struct LineChart {
    std::string title, x_label, y_label;
    bool logarithmic_x = false, logarithmic_y = true;
    std::vector<ChartSeries> series{};
    std::vector<std::pair<std::string, double>> levels{}; ///< horizontal lines with a text, for numbers of others
    std::vector<std::string> notes{};                     ///< lines below
};

/// Series without points are left out.
bool has_points(const LineChart& chart);
std::string to_svg(const LineChart& chart);

} // namespace proxima
