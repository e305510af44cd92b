// SPDX-License-Identifier: Apache-2.0
#include "parser/spline.h"

#include <algorithm>

namespace proxima {
namespace {

using Point = Spline::Point;

Point blend(double a, const Point& p, double b, const Point& q) {
    Point result;
    for (size_t term = 0; term < result.size(); ++term)
        result[term] = a * p[term] + b * q[term];
    return result;
}

} // namespace

bool Spline::add(double time, const Point& point) {
    const auto place = std::ranges::lower_bound(times_, time);
    if (place != times_.end() && *place == time)
        return false;
    points_.insert(points_.begin() + (place - times_.begin()), point);
    times_.insert(place, time);
    return true;
}

/// The second derivatives solve a system with three diagonals, whose matrix is the same for all terms: elimination
/// forwards (Thomas's method), then substitution backwards.
void Spline::complete() {
    curvatures_.assign(times_.size(), Point{});
    if (times_.size() < 3)
        return;
    const size_t last = times_.size() - 1;
    std::vector<double> ratio(times_.size());
    for (size_t i = 1; i < last; ++i) {
        const double before = length(i - 1), after = length(i);
        const double pivot = 2 * (before + after) - before * ratio[i - 1];
        ratio[i] = after / pivot;
        for (size_t term = 0; term < Point{}.size(); ++term)
            curvatures_[i][term] =
                (6 * (slope(i, term) - slope(i - 1, term)) - before * curvatures_[i - 1][term]) / pivot;
    }
    for (size_t i = last - 1; i > 0; --i)
        curvatures_[i] = blend(1, curvatures_[i], -ratio[i], curvatures_[i + 1]);
}

Point Spline::at(double time, SplineKind kind) const {
    // POV-Ray's cubic has no slope at its ends and stands still on the first and last segments.
    const size_t first = kind == SplineKind::cubic && times_.size() > 2 ? 1 : 0;
    const size_t last = times_.size() - 1 - first;
    if (time <= times_[first])
        return points_[first];
    if (time >= times_[last])
        return points_[last];
    const size_t segment = size_t(std::ranges::upper_bound(times_, time) - times_.begin()) - 1;
    switch (kind) {
    case SplineKind::quadratic:
        return times_.size() > 2 ? on_parabola(segment, time) : on_line(segment, time);
    case SplineKind::cubic:
        return on_hermite_cubic(segment, time);
    case SplineKind::natural:
        return on_natural_cubic(segment, time);
    default:
        return on_line(segment, time);
    }
}

Point Spline::on_line(size_t segment, double time) const {
    const double part = (time - times_[segment]) / length(segment);
    return blend(1 - part, points_[segment], part, points_[segment + 1]);
}

/// Lagrange's form.
Point Spline::on_parabola(size_t segment, double time) const {
    const size_t first = std::max<size_t>(segment, 1) - 1;
    Point result{};
    for (size_t i = first; i < first + 3; ++i) {
        double weight = 1;
        for (size_t j = first; j < first + 3; ++j)
            if (j != i)
                weight *= (time - times_[j]) / (times_[i] - times_[j]);
        result = blend(1, result, weight, points_[i]);
    }
    return result;
}

Point Spline::on_hermite_cubic(size_t segment, double time) const {
    const double h = length(segment), u = (time - times_[segment]) / h;
    const double square = u * u, cube = square * u;
    Point result = blend(2 * cube - 3 * square + 1, points_[segment], 3 * square - 2 * cube, points_[segment + 1]);
    for (size_t term = 0; term < result.size(); ++term) {
        const double here = slope(segment, term);
        const double start = (slope(segment - 1, term) + here) / 2, end = (here + slope(segment + 1, term)) / 2;
        result[term] += h * ((cube - 2 * square + u) * start + (cube - square) * end);
    }
    return result;
}

Point Spline::on_natural_cubic(size_t segment, double time) const {
    const double h = length(segment);
    const double a = (times_[segment + 1] - time) / h, b = (time - times_[segment]) / h;
    const Point bend =
        blend((a * a * a - a) * h * h / 6, curvatures_[segment], (b * b * b - b) * h * h / 6, curvatures_[segment + 1]);
    return blend(1, blend(a, points_[segment], b, points_[segment + 1]), 1, bend);
}

} // namespace proxima
