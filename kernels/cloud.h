// SPDX-License-Identifier: Apache-2.0
// A proximity cloud: for each brick of voxels how far away the nearest occupied brick is, so that rays leap over empty
// space (Cohen and Sheffer, "Proximity Clouds - an Acceleration Technique for 3D Grid Traversal", 1994). Kept for each
// octant of directions, it is the idea of directional safe zones (Semwal and Kvarnstrom, "Directional Safe Zones and
// the Dual Extent Algorithms for Efficient Grid Traversal during Ray Tracing", 1997).
#pragma once
#include "kernels/vector_math.h"

#include <span>

namespace proxima {

/// What a distance counts. Chessboard: the larger of the steps along the axes. City-block: their sum. Euclidean: their
/// length. Octant: chessboard, of the bricks ahead of a ray alone.
enum class Metric : uint32_t { chessboard, city_block, euclidean, octant };

/// Distances in bricks, one byte each: 0 is occupied. Of an empty brick, by chessboard and octants, the distance D to
/// the nearest occupied one: all bricks less than D away (and ahead) are empty. By city-block and euclidean, 1 + B,
/// with B the distance, rounded down, between the nearest points of the brick and any that touches an occupied one: a
/// ray may go on by B. Larger ones are 255, which is safe: too short a leap finds the same hits.
struct CloudView {
    Vec3<int32_t> size{0}; ///< in bricks
    int32_t shift = 0;     ///< a brick is 2^shift voxels long
    Metric metric = Metric::chessboard;
    std::span<uint8_t>
        distances{};             ///< of all bricks, eight times over for octants: bit a of the octant: axis a upwards
    std::span<uint32_t> ranks{}; ///< of an occupied brick among the occupied ones, in no order

    HD bool in_use() const { return size.x > 0; }
    HD uint32_t brick_count() const { return uint32_t(size.x) * uint32_t(size.y) * uint32_t(size.z); }
    HD uint32_t map_count() const { return metric == Metric::octant ? 8 : 1; }
    HD uint32_t index(int32_t x, int32_t y, int32_t z) const {
        return uint32_t(x) + uint32_t(size.x) * (uint32_t(y) + uint32_t(size.y) * uint32_t(z));
    }
    HD uint32_t brick(int32_t x, int32_t y, int32_t z) const { return index(x >> shift, y >> shift, z >> shift); }
    /// Of a voxel within its brick.
    HD uint32_t place(int32_t x, int32_t y, int32_t z) const {
        const int32_t mask = (1 << shift) - 1;
        return uint32_t((x & mask) | (y & mask) << shift | (z & mask) << (2 * shift));
    }
    HD uint32_t slot(int32_t x, int32_t y, int32_t z) const {
        return ranks[brick(x, y, z)] << (3 * shift) | place(x, y, z);
    }
};

} // namespace proxima
