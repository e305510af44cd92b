// SPDX-License-Identifier: Apache-2.0
#include "renderer/timeline.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <numeric>

namespace proxima {
namespace {

constexpr double left = 110, width = 1280, row = 22, top = 52;
constexpr size_t most_spans = 20'000; ///< that a browser shows without effort

constexpr const char* colors[frame_step_names.size()] = {"#9467bd", "#1f77b4", "#17becf", "#d62728", "#e377c2",
                                                         "#2ca02c", "#ff7f0e", "#bcbd22", "#8c564b", "#7f7f7f"};

/// The distance of the axis's marks: 1, 2 or 5 times a power of ten, about ten of them.
double mark_distance(double length) {
    const double rough = length / 10, power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough)
            return factor * power;
    return 10 * power;
}

/// Row of each lane: devices by name, then writers.
std::vector<size_t> rows_of(const std::vector<std::string>& lanes) {
    std::vector<size_t> order(lanes.size()), rows(lanes.size());
    std::iota(order.begin(), order.end(), size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
        return std::pair(lanes[a] == Timeline::writer, lanes[a]) < std::pair(lanes[b] == Timeline::writer, lanes[b]);
    });
    for (size_t i = 0; i < order.size(); ++i)
        rows[order[i]] = i;
    return rows;
}

class Drawing {
public:
    Drawing(const Timeline& timeline, size_t count) : rows_(rows_of(timeline.lanes())) {
        begin_ = timeline.spans().front().begin_ms;
        for (size_t i = 0; i < count; ++i) {
            begin_ = std::min(begin_, timeline.spans()[i].begin_ms);
            end_ = std::max(end_, timeline.spans()[i].end_ms);
        }
        bottom_ = top + row * double(rows_.size());
        add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" font-family=\"sans-serif\" "
            "font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
            left + width + 20, bottom_ + 30);
    }

    void draw_legend(size_t shown, size_t all) {
        double x = left;
        for (size_t i = 0; i < frame_step_names.size(); ++i, x += 80)
            add("<rect x=\"{}\" y=\"10\" width=\"12\" height=\"12\" fill=\"{}\"/><text x=\"{}\" y=\"20\">{}</text>\n",
                x, colors[i], x + 16, frame_step_names[i]);
        if (shown < all)
            add("<text x=\"{}\" y=\"20\">the first {} of {} steps</text>\n", x, shown, all);
    }

    void draw_axis() {
        const double distance = mark_distance(std::max(end_ - begin_, 1e-3));
        for (double t = 0; t <= end_ - begin_; t += distance)
            add("<line x1=\"{0:.2f}\" x2=\"{0:.2f}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/><text x=\"{0:.2f}\" "
                "y=\"{3}\" text-anchor=\"middle\">{4:g} ms</text>\n",
                x_of(begin_ + t), top - 6, bottom_, top - 12, t);
    }

    void draw_lane(size_t lane, const std::string& name) {
        add("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", left - 8, y_of(lane) + 14, name);
    }

    void draw_span(const TimelineSpan& span) {
        add("<rect x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\" fill=\"{}\"><title>frame {}: {}, {:.3f} "
            "ms</title></rect>\n",
            x_of(span.begin_ms), y_of(span.lane), (span.end_ms - span.begin_ms) * scale(), row - 4,
            colors[size_t(span.step)], span.frame, name_of(span.step), span.end_ms - span.begin_ms);
    }

    std::string take() {
        add("</svg>\n");
        return std::move(svg_);
    }

private:
    double scale() const { return width / std::max(end_ - begin_, 1e-3); }
    double x_of(double ms) const { return left + (ms - begin_) * scale(); }
    double y_of(size_t lane) const { return top + row * double(rows_[lane]); }
    template <class... Arguments> void add(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(svg_), text, std::forward<Arguments>(arguments)...);
    }

    std::vector<size_t> rows_;
    double begin_ = 0, end_ = 0, bottom_ = 0;
    std::string svg_;
};

} // namespace

std::string to_svg(const Timeline& timeline) {
    const size_t count = std::min(timeline.spans().size(), most_spans);
    if (count == 0)
        return "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n";
    Drawing drawing(timeline, count);
    drawing.draw_legend(count, timeline.spans().size());
    drawing.draw_axis();
    for (size_t lane = 0; lane < timeline.lanes().size(); ++lane)
        drawing.draw_lane(lane, timeline.lanes()[lane]);
    for (size_t i = 0; i < count; ++i)
        drawing.draw_span(timeline.spans()[i]);
    return drawing.take();
}

} // namespace proxima
