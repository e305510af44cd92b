// SPDX-License-Identifier: Apache-2.0
// A few primitives far from all others: where most lie. The mean and the spread of places go out, in integers so that
// every order of summation agrees.
#pragma once
#include "kernels/grid_build.h"

namespace proxima {

/// Of the centres of bounded primitives that are in a box, in 2^16 parts of it along each axis.
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

/// Item -> the part of the SpreadTotal of one primitive; the items are spread over all of them.
template <class Real> struct MeasureSpread {
    static constexpr uint32_t most_items = 1 << 16;

    GeometryView<Real> geometry;
    Box<Real> box;

    HD uint32_t item_count() const { return smaller(geometry.round_count(), most_items); }
    HD SpreadTotal operator()(uint32_t item) const {
        const uint32_t id = uint32_t(uint64_t(item) * geometry.round_count() / item_count());
        const Vec3<Real> center = geometry.center(id);
        if (!geometry.is_bounded(id) || !contains(box, center))
            return {};
        SpreadTotal total{1, {}, {}};
        for (int i = 0; i < 3; ++i) {
            const Real width = box.upper[i] - box.lower[i];
            const Real part = width > 0 ? (center[i] - box.lower[i]) / width * Real(SpreadTotal::parts) : Real(0);
            total.sum[i] = uint64_t(clamped(part, Real(0), Real(SpreadTotal::parts - 1)));
            total.squares[i] = total.sum[i] * total.sum[i];
        }
        return total;
    }
};

/// Where most centres are: `times` their standard deviation around their mean, and a part more for the rounding; within
/// the box that they were measured in.
template <class Real> Box<Real> core_of(const SpreadTotal& spread, const Box<Real>& box, double times) {
    Box<Real> core;
    for (int i = 0; i < 3; ++i) {
        const double mean = double(spread.sum[i]) / double(spread.count);
        const double variance = double(spread.squares[i]) / double(spread.count) - mean * mean;
        const double reach = times * std::sqrt(larger(variance, 0.0)) + 1;
        const double part = (double(box.upper[i]) - double(box.lower[i])) / SpreadTotal::parts;
        core.lower[i] = larger(box.lower[i], Real(double(box.lower[i]) + (mean - reach) * part));
        core.upper[i] = smaller(box.upper[i], Real(double(box.lower[i]) + (mean + 1 + reach) * part));
    }
    return core;
}

/// Primitive -> its part of the BoundsTotal of those bounded ones that have their centres in a box and are not too
/// large; the others are left out.
template <class Real> struct MeasureCore {
    GeometryView<Real> geometry;
    Box<Real> core;
    Real largest;

    HD BoundsTotal<Real> operator()(uint32_t id) const {
        if (!geometry.is_bounded(id))
            return {};
        if (!contains(core, geometry.center(id)) || geometry.radius(id) > largest)
            return {.left_out = 1};
        return {geometry.box(id), 1, 0};
    }
};

} // namespace proxima
