// SPDX-License-Identifier: Apache-2.0
// The way of a ray through a grid: voxel by voxel (3DDDA: Fujimoto, Tanaka and Iwata, "ARTS: Accelerated Ray-Tracing
// System", 1986), and over empty space in leaps where a cloud says how far. A leap by the distance 1 is a step.
#pragma once
#include "kernels/hit.h"

namespace proxima {

/// Where a ray stands. Voxel planes are recomputed from integers, never accumulated, so that the error does not grow
/// with the number of steps; after a leap the ray's place is computed anew and never falls behind its voxel.
template <class Real> struct GridWalk {
    const GridView<Real>& grid;
    Vec3<Real> origin; ///< in voxels
    Vec3<Real> speed;  ///< voxels per unit of distance
    Vec3<Real> inverse;
    Vec3<Real> next; ///< distance to the plane through which the ray leaves its voxel along an axis
    Vec3<int32_t> cell;
    Real now = Real(0); ///< distance at which it entered its voxel

    HD GridWalk(const GridView<Real>& grid, const Ray<Real>& ray)
        : grid(grid), origin((ray.origin - grid.lower) * grid.inverse_voxel),
          speed(ray.direction * grid.inverse_voxel) {
        for (int i = 0; i < 3; ++i) {
            inverse[i] = Real(1) / speed[i];
            cell[i] = int32_t(clamped(origin[i], Real(0), Real(grid.size[i] - 1)));
            next[i] = leaving(i);
        }
    }

    HD_INNER bool upwards(int i) const { return !(speed[i] < 0); }
    HD_INNER Real distance_to_plane(int i, int32_t plane) const {
        return speed[i] == 0 ? infinity<Real> : (Real(plane) - origin[i]) * inverse[i];
    }
    HD_INNER Real leaving(int i) const { return distance_to_plane(i, upwards(i) ? cell[i] + 1 : cell[i]); }
    HD_INNER Real leave() const { return smaller(smaller(next.x, next.y), next.z); }
    HD_INNER uint32_t octant() const {
        return uint32_t(upwards(0)) | uint32_t(upwards(1)) << 1 | uint32_t(upwards(2)) << 2;
    }

    /// Into the neighbour; false at the end of the grid.
    HD_INNER bool step_along(int i) {
        cell[i] += upwards(i) ? 1 : -1;
        now = next[i];
        next[i] = leaving(i);
        return uint32_t(cell[i]) < uint32_t(grid.size[i]);
    }
    HD_INNER bool step() {
        const Real first = leave();
        return first == next.x ? step_along(0) : first == next.y ? step_along(1) : step_along(2);
    }

    /// Over the brick that the ray is in and all that are less than `distance` bricks away.
    HD bool leave_block(int32_t distance) {
        const CloudView& cloud = grid.cloud;
        Vec3<int32_t> plane;
        for (int i = 0; i < 3; ++i) {
            const int32_t brick = cell[i] >> cloud.shift;
            plane[i] = (upwards(i) ? brick + distance : brick - distance + 1) * (1 << cloud.shift);
            next[i] = distance_to_plane(i, plane[i]);
        }
        now = leave();
        const int exit = now == next.x ? 0 : now == next.y ? 1 : 2;
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            if (i == exit)
                cell[i] = upwards(i) ? plane[i] : plane[i] - 1;
            else
                cell[i] = upwards(i) ? reached(i, cell[i], plane[i] - 1) : reached(i, plane[i], cell[i]);
            inside &= uint32_t(cell[i]) < uint32_t(grid.size[i]);
            next[i] = leaving(i);
        }
        return inside;
    }

    /// To the distance `to`, which lies past the voxel.
    HD bool go_to(Real to) {
        now = to;
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            cell[i] = upwards(i) ? reached(i, cell[i], grid.size[i]) : reached(i, -1, cell[i]);
            inside &= uint32_t(cell[i]) < uint32_t(grid.size[i]);
            next[i] = leaving(i);
        }
        return inside;
    }

    /// Over empty space by what the cloud says of the ray's brick, which is `distance` from an occupied one.
    HD bool leap(int32_t distance) {
        const Metric metric = grid.cloud.metric;
        if (metric == Metric::chessboard || metric == Metric::octant)
            return leave_block(distance);
        const Vec3<Real> bricks = speed / Real(1 << grid.cloud.shift);
        const Real pace = metric == Metric::euclidean ? glm::length(bricks)
                                                      : magnitude(bricks.x) + magnitude(bricks.y) + magnitude(bricks.z);
        const Real far = now + Real(distance - 1) / pace;
        return distance > 1 && far > leave() ? go_to(far) : leave_block(1);
    }

private:
    /// The voxel of the ray's place now, between two bounds.
    HD_INNER int32_t reached(int i, int32_t low, int32_t high) const {
        const Real at = clamped(round_down(origin[i] + speed[i] * now), Real(low), Real(high));
        return int32_t(at);
    }
};

template <class Real, class Visitor>
HD_INNER void meet_list(const GridView<Real>& grid, uint32_t slot, Visitor& visitor) {
    const uint32_t end = grid.starts[slot + 1];
    for (uint32_t r = grid.starts[slot]; r < end; ++r)
        visitor.meet(grid.references[r]);
}

/// Where every voxel has a list. In arrays of its own: one place for both loops costs the cloud a third of its speed on
/// an H100, by the registers that the compiler then spills.
template <class Real, class Visitor>
HD void walk_grid(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    const Vec3<Real> origin = (ray.origin - grid.lower) * grid.inverse_voxel; // in voxels
    int32_t cell[3], step[3], last[3];
    const int32_t stride[3] = {1, grid.size.x, grid.size.x * grid.size.y};
    Real inverse[3], next[3];
    for (int i = 0; i < 3; ++i) {
        const Real speed = ray.direction[i] * grid.inverse_voxel[i];
        cell[i] = int32_t(clamped(origin[i], Real(0), Real(grid.size[i] - 1)));
        step[i] = speed < 0 ? -1 : 1;
        last[i] = speed < 0 ? 0 : grid.size[i] - 1;
        inverse[i] = Real(1) / speed;
        next[i] = speed == 0 ? infinity<Real> : (Real(cell[i] + (step[i] > 0)) - origin[i]) * inverse[i];
    }
    uint32_t voxel = grid.index(cell[0], cell[1], cell[2]);
    const auto step_along = [&](int i) {
        if (cell[i] == last[i])
            return false;
        cell[i] += step[i];
        voxel += uint32_t(step[i] * stride[i]);
        next[i] = (Real(cell[i] + (step[i] > 0)) - origin[i]) * inverse[i];
        return true;
    };
    for (bool inside = true; inside;) {
        meet_list(grid, voxel, visitor);
        const Real leave = smaller(smaller(next[0], next[1]), next[2]);
        if (visitor.is_done(leave))
            return;
        inside = leave == next[0] ? step_along(0) : leave == next[1] ? step_along(1) : step_along(2);
    }
}

/// Where empty bricks say how far the ray may leap.
template <class Real, class Visitor>
HD void walk_cloud(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    GridWalk<Real> place(grid, ray);
    const CloudView& cloud = grid.cloud;
    const uint8_t* distances = cloud.distances.data();
    if (cloud.metric == Metric::octant)
        distances += place.octant() * size_t(cloud.brick_count());
    for (bool inside = true; inside;) {
        const uint32_t brick = cloud.brick(place.cell.x, place.cell.y, place.cell.z);
        if (const int32_t distance = distances[brick]; distance > 0) {
            inside = place.leap(distance) && !visitor.is_done(place.now);
            continue;
        }
        meet_list(grid, cloud.ranks[brick] << (3 * cloud.shift) | cloud.place(place.cell.x, place.cell.y, place.cell.z),
                  visitor);
        inside = !visitor.is_done(place.leave()) && place.step();
    }
}

/// Shows a visitor the lists of the voxels along a ray, in order, until it is done.
template <class Real, class Visitor> HD void walk(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    if (grid.cloud.in_use())
        walk_cloud(grid, ray, visitor);
    else
        walk_grid(grid, ray, visitor);
}

} // namespace proxima
