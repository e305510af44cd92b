// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/record.h"

#include <algorithm>

namespace proxima {
namespace {

constexpr double recommended_levels[] = {8, 4, 2, 1, 0.5};

/// By rising time; of equal ones the more accurate first.
void mark_front(std::vector<TradeoffPoint>& points) {
    std::ranges::stable_sort(points, [](const TradeoffPoint& a, const TradeoffPoint& b) {
        return std::pair(a.ms, a.error.levels) < std::pair(b.ms, b.error.levels);
    });
    const TradeoffPoint* best = nullptr;
    for (TradeoffPoint& point : points) {
        point.on_front = !best || point.error.levels < best->error.levels;
        if (point.on_front)
            best = &point;
    }
}

} // namespace

double median(std::vector<double> values) {
    if (values.empty())
        return 0;
    std::ranges::sort(values);
    const size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

double TradeoffPoint::spread() const {
    if (repeats.empty() || pilot_ms <= 0)
        return 0;
    const auto [least, most] = std::ranges::minmax_element(repeats);
    return (*most - *least) / pilot_ms;
}

std::pair<double, double> TradeoffPoint::range() const {
    if (repeats.empty() || pilot_ms <= 0)
        return {ms, ms};
    const auto [least, most] = std::ranges::minmax_element(repeats);
    return {ms * *least / pilot_ms, ms * *most / pilot_ms};
}

double TradeoffRecord::noise() const {
    std::vector<double> spreads;
    for (const TradeoffPoint& point : points)
        spreads.push_back(point.spread());
    return median(std::move(spreads));
}

void conclude(TradeoffRecord& record) {
    mark_front(record.points);
    record.recommendations.clear();
    for (const double levels : recommended_levels) {
        const auto found = std::ranges::find_if(
            record.points, [=](const TradeoffPoint& point) { return point.error.levels <= levels; });
        Recommendation recommendation{.levels = levels};
        if (found != record.points.end() && levels >= record.reference_error.levels)
            recommendation.point = size_t(found - record.points.begin());
        record.recommendations.push_back(recommendation);
    }
}

} // namespace proxima
