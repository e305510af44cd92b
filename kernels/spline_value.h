// SPDX-License-Identifier: Apache-2.0
// What splines give at a time, of the four kinds of POV-Ray 3.7. Before the first point and behind the last one a curve
// stands still. The parser and motion programs both compute with this.
#pragma once
#include "kernels/vector_math.h"

#include <cstdint>
#include <span>

namespace proxima {

enum class SplineKind : uint8_t {
    linear,
    quadratic, ///< the parabola through the two points around and the one before them
    cubic,     ///< Hermite's cubic, as steep at each point as the lines to its neighbours are in the mean
    natural,   ///< the cubic whose curvature is continuous, and 0 at both ends
};

/// One term of a spline. It stands in a table of numbers: the count of points, how far before these two their times
/// begin, the term's values at the points, and its second derivatives there (of the natural spline).
struct SplineTerm {
    const double* times; ///< rising
    const double* values;
    const double* curvatures;
    uint32_t count;

    static constexpr uint32_t header = 2;

    HD SplineTerm(std::span<const double> table, uint64_t place)
        : times(table.data() + place - uint64_t(table[place + 1])), values(table.data() + place + header),
          curvatures(values + uint32_t(table[place])), count(uint32_t(table[place])) {}

    /// `kind` must suit the count of points. A time that is not finite gives one of the points.
    HD double at(double time, SplineKind kind) const {
        // POV-Ray's cubic has no slope at its ends and stands still on the first and last segments.
        const uint32_t first = kind == SplineKind::cubic && count > 2 ? 1 : 0;
        const uint32_t last = count - 1 - first;
        if (!(time > times[first]))
            return values[first];
        if (time >= times[last])
            return values[last];
        uint32_t segment = first; // the last one that begins at or before the time
        for (uint32_t end = last; end - segment > 1;) {
            const uint32_t middle = (segment + end) / 2;
            (times[middle] <= time ? segment : end) = middle;
        }
        switch (kind) {
        case SplineKind::quadratic:
            return count > 2 ? on_parabola(segment, time) : on_line(segment, time);
        case SplineKind::cubic:
            return on_hermite_cubic(segment, time);
        case SplineKind::natural:
            return on_natural_cubic(segment, time);
        default:
            return on_line(segment, time);
        }
    }

    HD double length(uint32_t segment) const { return times[segment + 1] - times[segment]; }
    HD double slope(uint32_t segment) const { return (values[segment + 1] - values[segment]) / length(segment); }

private:
    HD double on_line(uint32_t segment, double time) const {
        const double part = (time - times[segment]) / length(segment);
        return (1 - part) * values[segment] + part * values[segment + 1];
    }

    /// Lagrange's form.
    HD double on_parabola(uint32_t segment, double time) const {
        const uint32_t first = segment > 0 ? segment - 1 : 0;
        double result = 0;
        for (uint32_t i = first; i < first + 3; ++i) {
            double weight = 1;
            for (uint32_t j = first; j < first + 3; ++j)
                if (j != i)
                    weight *= (time - times[j]) / (times[i] - times[j]);
            result += weight * values[i];
        }
        return result;
    }

    HD double on_hermite_cubic(uint32_t segment, double time) const {
        const double h = length(segment), u = (time - times[segment]) / h;
        const double square = u * u, cube = square * u, here = slope(segment);
        const double start = (slope(segment - 1) + here) / 2, end = (here + slope(segment + 1)) / 2;
        return (2 * cube - 3 * square + 1) * values[segment] + (3 * square - 2 * cube) * values[segment + 1] +
               h * ((cube - 2 * square + u) * start + (cube - square) * end);
    }

    HD double on_natural_cubic(uint32_t segment, double time) const {
        const double h = length(segment);
        const double a = (times[segment + 1] - time) / h, b = (time - times[segment]) / h;
        return a * values[segment] + b * values[segment + 1] +
               ((a * a * a - a) * h * h / 6 * curvatures[segment] +
                (b * b * b - b) * h * h / 6 * curvatures[segment + 1]);
    }
};

} // namespace proxima
