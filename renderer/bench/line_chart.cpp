// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/line_chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace proxima {
namespace {

constexpr double left = 76, top = 44, width = 520, height = 300, legend_width = 250, note_height = 16;

/// Readable on white by people who do not see all colours: Okabe and Ito, "Color Universal Design", 2008.
constexpr const char* palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

/// One axis: numbers to places on the drawing, and where its marks are.
class Axis {
public:
    Axis(double low, double high, bool logarithmic, double begin, double end)
        : logarithmic_(logarithmic), begin_(begin), end_(end) {
        if (!(low <= high))
            low = high = 1;
        if (logarithmic_) {
            low_ = std::floor(std::log10(low) + 1e-9);
            high_ = std::max(std::ceil(std::log10(high) - 1e-9), low_ + 1);
            return;
        }
        const double rough = std::max(high, 1e-9) / 6, power = std::pow(10.0, std::floor(std::log10(rough)));
        for (const double factor : {1.0, 2.0, 5.0, 10.0})
            if (factor * power >= rough) {
                step_ = factor * power;
                break;
            }
        high_ = std::ceil(high / step_ - 1e-9) * step_;
    }
    double place(double value) const {
        const double v = logarithmic_ ? std::log10(value) : value;
        return begin_ + (end_ - begin_) * (v - low_) / (high_ - low_);
    }
    std::vector<double> marks() const {
        std::vector<double> marks;
        for (double v = low_; v <= high_ + 1e-9 * step_; v += logarithmic_ ? 1 : step_)
            marks.push_back(logarithmic_ ? std::pow(10.0, v) : v);
        return marks;
    }

private:
    bool logarithmic_;
    double begin_, end_, low_ = 0, high_ = 1, step_ = 1;
};

std::string number(double value) {
    if (value >= 1e6)
        return fmt::format("{:g} M", value / 1e6);
    return value >= 1e4 ? fmt::format("{:g} k", value / 1e3) : fmt::format("{:g}", value);
}

class Drawing {
public:
    explicit Drawing(const LineChart& chart)
        : chart_(chart), x_(axis(false, chart.logarithmic_x, left, left + width)),
          y_(axis(true, chart.logarithmic_y, top + height, top)) {
        add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" font-family=\"sans-serif\" "
            "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
            "<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n",
            left + width + legend_width, top + height + 52 + note_height * double(chart.notes.size()), left,
            escaped(chart.title));
    }

    void draw_axes() {
        for (const double mark : x_.marks())
            add("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/><text x=\"{0:.1f}\" "
                "y=\"{3}\" text-anchor=\"middle\">{4}</text>\n",
                x_.place(mark), top, top + height, top + height + 16, number(mark));
        for (const double mark : y_.marks())
            add("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#ddd\"/><text x=\"{3}\" "
                "y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
                left, left + width, y_.place(mark), left - 6, y_.place(mark) + 4, number(mark));
        add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", left + width / 2, top + height + 34,
            escaped(chart_.x_label));
        add("<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n", top + height / 2,
            escaped(chart_.y_label));
    }

    void draw_series(const ChartSeries& series) {
        const char* color = palette[series.color % std::size(palette)];
        std::string points;
        for (const auto& [x, y] : series.points) {
            points += fmt::format("{:.1f},{:.1f} ", x_.place(x), y_.place(y));
            draw_mark(x_.place(x), y_.place(y), color, series.only_marks);
        }
        const char* dash = series.dashed ? " stroke-dasharray=\"5 4\"" : "";
        if (!series.only_marks)
            add("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}/>\n", points, color, dash);
        const double x = left + width + 16;
        if (series.only_marks)
            draw_mark(x + 11, legend_y_ - 4, color, true);
        else
            add("<line x1=\"{}\" x2=\"{}\" y1=\"{}\" y2=\"{}\" stroke=\"{}\" stroke-width=\"1.6\"{}/>\n", x, x + 22,
                legend_y_ - 4, legend_y_ - 4, color, dash);
        add("<text x=\"{}\" y=\"{}\">{}</text>\n", x + 28, legend_y_, escaped(series.name));
        legend_y_ += 18;
    }

    void draw_level(const std::string& text, double value) {
        add("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" stroke=\"#777\" stroke-dasharray=\"2 3\"/><text "
            "x=\"{3}\" y=\"{4:.1f}\" fill=\"#555\">{5}</text>\n",
            left, left + width, y_.place(value), left + 6, y_.place(value) - 4, escaped(text));
    }

    std::string take() {
        double y = top + height + 54;
        for (const std::string& note : chart_.notes) {
            add("<text x=\"{}\" y=\"{}\" fill=\"#555\" font-size=\"11\">{}</text>\n", left, y, escaped(note));
            y += note_height;
        }
        add("</svg>\n");
        return std::move(svg_);
    }

private:
    Axis axis(bool second, bool logarithmic, double begin, double end) const {
        double low = 1e300, high = 0;
        const auto include = [&](double value) {
            low = std::min(low, value);
            high = std::max(high, value);
        };
        for (const ChartSeries& series : chart_.series)
            for (const auto& [x, y] : series.points)
                include(second ? y : x);
        if (second)
            for (const auto& [text, value] : chart_.levels)
                include(value);
        return {low, high, logarithmic, begin, end};
    }
    void draw_mark(double x, double y, const char* color, bool large) {
        add("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", x, y, large ? 4.5 : 2.5,
            large ? "white" : color, color);
    }
    template <class... Arguments> void add(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(svg_), text, std::forward<Arguments>(arguments)...);
    }

    const LineChart& chart_;
    Axis x_, y_;
    double legend_y_ = top + 12;
    std::string svg_;
};

} // namespace

bool has_points(const LineChart& chart) {
    return std::ranges::any_of(chart.series, [](const ChartSeries& series) { return !series.points.empty(); });
}

std::string to_svg(const LineChart& chart) {
    Drawing drawing(chart);
    drawing.draw_axes();
    for (const auto& [text, value] : chart.levels)
        drawing.draw_level(text, value);
    for (const ChartSeries& series : chart.series)
        if (!series.points.empty())
            drawing.draw_series(series);
    return drawing.take();
}

} // namespace proxima
