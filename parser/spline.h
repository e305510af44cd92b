// SPDX-License-Identifier: Apache-2.0
// Curves through points at given times, of the four kinds of POV-Ray 3.7. Before the first point and behind the last
// one a curve stands still.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace proxima {

enum class SplineKind {
    linear,
    quadratic, ///< the parabola through the two points around and the one before them
    cubic,     ///< Hermite's cubic, as steep at each point as the lines to its neighbours are in the mean
    natural,   ///< the cubic whose curvature is continuous, and 0 at both ends
};

class Spline {
public:
    using Point = std::array<double, 5>;

    SplineKind kind = SplineKind::linear;
    int terms = 0; ///< of each point, 2 to 5

    /// Puts a point in its place. False when there is one at this time already.
    bool add(double time, const Point& point);
    /// To be called when all points are there.
    void complete();
    /// Whether there are points enough for this kind, and one at least.
    bool suits(SplineKind kind) const { return kind == SplineKind::cubic ? times_.size() != 2 : !times_.empty(); }
    size_t size() const { return times_.size(); }

    Point at(double time) const { return at(time, kind); }
    Point at(double time, SplineKind kind) const;

private:
    Point on_line(size_t segment, double time) const;
    Point on_parabola(size_t segment, double time) const;
    Point on_hermite_cubic(size_t segment, double time) const;
    Point on_natural_cubic(size_t segment, double time) const;
    double length(size_t segment) const { return times_[segment + 1] - times_[segment]; }
    double slope(size_t segment, size_t term) const {
        return (points_[segment + 1][term] - points_[segment][term]) / length(segment);
    }

    std::vector<double> times_; ///< rising
    std::vector<Point> points_;
    std::vector<Point> curvatures_; ///< second derivatives of the natural spline at the points
};

} // namespace proxima
