// SPDX-License-Identifier: Apache-2.0
// The way of a ray through a grid: voxel by voxel (3DDDA: Fujimoto, Tanaka and Iwata, "ARTS: Accelerated Ray-Tracing
// System", 1986), and over empty space in leaps where a cloud says how far. A leap by the distance 1 is a step.
#pragma once
#include "kernels/grid_walk.h"

namespace proxima {

/// Shows a visitor a list that begins with `link`; true when the visitor has seen enough. Each link is on its way
/// from memory while the primitive before it is met.
template <RoundShapes shapes, class Real, class Visitor>
HD_INNER bool meet_list(const GridView<Real>& grid, uint32_t link, Visitor& visitor) {
    if (link == no_link)
        return false;
    for (GridLink current = grid.links[link];;) {
        const bool is_last = current.next == no_link;
        const GridLink next = is_last ? current : grid.links[current.next];
        if (shapes == RoundShapes::spheres ? visitor.meet_sphere(current.primitive) : visitor.meet(current.primitive))
            return true;
        if (is_last)
            return false;
        current = next;
    }
}

/// A ray's way through a grid whose every voxel has a list. It keeps its numbers apart from GridWalk's: one place for
/// both costs the cloud a third of its speed on an H100, by the registers.
template <RoundShapes shapes, class Real> class StepWalk {
public:
    HD StepWalk(const GridView<Real>& grid, const Ray<Real>& ray, Real start)
        : StepWalk(grid, (ray.origin - grid.lower) * grid.inverse_voxel, ray.direction,
                   Real(1) / ray.direction * grid.voxel, start) {}

    /// False at the end of the grid, or when the visitor has seen enough.
    template <class Visitor> HD_INNER bool turn(const GridView<Real>& grid, Visitor& visitor) {
        const Real x = crossings_[0].at(plane_.x), y = crossings_[1].at(plane_.y), z = crossings_[2].at(plane_.z);
        const Real leave = lesser(lesser(x, y), z);
        // Without branches, which threads that go different ways would take one after the other.
        const bool along_x = leave == x, along_y = !along_x && leave == y, along_z = !along_x && !along_y;
        plane_.x += along_x ? crossings_[0].step() : Real(0);
        plane_.y += along_y ? crossings_[1].step() : Real(0);
        plane_.z += along_z ? crossings_[2].step() : Real(0);
        voxel_ += uint32_t(along_x ? way_[0] : along_y ? way_[1] : way_[2]);
        const bool is_last = leave >= end_;
        const uint32_t here = head_;
        head_ = is_last ? no_link : grid.heads[voxel_]; // on its way while this voxel's list is met
        return !(meet_list<shapes>(grid, here, visitor) || visitor.is_done(leave) || is_last);
    }

private:
    HD StepWalk(const GridView<Real>& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                const Vec3<Real>& pace, Real start)
        : crossings_{{origin.x, pace.x}, {origin.y, pace.y}, {origin.z, pace.z}} {
        const Vec3<int32_t> cells = first_cell(grid, origin, direction * grid.inverse_voxel, start);
        int32_t stride = 1;
        for (int i = 0; i < 3; ++i) {
            const int32_t cell = cells[i];
            const bool upwards = direction[i] > 0;
            plane_[i] = Real(cell + upwards);
            // The last plane is crossed at exactly the same distance when the walk comes to it.
            end_ = lesser(end_, crossings_[i].at(upwards ? grid.end[i] : Real(0)));
            voxel_ += uint32_t(cell * stride);
            way_[i] = upwards ? stride : -stride;
            stride *= grid.size[i];
        }
        head_ = grid.heads[voxel_];
    }

    Crossing<Real> crossings_[3];
    Vec3<Real> plane_; ///< whole numbers: where the ray leaves its voxel
    int32_t way_[3];   ///< in voxels, to the next one
    uint32_t voxel_ = 0;
    uint32_t head_;             ///< of its list
    Real end_ = infinity<Real>; ///< of the grid
};

/// What a metric's distances count: bricks along the axes, or the length of the way.
enum class LeapKind { by_blocks, by_length };

/// The same where empty bricks say how far the ray may leap.
template <RoundShapes shapes, LeapKind leap, class Real> class LeapWalk {
public:
    HD LeapWalk(const GridView<Real>& grid, const Ray<Real>& ray, Real start) : place_(grid, ray, start) {
        if (grid.cloud.metric == Metric::octant)
            map_ = place_.octant() * grid.cloud.brick_count();
        look_up(grid);
    }

    template <class Visitor> HD_INNER bool turn(const GridView<Real>& grid, Visitor& visitor) {
        const uint32_t here = head_;
        const int32_t distance = distance_;
        // One piece of code for steps and leaps: threads of a warp do either at the same time.
        const bool inside = leap == LeapKind::by_length && distance > 0
                                ? place_.leap_by_length(grid, distance)
                                : place_.leave_block(grid, distance > 0 ? grid.cloud.shift : 0, larger(distance, 1));
        if (inside)
            look_up(grid); // on its way while this voxel's list is met
        return !(meet_list<shapes>(grid, here, visitor) || !inside || visitor.is_done(place_.now));
    }

private:
    HD_INNER void look_up(const GridView<Real>& grid) {
        const CloudView& cloud = grid.cloud;
        const uint32_t brick = cloud.brick(place_.cell.x, place_.cell.y, place_.cell.z);
        distance_ = cloud.distances[size_t(map_) + brick]; // 0 where the brick is occupied
        head_ = no_link;
        if (distance_ == 0)
            head_ = grid.heads[cloud.ranks[brick] << (3 * cloud.shift) |
                               cloud.place(place_.cell.x, place_.cell.y, place_.cell.z)];
    }

    GridWalk<Real> place_;
    uint32_t map_ = 0;     ///< where the ray's octant begins
    int32_t distance_ = 0; ///< in bricks
    uint32_t head_ = no_link;
};

/// Shows a visitor the lists of the voxels along a ray, in order, until it is done. Returns how many voxels, and bricks
/// of a cloud, were looked up.
template <class Walk, class Real, class Visitor>
HD uint32_t walk_to_end(const GridView<Real>& grid, const Ray<Real>& ray, Real start, Visitor& visitor) {
    Walk walk(grid, ray, start);
    uint32_t turns = 1;
    while (walk.turn(grid, visitor))
        ++turns;
    return turns;
}
/// The ways through a grid that a kernel knows: what it knows takes registers.
enum class Ways { any, steps, leaps };

/// Which of them does for a grid. Only `any` knows of parts.
template <class Real> HD Ways ways_of(const GridView<Real>& grid) {
    const Metric metric = grid.cloud.metric;
    return !grid.in_use() || grid.part != GridPart::all                  ? Ways::any
           : !grid.cloud.in_use()                                        ? Ways::steps
           : metric == Metric::city_block || metric == Metric::euclidean ? Ways::any
                                                                         : Ways::leaps;
}

template <RoundShapes shapes, Ways ways = Ways::any, class Real, class Visitor>
HD uint32_t walk(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    Real start(0);
    if (ways == Ways::any && grid.part == GridPart::core) { // elsewhere a ray's origin is in the grid
        const Span<Real> inside = intersect(grid.box(), ray);
        if (!(inside.enter <= inside.exit) || visitor.is_done(inside.enter))
            return 0;
        start = inside.enter;
    }
    if (ways == Ways::steps || (ways == Ways::any && !grid.cloud.in_use()))
        return walk_to_end<StepWalk<shapes, Real>>(grid, ray, start, visitor);
    if (ways == Ways::any && (grid.cloud.metric == Metric::city_block || grid.cloud.metric == Metric::euclidean))
        return walk_to_end<LeapWalk<shapes, LeapKind::by_length, Real>>(grid, ray, start, visitor);
    return walk_to_end<LeapWalk<shapes, LeapKind::by_blocks, Real>>(grid, ray, start, visitor);
}

} // namespace proxima
