// SPDX-License-Identifier: Apache-2.0
// The teapot in a stadium: a dense small cluster in a huge sparse scene gets a grid of its own; and so do small things
// among large ones, each of which would be in a hundred thousand of their voxels.
#pragma once
#include "kernels/outliers.h"

#include <algorithm>

namespace proxima {

/// The primitives come in, with the bounds of the bounded ones; where most are goes out, if that is a small part of the
/// bounds or some are much larger than most. The bounds are drawn in around the mean of all places again and again. No
/// picture depends on what is found: so it is kept from frame to frame, and looked for again now and then.
template <class Backend, class Real> class OutlierRule {
public:
    static constexpr double most_share = 1.0 / 16; ///< of the primitives, that may be outliers
    static constexpr double deviations = 6;        ///< in a box, no place is more than 1.8 of them from the mean
    static constexpr double worth = 64;            ///< times smaller a volume
    static constexpr double much_larger = 32;      ///< than a typical radius: such ones are outliers wherever they are
    static constexpr uint32_t interval = 63;       ///< frames between two looks

    void forget() {
        frames_left_ = 0;
        total_ = {};
    }

    /// `all`: the bounds of what is bounded. `size`: a typical radius; flat bounds are as thick. `largest`: radius.
    void look(Backend& backend, const GeometryView<Real>& geometry, const BoundsTotal<Real>& all, Real size,
              Real largest) {
        const bool was_found = found();
        has_large_ = double(largest) > much_larger * double(size);
        radius_ = Real(much_larger) * size;
        if (was_found)
            total_ = measure(backend, geometry, core_);
        if (frames_left_ > 0 && (!was_found || holds(all, size))) {
            --frames_left_;
            return;
        }
        frames_left_ = interval;
        core_ = draw_in(backend, geometry, all.box, size);
        total_ = {};
        const bool is_dense = volume(core_, size) * worth < volume(all.box, size);
        if (!is_dense)
            core_ = all.box;
        if (is_dense || has_large_)
            total_ = measure(backend, geometry, core_);
        if (!holds(all, size))
            total_ = {};
    }

    bool found() const { return total_.left_out > 0; }
    /// Where the centres of the core's primitives are.
    const Box<Real>& core() const { return core_; }
    /// The largest of the core.
    Real radius() const { return radius_; }
    /// The bounds of the core's primitives; the outliers are those that are left out.
    const BoundsTotal<Real>& total() const { return total_; }

private:
    /// The smallest box in a row of them, each within the one before.
    static Box<Real> draw_in(Backend& backend, const GeometryView<Real>& geometry, Box<Real> box, Real size) {
        uint64_t fewest = 0;
        for (Box<Real> core = box;;) {
            const MeasureSpread<Real> measure{geometry, core};
            const auto spread = backend.template reduce<SpreadTotal>(measure.item_count(), measure);
            if (spread.count <= fewest)
                return box;
            if (fewest == 0)
                fewest = uint64_t(double(spread.count) * (1 - most_share));
            box = core;
            core = core_of(spread, box, deviations);
            if (!(volume(core, size) < 0.75 * volume(box, size)))
                return box;
        }
    }
    BoundsTotal<Real> measure(Backend& backend, const GeometryView<Real>& geometry, const Box<Real>& core) const {
        return backend.template reduce<BoundsTotal<Real>>(geometry.round_count(),
                                                          MeasureCore<Real>{geometry, core, radius_});
    }
    bool holds(const BoundsTotal<Real>& all, Real size) const {
        return total_.bounded > 0 && total_.left_out > 0 && total_.left_out <= most_share * all.bounded &&
               (has_large_ || volume(total_.box, size) * worth < volume(all.box, size));
    }
    static double volume(const Box<Real>& box, Real size) {
        double volume = 1;
        for (int i = 0; i < 3; ++i)
            volume *= std::max(double(box.upper[i]) - double(box.lower[i]), double(size));
        return volume;
    }

    Box<Real> core_;
    Real radius_ = infinity<Real>;
    bool has_large_ = false;  ///< some are much larger than most
    BoundsTotal<Real> total_; ///< nothing left out: not found
    uint32_t frames_left_ = 0;
};

} // namespace proxima
