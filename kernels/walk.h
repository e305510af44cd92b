// SPDX-License-Identifier: Apache-2.0
// The way of a ray through a grid: voxel by voxel (3DDDA: Fujimoto, Tanaka and Iwata, "ARTS: Accelerated Ray-Tracing
// System", 1986), and over empty space in leaps where a cloud says how far. A leap by the distance 1 is a step.
#pragma once
#include "kernels/hit.h"

namespace proxima {

/// Where a ray stands. Voxel planes are recomputed from integers, never accumulated, so that the error does not grow
/// with the number of steps; after a leap the ray's place is computed anew and never falls behind its voxel.
template <class Real> struct GridWalk {
    Vec3<Real> origin; ///< in voxels
    Vec3<Real> speed;  ///< voxels per unit of distance
    Vec3<Real> inverse;
    Vec3<int32_t> cell;
    Real now = Real(0); ///< distance at which it entered its voxel

    HD GridWalk(const GridView<Real>& grid, const Ray<Real>& ray)
        : origin((ray.origin - grid.lower) * grid.inverse_voxel), speed(ray.direction * grid.inverse_voxel) {
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
    HD_INNER bool leave_block(const GridView<Real>& grid, int32_t shift, int32_t distance) {
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
        return int32_t(clamped(round_down(origin[i] + speed[i] * now), Real(low), Real(high)));
    }
};

/// What the lists of a grid hold. Kernels for scenes of spheres alone need not ask each primitive what it is.
enum class RoundShapes { spheres, all };

/// Shows a visitor the list of a slot; true when the visitor has seen enough.
template <RoundShapes shapes, class Real, class Visitor>
HD_INNER bool meet_list(const GridView<Real>& grid, uint32_t slot, Visitor& visitor) {
    uint32_t link = grid.heads[slot];
    while (link != no_link) {
        const GridLink current = grid.links[link];
        link = current.next;
        if (shapes == RoundShapes::spheres ? visitor.meet_sphere(current.primitive) : visitor.meet(current.primitive))
            return true;
    }
    return false;
}

/// A ray's way through a grid whose every voxel has a list. Each turn meets one primitive, after a step where a list
/// has ended: the threads of a warp, whose lists are not equally long, then wait for each other least. It keeps its
/// numbers apart from GridWalk's: one place for both costs the cloud a third of its speed on an H100, by the registers.
template <RoundShapes shapes, class Real> class StepWalk {
public:
    HD StepWalk(const GridView<Real>& grid, const Ray<Real>& ray)
        : origin_((ray.origin - grid.lower) * grid.inverse_voxel) {
        const int32_t stride[3] = {1, grid.size.x, grid.size.x * grid.size.y};
        for (int i = 0; i < 3; ++i) {
            const int32_t cell = int32_t(clamped(origin_[i], Real(0), Real(grid.size[i] - 1)));
            const Real inverse = Real(1) / (ray.direction[i] * grid.inverse_voxel[i]);
            const bool stands = magnitude(inverse) == infinity<Real>;
            inverse_[i] = stands ? infinity<Real> : inverse;
            plane_[i] = stands ? infinity<Real> : Real(cell + (inverse > 0));
            voxel_ += uint32_t(cell * stride[i]);
        }
    }

    /// False at the end of the grid, or when the visitor has seen enough.
    template <class Visitor> HD_INNER bool turn(const GridView<Real>& grid, Visitor& visitor) {
        if (meet_list<shapes>(grid, voxel_, visitor))
            return false;
        const Vec3<Real> at = (plane_ - origin_) * inverse_;
        const Real leave = smaller(smaller(at.x, at.y), at.z);
        if (visitor.is_done(leave))
            return false;
        // Without branches, which threads that go different ways would take one after the other.
        const bool along_x = leave == at.x, along_y = !along_x && leave == at.y, along_z = !along_x && !along_y;
        const bool upwards = (along_x ? inverse_.x : along_y ? inverse_.y : inverse_.z) > 0;
        const Real last = along_x ? grid.end.x : along_y ? grid.end.y : grid.end.z;
        const bool inside = (along_x ? plane_.x : along_y ? plane_.y : plane_.z) != (upwards ? last : Real(0));
        const Real step = upwards ? Real(1) : Real(-1);
        plane_.x += along_x ? step : Real(0);
        plane_.y += along_y ? step : Real(0);
        plane_.z += along_z ? step : Real(0);
        const int32_t way = along_x ? 1 : along_y ? grid.size.x : grid.size.x * grid.size.y;
        voxel_ += uint32_t(upwards ? way : -way);
        return inside;
    }

private:
    Vec3<Real> origin_; ///< in voxels
    Vec3<Real> inverse_;
    Vec3<Real> plane_; ///< whole numbers: where the ray leaves its voxel
    uint32_t voxel_ = 0;
};

/// What a metric's distances count: bricks along the axes, or the length of the way.
enum class LeapKind { by_blocks, by_length };

/// The same where empty bricks say how far the ray may leap.
template <RoundShapes shapes, LeapKind leap, class Real> class LeapWalk {
public:
    HD LeapWalk(const GridView<Real>& grid, const Ray<Real>& ray) : place_(grid, ray) {
        if (grid.cloud.metric == Metric::octant)
            map_ = place_.octant() * grid.cloud.brick_count();
    }

    template <class Visitor> HD_INNER bool turn(const GridView<Real>& grid, Visitor& visitor) {
        const CloudView& cloud = grid.cloud;
        const uint32_t brick = cloud.brick(place_.cell.x, place_.cell.y, place_.cell.z);
        const int32_t distance = cloud.distances[size_t(map_) + brick]; // 0 where the brick is occupied
        if (distance == 0) {
            const uint32_t slot =
                cloud.ranks[brick] << (3 * cloud.shift) | cloud.place(place_.cell.x, place_.cell.y, place_.cell.z);
            if (meet_list<shapes>(grid, slot, visitor))
                return false;
        }
        // One piece of code for steps and leaps: threads of a warp do either at the same time.
        const bool inside = leap == LeapKind::by_length && distance > 0
                                ? place_.leap_by_length(grid, distance)
                                : place_.leave_block(grid, distance > 0 ? cloud.shift : 0, larger(distance, 1));
        return inside && !visitor.is_done(place_.now);
    }

private:
    GridWalk<Real> place_;
    uint32_t map_ = 0; ///< where the ray's octant begins
};

/// Shows a visitor the lists of the voxels along a ray, in order, until it is done. Returns how many voxels, and bricks
/// of a cloud, were looked up.
template <class Walk, class Real, class Visitor>
HD uint32_t walk_to_end(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    Walk walk(grid, ray);
    uint32_t turns = 1;
    while (walk.turn(grid, visitor))
        ++turns;
    return turns;
}
template <RoundShapes shapes, class Real, class Visitor>
HD uint32_t walk(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    if (!grid.cloud.in_use())
        return walk_to_end<StepWalk<shapes, Real>>(grid, ray, visitor);
    if (grid.cloud.metric == Metric::city_block || grid.cloud.metric == Metric::euclidean)
        return walk_to_end<LeapWalk<shapes, LeapKind::by_length, Real>>(grid, ray, visitor);
    return walk_to_end<LeapWalk<shapes, LeapKind::by_blocks, Real>>(grid, ray, visitor);
}

} // namespace proxima
