// SPDX-License-Identifier: Apache-2.0
// What a grid is to be like, and where it lies. A plan and bounds in, a grid without lists out.
#pragma once
#include "kernels/grid.h"
#include "renderer/grid_resolution.h"

#include <bit>

namespace proxima {

/// What a grid is to be like.
struct GridPlan {
    std::array<uint32_t, 3> size{0, 0, 0}; ///< voxels along each axis; 0: by voxels_per_primitive
    double voxels_per_primitive = GridRule{}.voxels_per_primitive;
    uint32_t brick = 0; ///< voxels along a brick of the cloud, a power of two; 0: no cloud
    Metric metric = Metric::chessboard;
};

/// Wide enough for all rounding of boxes, entry points and walks; a flat scene gets some thickness.
template <class Real> Real pad_of(const Box<Real>& box) {
    const Real epsilon = std::numeric_limits<Real>::epsilon();
    Real reach = 0;
    for (int i = 0; i < 3; ++i)
        reach = larger(reach, larger(magnitude(box.lower[i]), magnitude(box.upper[i])));
    return max_component(box.upper - box.lower) * Real(64) * epsilon + reach * Real(16) * epsilon;
}
template <class Real> Box<Real> padded(const Box<Real>& box, Real pad) {
    return {box.lower - Vec3<Real>(pad), box.upper + Vec3<Real>(pad)};
}

/// The voxels along each axis of a grid for `count` primitives, at most `most_voxels` in all.
template <class Real>
std::array<uint32_t, 3> planned_voxels(const Box<Real>& bounds, uint32_t count, const GridPlan& plan,
                                       uint64_t most_voxels) {
    const Vec3<double> extent(bounds.upper - bounds.lower);
    GridRule rule;
    rule.voxels_per_primitive = plan.voxels_per_primitive;
    rule.most_voxels = most_voxels;
    std::array<uint32_t, 3> voxels = grid_resolution({extent.x, extent.y, extent.z}, count, rule);
    for (int i = 0; i < 3; ++i)
        if (plan.size[i] > 0)
            voxels[i] = std::min(plan.size[i], uint32_t(rule.longest));
    while (uint64_t(voxels[0]) * voxels[1] * voxels[2] > rule.most_voxels) // a size that was asked for
        for (uint32_t& n : voxels)
            n = std::max(1u, uint32_t(n * 0.8));
    return voxels;
}

/// The grid over the bounds; with bricks, as many whole ones as hold the voxels that were asked for.
template <class Real>
GridView<Real> grid_over(const Box<Real>& bounds, std::array<uint32_t, 3> voxels, uint32_t brick) {
    Vec3<int32_t> bricks;
    for (int i = 0; i < 3 && brick > 0; ++i) {
        bricks[i] = int32_t((voxels[i] + brick - 1) / brick);
        voxels[i] = uint32_t(bricks[i]) * brick;
    }
    GridView<Real> grid = make_grid(bounds, Vec3<int32_t>(voxels[0], voxels[1], voxels[2]));
    if (brick > 0)
        grid.cloud = {.size = bricks, .shift = std::countr_zero(brick)};
    return grid;
}

} // namespace proxima
