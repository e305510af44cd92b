// SPDX-License-Identifier: Apache-2.0
// A few primitives far from all others: where the others lie. The mean and the spread of places go out, in integers so
// that every order of summation agrees.
#pragma once
#include "kernels/grid_build.h"

namespace proxima {

/// Of the centres of bounded primitives, in 2^16 parts of a box along each axis.
struct SpreadTotal {
    static constexpr uint32_t parts = 1 << 16;

    uint64_t count = 0;
    uint64_t sum[3]{}, squares[3]{};

    HD static SpreadTotal combine(const SpreadTotal& a, const SpreadTotal& b) {
        SpreadTotal total{a.count + b.count, {}, {}};
        for (int i = 0; i < 3; ++i) {
            total.sum[i] = a.sum[i] + b.sum[i];
            total.squares[i] = a.squares[i] + b.squares[i];
        }
        return total;
    }
};

/// Primitive -> its part of the SpreadTotal.
template <class Real> struct MeasureSpread {
    GeometryView<Real> geometry;
    Box<Real> box; ///< of the bounded primitives

    HD SpreadTotal operator()(uint32_t id) const {
        if (!geometry.is_bounded(id))
            return {};
        SpreadTotal total{1, {}, {}};
        const Vec3<Real> center = geometry.center(id);
        for (int i = 0; i < 3; ++i) {
            const Real width = box.upper[i] - box.lower[i];
            const Real part = width > 0 ? (center[i] - box.lower[i]) / width * Real(SpreadTotal::parts) : Real(0);
            total.sum[i] = uint64_t(clamped(part, Real(0), Real(SpreadTotal::parts - 1)));
            total.squares[i] = total.sum[i] * total.sum[i];
        }
        return total;
    }
};

/// Where most centres are: `times` their standard deviation around their mean, and a part more for the rounding.
template <class Real> Box<Real> core_of(const SpreadTotal& spread, const Box<Real>& box, double times) {
    Box<Real> core;
    for (int i = 0; i < 3; ++i) {
        const double mean = double(spread.sum[i]) / double(spread.count);
        const double variance = double(spread.squares[i]) / double(spread.count) - mean * mean;
        const double reach = times * std::sqrt(larger(variance, 0.0)) + 1;
        const double part = double(box.upper[i] - box.lower[i]) / SpreadTotal::parts;
        core.lower[i] = Real(double(box.lower[i]) + (mean - reach) * part);
        core.upper[i] = Real(double(box.lower[i]) + (mean + 1 + reach) * part);
    }
    return core;
}

} // namespace proxima
