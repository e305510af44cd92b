// SPDX-License-Identifier: Apache-2.0
// The teapot in a stadium: a dense small cluster in a huge sparse scene gets the whole grid, if there are few others.
#pragma once
#include "kernels/outliers.h"

namespace proxima {

/// The bounds of all primitives come in, with how many they are; those without outliers go out, and the geometry knows
/// which are outliers. `mean_size` is a typical radius. Whether it is worth to look is told by the room that the
/// primitives leave; the bounds are then drawn in around the mean of all places again and again. It is worth to test a
/// few hundred primitives by every ray where the rest gets a grid that is thousands of times finer. The rule looks at
/// nothing but the scene.
struct OutlierRule {
    static constexpr double looks_full = 1e-5; ///< primitives times the cubes of their size, over the bounds' volume
    static constexpr uint32_t most = 512;      ///< outliers, with those that are too large
    static constexpr double most_share = 1e-3; ///< of the primitives
    static constexpr double deviations = 6;    ///< in a box, no place is more than 1.8 of them from the mean
    static constexpr double worth = 4096;      ///< times smaller a volume
    static constexpr int rounds = 8;

    template <class Backend, class Real>
    static void apply(Backend& backend, GeometryView<Real>& geometry, BoundsTotal<Real>& total, double mean_size) {
        const BoundsTotal<Real> all = total;
        const double solid = mean_size * mean_size * mean_size * double(all.bounded);
        if (!(solid < looks_full * volume(all.box, mean_size)))
            return;
        const uint32_t count = geometry.round_count();
        for (int round = 0; round < rounds; ++round) {
            GeometryView<Real> nearer = geometry;
            const auto spread = backend.template reduce<SpreadTotal>(count, MeasureSpread<Real>{geometry, total.box});
            nearer.core = core_of(spread, total.box, deviations);
            const auto rest = backend.template reduce<BoundsTotal<Real>>(count, MeasureBounds<Real>{nearer});
            if (rest.large > most || rest.large > most_share * all.bounded || rest.large == total.large)
                break;
            geometry.core = nearer.core;
            total = rest;
        }
        if (volume(total.box, mean_size) * worth > volume(all.box, mean_size)) {
            geometry.core = GeometryView<Real>{}.core;
            total = all;
        }
    }

private:
    /// A flat box has the thickness of a primitive.
    template <class Real> static double volume(const Box<Real>& box, double mean_size) {
        double volume = 1;
        for (int i = 0; i < 3; ++i)
            volume *= std::max(double(box.upper[i] - box.lower[i]), mean_size);
        return volume;
    }
};

} // namespace proxima
