// SPDX-License-Identifier: Apache-2.0
// Splines as a scene declares them: points at given times, and the table that motion programs look into.
#pragma once
#include "kernels/spline_value.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace proxima {

class Spline {
public:
    using Point = std::array<double, 5>;

    SplineKind kind = SplineKind::linear;
    int terms = 0; ///< of each point, 2 to 5
    /// Where the motion graph keeps the table; nowhere until a call follows from the time.
    mutable std::optional<uint64_t> kept_at;

    /// Puts a point in its place. False when there is one at this time already.
    bool add(double time, const Point& point);
    /// To be called when all points are there.
    void complete();
    /// Whether there are points enough for this kind, and one at least.
    bool suits(SplineKind kind) const { return kind == SplineKind::cubic ? times_.size() != 2 : !times_.empty(); }
    size_t size() const { return times_.size(); }

    Point at(double time) const { return at(time, kind); }
    Point at(double time, SplineKind kind) const;

    /// The times, and behind them what SplineTerm needs of each term.
    std::span<const double> table() const { return table_; }
    /// Where a term stands in the table.
    uint64_t place_of(int term) const {
        return times_.size() + uint64_t(term) * (SplineTerm::header + 2 * times_.size());
    }

private:
    void bend(double* curvatures, const SplineTerm& term) const;

    std::vector<double> times_; ///< rising
    std::vector<Point> points_;
    std::vector<double> table_;
};

} // namespace proxima
