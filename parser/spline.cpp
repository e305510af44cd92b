// SPDX-License-Identifier: Apache-2.0
#include "parser/spline.h"

#include <algorithm>

namespace proxima {

bool Spline::add(double time, const Point& point) {
    const auto place = std::ranges::lower_bound(times_, time);
    if (place != times_.end() && *place == time)
        return false;
    points_.insert(points_.begin() + (place - times_.begin()), point);
    times_.insert(place, time);
    return true;
}

void Spline::complete() {
    kept_at.reset();
    table_ = times_;
    table_.resize(place_of(terms));
    for (int term = 0; term < terms; ++term) {
        const uint64_t place = place_of(term);
        double* number = table_.data() + place;
        *number++ = double(size());
        *number++ = double(place);
        for (const Point& point : points_)
            *number++ = point[size_t(term)];
        bend(number, SplineTerm(table_, place));
    }
}

/// The second derivatives solve a system with three diagonals: elimination forwards (Thomas's method), then
/// substitution backwards.
void Spline::bend(double* curvatures, const SplineTerm& term) const {
    if (size() < 3)
        return;
    const uint32_t last = term.count - 1;
    std::vector<double> ratio(size());
    for (uint32_t i = 1; i < last; ++i) {
        const double before = term.length(i - 1), after = term.length(i);
        const double pivot = 2 * (before + after) - before * ratio[i - 1];
        ratio[i] = after / pivot;
        curvatures[i] = (6 * (term.slope(i) - term.slope(i - 1)) - before * curvatures[i - 1]) / pivot;
    }
    for (uint32_t i = last - 1; i > 0; --i)
        curvatures[i] -= ratio[i] * curvatures[i + 1];
}

Spline::Point Spline::at(double time, SplineKind kind) const {
    Point result{};
    for (int term = 0; term < terms; ++term)
        result[size_t(term)] = SplineTerm(table_, place_of(term)).at(time, kind);
    return result;
}

} // namespace proxima
