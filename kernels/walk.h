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
    Vec3<int32_t> cell;
    Real now = Real(0); ///< distance at which it entered its voxel

    HD GridWalk(const GridView<Real>& grid, const Ray<Real>& ray)
        : grid(grid), origin((ray.origin - grid.lower) * grid.inverse_voxel),
          speed(ray.direction * grid.inverse_voxel) {
        for (int i = 0; i < 3; ++i) {
            inverse[i] = Real(1) / speed[i];
            cell[i] = int32_t(clamped(origin[i], Real(0), Real(grid.size[i] - 1)));
        }
    }

    HD_INNER bool upwards(int i) const { return !(speed[i] < 0); }
    HD_INNER uint32_t octant() const {
        return uint32_t(upwards(0)) | uint32_t(upwards(1)) << 1 | uint32_t(upwards(2)) << 2;
    }

    /// Over the block of 2^shift voxels a side that the ray is in and all blocks less than `distance` away: by (0, 1)
    /// into the next voxel. False at the end of the grid.
    HD_INNER bool leave_block(int32_t shift, int32_t distance) {
        int32_t plane[3];
        Real at[3];
        for (int i = 0; i < 3; ++i) {
            plane[i] = ((cell[i] >> shift) + (upwards(i) ? distance : 1 - distance)) << shift;
            at[i] = speed[i] == 0 ? infinity<Real> : (Real(plane[i]) - origin[i]) * inverse[i];
        }
        now = smaller(smaller(at[0], at[1]), at[2]);
        const bool exits[3] = {now == at[0], now != at[0] && now == at[1], now != at[0] && now != at[1]};
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            const int32_t next = upwards(i) ? plane[i] : plane[i] - 1; // the first voxel behind the plane
            const int32_t low = upwards(i) ? cell[i] : next + 1, high = upwards(i) ? next - 1 : cell[i];
            cell[i] = exits[i] ? next : reached(i, low, high);
            inside = inside && uint32_t(cell[i]) < uint32_t(grid.size[i]);
        }
        return inside;
    }

    /// Over empty space by a distance that does not count along the axes alone.
    HD bool leap_by_length(int32_t distance) {
        const Vec3<Real> bricks = speed / Real(1 << grid.cloud.shift);
        const Real pace = grid.cloud.metric == Metric::euclidean
                              ? glm::length(bricks)
                              : magnitude(bricks.x) + magnitude(bricks.y) + magnitude(bricks.z);
        const Real before = now;
        const Vec3<int32_t> from = cell;
        const bool inside = leave_block(grid.cloud.shift, 1);
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
        return int32_t(clamped(round_down(origin[i] + speed[i] * now), Real(low), Real(high)));
    }
};

/// What the lists of a grid hold. Kernels for scenes of spheres alone need not ask each primitive what it is.
enum class RoundShapes { spheres, all };

/// Shows a visitor the primitive of a link and goes to the next; true when the visitor has seen enough.
template <RoundShapes shapes, class Real, class Visitor>
HD_INNER bool meet_link(const GridView<Real>& grid, uint32_t& link, Visitor& visitor) {
    const GridLink current = grid.links[link];
    link = current.next;
    return shapes == RoundShapes::spheres ? visitor.meet_sphere(current.primitive) : visitor.meet(current.primitive);
}

/// Where every voxel has a list. Each turn of the loop meets one primitive, after a step where a list has ended: the
/// threads of a warp, whose lists are not equally long, then wait for each other least. In arrays of its own: one place
/// for both loops costs the cloud a third of its speed on an H100, by the registers that the compiler then spills.
template <RoundShapes shapes, class Real, class Visitor>
HD void walk_grid(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    const Vec3<Real> origin = (ray.origin - grid.lower) * grid.inverse_voxel; // in voxels
    const int32_t stride[3] = {1, grid.size.x, grid.size.x * grid.size.y};
    Real inverse[3], plane[3]; // planes are whole numbers: those through which the ray leaves its voxel
    uint32_t voxel = 0;
    for (int i = 0; i < 3; ++i) {
        const int32_t cell = int32_t(clamped(origin[i], Real(0), Real(grid.size[i] - 1)));
        inverse[i] = Real(1) / (ray.direction[i] * grid.inverse_voxel[i]);
        const bool stands = magnitude(inverse[i]) == infinity<Real>;
        inverse[i] = stands ? infinity<Real> : inverse[i];
        plane[i] = stands ? infinity<Real> : Real(cell + (inverse[i] > 0));
        voxel += uint32_t(cell * stride[i]);
    }
    uint32_t link = grid.heads[voxel];
    for (;;) {
        if (link == no_link) {
            const Real x = (plane[0] - origin.x) * inverse[0];
            const Real y = (plane[1] - origin.y) * inverse[1];
            const Real z = (plane[2] - origin.z) * inverse[2];
            const Real leave = smaller(smaller(x, y), z);
            if (visitor.is_done(leave))
                return;
            // Without branches, which threads that go different ways would take one after the other.
            const bool along_x = leave == x, along_y = !along_x && leave == y, along_z = !along_x && !along_y;
            const bool upwards = (along_x ? inverse[0] : along_y ? inverse[1] : inverse[2]) > 0;
            const Real last = along_x ? grid.end.x : along_y ? grid.end.y : grid.end.z;
            if ((along_x ? plane[0] : along_y ? plane[1] : plane[2]) == (upwards ? last : Real(0)))
                return;
            const Real step = upwards ? Real(1) : Real(-1);
            plane[0] += along_x ? step : Real(0);
            plane[1] += along_y ? step : Real(0);
            plane[2] += along_z ? step : Real(0);
            const int32_t way = along_x ? stride[0] : along_y ? stride[1] : stride[2];
            voxel += uint32_t(upwards ? way : -way);
            link = grid.heads[voxel];
        }
        if (link != no_link && meet_link<shapes>(grid, link, visitor))
            return;
    }
}

/// What a metric's distances count: bricks along the axes, or the length of the way.
enum class LeapKind { by_blocks, by_length };

/// Where empty bricks say how far the ray may leap.
template <RoundShapes shapes, LeapKind leap, class Real, class Visitor>
HD void walk_cloud(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    GridWalk<Real> place(grid, ray);
    const CloudView& cloud = grid.cloud;
    const uint8_t* distances = cloud.distances.data();
    if (cloud.metric == Metric::octant)
        distances += place.octant() * size_t(cloud.brick_count());
    uint32_t link = no_link;
    int32_t distance = 0; // of the brick: 0 where it is occupied
    for (bool inside = true; inside;) {
        const uint32_t brick = cloud.brick(place.cell.x, place.cell.y, place.cell.z);
        distance = distances[brick];
        if (distance == 0)
            link = grid.heads[cloud.ranks[brick] << (3 * cloud.shift) |
                              cloud.place(place.cell.x, place.cell.y, place.cell.z)];
        while (link != no_link)
            if (meet_link<shapes>(grid, link, visitor))
                return;
        // One piece of code for steps and leaps: threads of a warp do either at the same time.
        if (leap == LeapKind::by_length && distance > 0)
            inside = place.leap_by_length(distance);
        else
            inside = place.leave_block(distance > 0 ? cloud.shift : 0, larger(distance, 1));
        inside = inside && !visitor.is_done(place.now);
    }
}

/// Shows a visitor the lists of the voxels along a ray, in order, until it is done.
template <RoundShapes shapes, class Real, class Visitor>
HD void walk(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    if (!grid.cloud.in_use())
        return walk_grid<shapes>(grid, ray, visitor);
    if (grid.cloud.metric == Metric::city_block || grid.cloud.metric == Metric::euclidean)
        return walk_cloud<shapes, LeapKind::by_length>(grid, ray, visitor);
    walk_cloud<shapes, LeapKind::by_blocks>(grid, ray, visitor);
}

} // namespace proxima
