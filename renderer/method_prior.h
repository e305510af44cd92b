// SPDX-License-Identifier: Apache-2.0
// What a look between the things of a scene says of a frame by grid and of one by cloud, before there is either. Counts
// of bricks in, the work that is likely and what it takes out.
#pragma once
#include "renderer/method_costs.h"

#include <algorithm>
#include <cmath>

namespace proxima {

/// The work of frames with `rays` rays of the camera. A ray along an axis has 4 lookups in an occupied brick of the
/// cloud and one a leap, and 4^(1/3) in a brick's place in the grid, where there are 4 voxels to a brick. How far rays
/// go, and how many voxels a primitive overlaps, is fitted to counts of the scenes that the devices' costs are fitted
/// to.
inline OfMethods<MethodWork> likely_work(const EmptySpace& space, double rays) {
    const double n = double(space.primitives), occupied = space.occupied(), empty = 1 - occupied;
    const double fullness = std::clamp((occupied - 0.9) / 0.1, 0.0, 1.0); // bricks of points are 0.87 full
    const double way = std::min(0.5, 0.09 + 10 * empty);                  // of the grid's voxels along an axis
    OfMethods<MethodWork> work;
    work.grid = {.primitives = n,
                 .references = n * (1.6 + 3 * fullness * fullness),
                 .voxels = 2 * n,
                 .rays = rays,
                 .lookups = way * std::cbrt(2 * n)};
    const double leaps = empty / std::max(1.0, space.mean_distance);
    work.cloud = {.primitives = n,
                  .references = n * (2.6 + 15 * fullness * fullness),
                  .voxels = 64.0 * double(space.bricks - space.empty),
                  .bricks = double(space.bricks),
                  .rays = rays,
                  .lookups = work.grid.lookups * (4 * occupied + 1.1 * leaps) / std::cbrt(4.0)};
    return work;
}

/// Milliseconds of build, map and trace.
inline OfMethods<double> predicted_ms(const DeviceCosts& costs, const EmptySpace& space, double rays) {
    const OfMethods<MethodWork> work = likely_work(space, rays);
    return {costs.of.grid.frame(work.grid), costs.of.cloud.frame(work.cloud)};
}

} // namespace proxima
