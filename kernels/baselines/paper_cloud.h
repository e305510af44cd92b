// SPDX-License-Identifier: Apache-2.0
// A baseline for experiments, not the renderer's cloud: distances by one thread for each pair of a voxel and a voxel
// that is not empty (R. Thomas and S. K. Semwal, "Ray Tracing using 3D Grid Simulations", 2014). The work grows with
// the product of the two; kernels/cloud_build.h has the passes whose work grows with the voxels alone.
#pragma once
#include "kernels/baselines/paper_grid.h"

namespace proxima::baselines {

/// Voxel -> it is on the second list if it is not empty; its own distance is then 0, else as far as a map can say.
struct ListFilledVoxels {
    PaperGridView paper;
    std::span<uint32_t> filled; ///< in no order
    std::span<uint32_t> count;  ///< one number, 0 at the start
    std::span<uint32_t> distances;

    HD void operator()(uint32_t voxel) const {
        const bool is_filled = paper.is_filled(voxel);
        distances[voxel] = is_filled ? 0 : 255;
        if (is_filled)
            filled[atomic_add(count.data(), 1)] = voxel;
    }
};

/// The distance of two voxels as a CloudView of one voxel a brick counts it; chessboard and city-block.
HD inline uint32_t pair_distance(Metric metric, const Vec3<int32_t>& from, const Vec3<int32_t>& to) {
    uint32_t largest = 0, gaps = 0;
    for (int i = 0; i < 3; ++i) {
        const int32_t steps = from[i] < to[i] ? to[i] - from[i] : from[i] - to[i];
        largest = larger(largest, uint32_t(steps));
        gaps += uint32_t(larger(steps - 1, 0)); // between the nearest sides: how far a ray may go, from anywhere
    }
    return metric == Metric::city_block ? 1 + gaps : largest;
}

/// Stores the smaller of `value` and what is there, atomically; most pairs find something smaller already.
HD inline void atomic_min(uint32_t* place, uint32_t value) {
    uint32_t there = load_relaxed(place);
    while (value < there) {
        const uint32_t before = atomic_compare_exchange(place, there, value);
        if (before == there)
            return;
        there = before;
    }
}

/// Pair -> the empty voxel's distance is no larger than that to the other one. Index = voxel + voxels * (other -
/// first).
struct MeasurePairs {
    PaperGridView paper;
    Metric metric = Metric::city_block;
    std::span<const uint32_t> filled; ///< from the first of this launch on
    std::span<uint32_t> distances;

    HD void operator()(uint32_t index) const {
        const uint32_t voxels = uint32_t(distances.size());
        const uint32_t voxel = index % voxels;
        if (paper.is_filled(voxel))
            return;
        const uint32_t other = filled[index / voxels];
        atomic_min(&distances[voxel], pair_distance(metric, paper.position(voxel), paper.position(other)));
    }
};

/// Voxel -> its distance as a byte of the map.
struct NarrowDistances {
    std::span<const uint32_t> distances;
    std::span<uint8_t> map;

    HD void operator()(uint32_t voxel) const { map[voxel] = uint8_t(distances[voxel]); }
};

} // namespace proxima::baselines
