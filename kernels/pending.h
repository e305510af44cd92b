// SPDX-License-Identifier: Apache-2.0
// Paths that wait for their turn: each thread has a stack in device memory, as deep as the scene can need. The stacks
// are interleaved, so that neighbouring threads touch neighbouring memory.
#pragma once
#include "kernels/interiors.h"

namespace proxima {

/// A ray on its way from the eye, and what its light counts for.
template <class Real, class Path> struct PathState {
    SourcedRay<Path> ray;
    Hit<Real> passed; ///< the last surface that the ray crossed without bending
    Vec3<Real> throughput{Real(1)};
    Real weight = Real(1);               ///< POV-Ray's measure of importance; the path ends below adc_bailout
    Real exponent = Real(1);             ///< the light of the path counts as light^exponent
    uint32_t level = 0;                  ///< reflections and refractions so far
    uint32_t hidden = material_no_image; ///< the materials that the ray does not see, when the scene has such
    uint32_t interior_count = 0;         ///< while it waits
};

/// One thread's stack. A mark is an entry that stands for a sum to come back to (see Tracer::begin).
template <class Real, class Path> struct PendingView {
    static constexpr uint32_t mark_level = 0xffffffffu;

    std::span<PathState<Real, Path>> states; ///< entry e of thread i stands at e * threads + i
    std::span<uint32_t> interiors;           ///< `interior_capacity` numbers an entry, in the same order
    std::span<uint32_t> overflows;           ///< one counter: rays inside too many primitives
    uint32_t interior_capacity = 0;
    uint32_t threads = 0;
    uint32_t thread = 0;
    uint32_t depth = 0;

    HD uint32_t& interior(uint32_t entry, uint32_t i) const {
        return interiors[(uint64_t(entry) * interior_capacity + i) * threads + thread];
    }
    HD PathState<Real, Path>& state(uint32_t entry) const { return states[uint64_t(entry) * threads + thread]; }

    HD void push(const PathState<Real, Path>& path, const InteriorList& list) {
        for (uint32_t i = 0; i < list.count; ++i)
            interior(depth, i) = list.ids[i];
        PathState<Real, Path>& entry = state(depth++);
        entry = path;
        entry.interior_count = list.count;
    }
    HD void push_mark(const Vec3<Real>& sum, const Vec3<Real>& factor, Real exponent) {
        PathState<Real, Path>& entry = state(depth++);
        entry.level = mark_level;
        entry.ray.ray.origin = Vec3<Path>(sum);
        entry.throughput = factor;
        entry.exponent = exponent;
    }
    HD PathState<Real, Path> pop(InteriorList& list) {
        const PathState<Real, Path> path = state(--depth);
        if (path.level != mark_level) {
            list.count = path.interior_count;
            for (uint32_t i = 0; i < list.count; ++i)
                list.ids[i] = interior(depth, i);
        }
        return path;
    }
};

} // namespace proxima
