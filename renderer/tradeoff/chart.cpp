// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/chart.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace proxima {
namespace {

constexpr double left = 70, top = 56, width = 860, height = 470;
constexpr double least_levels = 0.01; ///< what is drawn as no error

const char* color_of(const QualitySetting& setting) {
    if (setting.precision == Precision::float64)
        return "#9467bd";
    return setting.antialiasing.method == Antialiasing::Method::none ? "#1f77b4" : "#ff7f0e";
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
    return result;
}

/// 1, 2 or 5 times a power of ten: the largest that is not above `value`.
double mark_below(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

/// The smallest that is above `value`.
double mark_above(double value) {
    const double mark = mark_below(value), power = std::pow(10, std::floor(std::log10(value)));
    return mark == 2 * power ? 5 * power : 2 * mark;
}

/// A logarithmic axis from mark to mark.
struct Axis {
    double low, high;

    Axis(double least, double most) : low(mark_below(least)), high(mark_above(most)) {}

    /// 0 at the low end, 1 at the high one.
    double at(double value) const { return std::log(value / low) / std::log(high / low); }
    template <class Visit> void for_each_mark(const Visit& visit) const {
        for (double mark = low; mark < high * 1.001; mark = mark_above(mark * 1.0001))
            visit(mark);
    }
};

double shown_levels(const TradeoffPoint& point) {
    return std::max(point.error.levels, least_levels);
}

/// The whole picture's time for a repeat of the small one.
double scaled(const TradeoffPoint& point, double repeat) {
    return point.pilot_ms > 0 ? point.ms * repeat / point.pilot_ms : point.ms;
}

Axis time_axis(const TradeoffRecord& record) {
    double least = 1e300, most = 0;
    for (const TradeoffPoint& point : record.points)
        for (const double repeat : point.repeats) {
            least = std::min(least, std::max(scaled(point, repeat), 1e-3));
            most = std::max(most, scaled(point, repeat));
        }
    return {least, std::max(most, least)};
}

Axis error_axis(const TradeoffRecord& record) {
    double least = 1e300, most = 0;
    for (const TradeoffPoint& point : record.points) {
        least = std::min(least, shown_levels(point));
        most = std::max(most, shown_levels(point));
    }
    return {least, std::max(most, least)};
}

class Chart {
public:
    explicit Chart(const TradeoffRecord& record)
        : record_(record), times_(time_axis(record)), errors_(error_axis(record)) {
        add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
            "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
            left + width + 30, top + height + 56);
    }

    void draw_axes() {
        add("<text x=\"{}\" y=\"20\" font-size=\"15\">Time against error: {}, frame {}, on {}</text>\n", left,
            escaped(record_.scene), record_.frame, escaped(record_.device));
        times_.for_each_mark([&](double ms) {
            add("<line x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#e4e4e4\"/><text x=\"{0:.2f}\" "
                "y=\"{3}\" text-anchor=\"middle\">{4:g}</text>\n",
                x_of(ms), top, top + height, top + height + 18, ms);
        });
        errors_.for_each_mark([&](double levels) {
            add("<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.2f}\" y2=\"{2:.2f}\" stroke=\"#e4e4e4\"/><text x=\"{3}\" "
                "y=\"{4:.2f}\" text-anchor=\"end\">{5:g}</text>\n",
                left, left + width, y_of(levels), left - 8, y_of(levels) + 4, levels);
        });
        add("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">milliseconds of a picture of {}x{}</text>\n",
            left + width / 2, top + height + 42, record_.width, record_.height);
        add("<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">RMS error, 8-bit levels of a "
            "display</text>\n",
            top + height / 2);
    }

    void draw_legend() {
        double x = left;
        const auto entry = [&](const char* color, const char* text) {
            add("<circle cx=\"{}\" cy=\"38\" r=\"5\" fill=\"{}\"/><text x=\"{}\" y=\"42\">{}</text>\n", x + 5, color,
                x + 15, text);
            x += 165;
        };
        entry("#1f77b4", "float, --samples");
        entry("#ff7f0e", "float, --antialias");
        entry("#9467bd", "double");
        add("<text x=\"{}\" y=\"42\">rings: on the front; names: what to take</text>\n", x);
    }

    void draw_front() {
        std::string path;
        double last_y = 0;
        for (const TradeoffPoint& point : record_.points) {
            if (!point.on_front)
                continue;
            const double x = x_of(point.ms), y = y_of(shown_levels(point));
            path += path.empty() ? fmt::format("M{:.2f} {:.2f}", x, y)
                                 : fmt::format("L{:.2f} {:.2f}L{:.2f} {:.2f}", x, last_y, x, y);
            last_y = y;
        }
        add("<path d=\"{}\" fill=\"none\" stroke=\"#555\" stroke-width=\"1.5\"/>\n", path);
    }

    void draw_point(const TradeoffPoint& point) {
        const double x = x_of(point.ms), y = y_of(shown_levels(point));
        const auto [least, most] = std::ranges::minmax_element(point.repeats);
        add("<g><title>{}: {:.3f} ms, {:.3f} levels</title><line x1=\"{:.2f}\" x2=\"{:.2f}\" y1=\"{:.2f}\" "
            "y2=\"{:.2f}\" stroke=\"{}\" stroke-opacity=\"0.6\"/><circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" "
            "fill=\"{}\" {}/></g>\n",
            escaped(point.options), point.ms, point.error.levels, x_of(std::max(scaled(point, *least), 1e-3)),
            x_of(scaled(point, *most)), y, y, color_of(point.setting), x, y, point.on_front ? 5 : 3.5,
            color_of(point.setting), point.on_front ? "stroke=\"#222\" stroke-width=\"1.5\"" : "fill-opacity=\"0.6\"");
    }

    /// A setting that is recommended for several levels has one label.
    void draw_labels() {
        std::optional<size_t> last;
        for (const Recommendation& recommendation : record_.recommendations) {
            if (!recommendation.point || recommendation.point == last)
                continue;
            last = recommendation.point;
            const TradeoffPoint& point = record_.points[*last];
            const double x = x_of(point.ms);
            const bool is_right = x + 8 + 5.6 * double(point.options.size()) > left + width; // it goes to the left
            add("<text x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\" font-size=\"11\">{}</text>\n",
                is_right ? x - 8 : x + 8, y_of(shown_levels(point)) + (is_right ? 14 : -7), is_right ? "end" : "start",
                escaped(point.options));
        }
    }

    std::string take() {
        add("</svg>\n");
        return std::move(svg_);
    }

private:
    double x_of(double ms) const { return left + width * times_.at(ms); }
    double y_of(double levels) const { return top + height * (1 - errors_.at(levels)); }
    template <class... Arguments> void add(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(svg_), text, std::forward<Arguments>(arguments)...);
    }

    const TradeoffRecord& record_;
    Axis times_, errors_;
    std::string svg_;
};

} // namespace

std::string tradeoff_svg(const TradeoffRecord& record) {
    Chart chart(record);
    chart.draw_axes();
    chart.draw_legend();
    chart.draw_front();
    for (const TradeoffPoint& point : record.points)
        chart.draw_point(point);
    chart.draw_labels();
    return chart.take();
}

} // namespace proxima
