// SPDX-License-Identifier: Apache-2.0
// Where a ray stands in a grid, and how it gets on: over a voxel, or over a block of them that is empty.
#pragma once
#include "kernels/hit.h"

namespace proxima {

/// Whole numbers below 2^22 to numbers and, rounded down, back. A device converts at a quarter of its pace, or less,
/// but adds at full: 1.5 * 2^23 has its units in its last bits.
template <class Real> HD_INNER Real number(int32_t whole) {
#if defined(__CUDA_ARCH__)
    if constexpr (sizeof(Real) == sizeof(float))
        return __int_as_float(0x4b400000 + whole) - 12582912.0f;
#endif
    return Real(whole);
}
template <class Real> HD_INNER int32_t whole_below(Real number) {
#if defined(__CUDA_ARCH__)
    if constexpr (sizeof(Real) == sizeof(float))
        return __float_as_int(__fadd_rd(number, 12582912.0f)) - 0x4b400000;
#endif
    return int32_t(round_down(number));
}

/// Along one axis, when a ray crosses a voxel plane: a multiple of the plane, and that of 0. An axis that the ray does
/// not move along is crossed at infinity.
template <class Real> struct Crossing {
    Real pace;
    Real start;

    HD Crossing(Real origin, Real pace_along) : pace(pace_along) {
        start = -origin * pace;
        const bool moves = magnitude(pace) < infinity<Real> && magnitude(start) < infinity<Real>; // both may overflow
        pace = moves ? pace : Real(0);
        start = moves ? start : infinity<Real>;
    }
    /// From one plane to the next.
    HD_INNER Real step() const { return std::copysign(Real(1), pace); }
    HD_INNER Real at(Real plane) const { return plane * pace + start; }
};

/// The voxel in which a ray's way begins, `start` from its origin. Both in voxels.
template <class Real>
HD Vec3<int32_t> first_cell(const GridView<Real>& grid, const Vec3<Real>& origin, const Vec3<Real>& speed, Real start) {
    Vec3<int32_t> cell;
    for (int i = 0; i < 3; ++i) {
        const Real place = start > 0 ? origin[i] + start * speed[i] : origin[i];
        cell[i] = int32_t(clamped(place, Real(0), Real(grid.size[i] - 1)));
    }
    return cell;
}

/// Where a ray stands. Voxel planes are recomputed from integers, never accumulated, so that the error does not grow
/// with the number of steps; after a leap the ray's place is computed anew and never falls behind its voxel.
template <class Real> struct GridWalk {
    Vec3<Real> origin; ///< in voxels
    Vec3<Real> speed;  ///< voxels per unit of distance
    Crossing<Real> crossings[3];
    Vec3<int32_t> cell;
    Real now; ///< distance at which it entered its voxel

    HD GridWalk(const GridView<Real>& grid, const Ray<Real>& ray, Real start)
        : origin((ray.origin - grid.lower) * grid.inverse_voxel),
          speed(ray.direction * grid.inverse_voxel), crossings{{origin.x, Real(1) / speed.x},
                                                               {origin.y, Real(1) / speed.y},
                                                               {origin.z, Real(1) / speed.z}},
          cell(first_cell(grid, origin, speed, start)), now(start) {}

    HD_INNER bool upwards(int i) const { return !(speed[i] < 0); }
    HD_INNER uint32_t octant() const {
        return uint32_t(upwards(0)) | uint32_t(upwards(1)) << 1 | uint32_t(upwards(2)) << 2;
    }

    /// Over the block of 2^shift voxels a side that the ray is in and all blocks less than `distance` away: by (0, 1)
    /// into the next voxel. False at the end of the grid.
    HD_INNER bool leave_block(const GridView<Real>& grid, int32_t shift, int32_t distance) {
        int32_t plane[3];
        Real at[3];
        for (int i = 0; i < 3; ++i) {
            plane[i] = ((cell[i] >> shift) + (upwards(i) ? distance : 1 - distance)) << shift;
            at[i] = crossings[i].at(number<Real>(plane[i]));
        }
        now = lesser(lesser(at[0], at[1]), at[2]);
        const bool exits[3] = {now == at[0], now != at[0] && now == at[1], now != at[0] && now != at[1]};
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            // From its voxel to the last one before the plane; where it leaves the block, the first one behind. Written
            // so that threads which leave by other axes do not wait for each other.
            const int32_t near = exits[i] ? plane[i] - !upwards(i) : cell[i];
            const int32_t far = plane[i] - (upwards(i) != exits[i]);
            cell[i] = reached(i, smaller(near, far), larger(near, far));
            inside = inside && uint32_t(cell[i]) < uint32_t(grid.size[i]);
        }
        return inside;
    }

    /// Over empty space by a distance that does not count along the axes alone.
    HD bool leap_by_length(const GridView<Real>& grid, int32_t distance) {
        const Vec3<Real> bricks = speed / Real(1 << grid.cloud.shift);
        const Real pace = grid.cloud.metric == Metric::euclidean
                              ? glm::length(bricks)
                              : magnitude(bricks.x) + magnitude(bricks.y) + magnitude(bricks.z);
        const Real before = now;
        const Vec3<int32_t> from = cell;
        const bool inside = leave_block(grid, grid.cloud.shift, 1);
        const Real far = before + Real(distance - 1) / pace;
        if (distance < 2 || !(far > now))
            return inside; // a block at a time always gets on
        now = far;
        bool still_inside = true;
        for (int i = 0; i < 3; ++i) {
            cell[i] = upwards(i) ? reached(i, from[i], grid.size[i]) : reached(i, -1, from[i]);
            still_inside = still_inside && uint32_t(cell[i]) < uint32_t(grid.size[i]);
        }
        return still_inside;
    }

private:
    /// The voxel of the ray's place now, between two bounds.
    HD_INNER int32_t reached(int i, int32_t low, int32_t high) const {
        return clamped(whole_below(origin[i] + speed[i] * now), low, high);
    }
};

} // namespace proxima
