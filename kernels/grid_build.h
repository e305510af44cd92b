// SPDX-License-Identifier: Apache-2.0
// Building a frame's grid on the device. In order: how big the primitives are, which of them are too large for a grid
// and the bounds of the others; which bricks are occupied, if there is to be a cloud; then the lists, in one pass.
#pragma once
#include "kernels/brick_marks.h"
#include "kernels/scene_view.h"

namespace proxima {

/// The whole part of log2 v; v must not be 0.
HD inline int exponent_of(float v) {
    return ::ilogbf(v);
}
HD inline int exponent_of(double v) {
    return ::ilogb(v);
}

/// How big the primitives are and where they lie. The mean size is one in powers of two: of integers, so that every
/// order of summation agrees.
template <class Real> struct SizeTotal {
    int64_t exponents = 0;
    uint64_t count = 0; ///< primitives with a positive radius
    Real largest = Real(0);
    Box<Real> box{Vec3<Real>(infinity<Real>), Vec3<Real>(-infinity<Real>)};

    HD static SizeTotal combine(const SizeTotal& a, const SizeTotal& b) {
        return {a.exponents + b.exponents, a.count + b.count, larger(a.largest, b.largest), joined(a.box, b.box)};
    }
};

/// The exponent of two of the radius from which a primitive is large: 32 times the geometric mean of all. Whole numbers
/// throughout, so that a scene scaled by a power of two has the same large ones.
HD constexpr int large_exponent(int64_t exponents, uint64_t count) {
    const int64_t twice = 2 * exponents + int64_t(count), divisor = 2 * int64_t(count);
    return int(twice / divisor - (twice % divisor < 0)) + 5;
}

/// Primitive -> its part of the SizeTotal.
template <class Real> struct MeasureSize {
    GeometryView<Real> geometry;

    HD SizeTotal<Real> operator()(uint32_t id) const {
        const Real radius = geometry.radius(id);
        if (!(radius > 0))
            return {};
        return {exponent_of(radius), 1, radius, geometry.box(id)};
    }
};

/// The bounds of the primitives that a grid can hold, and how many it cannot.
template <class Real> struct BoundsTotal {
    Box<Real> box{Vec3<Real>(infinity<Real>), Vec3<Real>(-infinity<Real>)};
    uint32_t bounded = 0;
    uint32_t left_out = 0;

    HD static BoundsTotal combine(const BoundsTotal& a, const BoundsTotal& b) {
        return {joined(a.box, b.box), a.bounded + b.bounded, a.left_out + b.left_out};
    }
};

/// Primitive -> its part of the BoundsTotal.
template <class Real> struct MeasureBounds {
    GeometryView<Real> geometry;

    HD BoundsTotal<Real> operator()(uint32_t id) const {
        const Real radius = geometry.radius(id);
        if (radius > geometry.large_radius)
            return {.left_out = 1};
        if (!(radius > 0))
            return {};
        return {geometry.box(id), 1, 0};
    }
};

/// Lists the large primitives, in no order.
template <class Real> struct ListLarge {
    GeometryView<Real> geometry;
    std::span<uint32_t> list;
    std::span<uint32_t> count; ///< one number, 0 at the start

    HD void operator()(uint32_t id) const {
        if (geometry.radius(id) > geometry.large_radius)
            list[atomic_add(&count[0], 1)] = id;
    }
};

/// Whether a primitive belongs into a grid's lists.
template <class Real> HD bool is_listed(const GridView<Real>& grid, const GeometryView<Real>& geometry, uint32_t id) {
    return geometry.is_bounded(id) &&
           (grid.part == GridPart::all || grid.is_for(geometry.center(id), geometry.radius(id)));
}

/// The voxels of a primitive that needs few of them; none of one that is not listed. Otherwise it is not small.
template <class Real>
HD SmallCells small_cells_of(const GridView<Real>& grid, const GeometryView<Real>& geometry, uint32_t id) {
    if (!is_listed(grid, geometry, id))
        return {.is_small = true};
    return geometry.is_sphere(id) ? small_cells(grid, geometry.spheres[id]) : SmallCells{};
}

/// Calls visit(x, y, z) for each voxel of a primitive, given what small_cells_of() says of it.
template <class Real, class Visit>
HD void for_each_cell_of(const GridView<Real>& grid, const GeometryView<Real>& geometry, uint32_t id,
                         const SmallCells& cells, const Visit& visit) {
    if (cells.is_small)
        cells.for_each(visit);
    else if (geometry.is_sphere(id))
        for_each_cell(grid, geometry.spheres[id], visit);
    else
        for_each_cell(grid, bounding_box(geometry.ellipsoid(id)), visit);
}
template <class Real, class Visit>
HD void for_each_cell_of(const GridView<Real>& grid, const GeometryView<Real>& geometry, uint32_t id,
                         const Visit& visit) {
    for_each_cell_of(grid, geometry, id, small_cells_of(grid, geometry, id), visit);
}

/// What the building of a grid counts. A builder that made room for fewer sees it here and comes again.
struct GridCounts {
    uint64_t links = 0;
    uint64_t occupied = 0; ///< slots with a list
    uint32_t bricks = 0;   ///< occupied ones of the cloud
};

/// Primitive -> the bricks that it overlaps are occupied: they get a mark, a rank and empty lists. Where there is room
/// for fewer, the others have no mark, and so no distance of 0: rays pass them by.
template <class Real> struct MarkBricks {
    static constexpr uint32_t no_rank = 0xffffffffu, claimed = 0xfffffffeu;

    GridView<Real> grid; ///< with its cloud: ranks are no_rank at the start
    GeometryView<Real> geometry;
    std::span<GridCounts> counts; ///< one
    BrickMarks marks;             ///< none at the start

    HD void operator()(uint32_t id) const {
        for_each_cell_of(brick_grid(grid), geometry, id,
                         [&](int32_t x, int32_t y, int32_t z) { occupy(x, uint32_t(y + grid.cloud.size.y * z)); });
    }

private:
    HD void occupy(int32_t x, uint32_t row) const {
        uint32_t* const place = &grid.cloud.ranks[uint32_t(x) + uint32_t(grid.cloud.size.x) * row];
        if (load_relaxed(place) != no_rank || atomic_compare_exchange(place, no_rank, claimed) != no_rank)
            return;
        const uint32_t rank = atomic_add(&counts[0].bricks, 1);
        store_relaxed(place, rank);
        const uint64_t voxels = 1u << (3 * grid.cloud.shift), first = rank * voxels;
        if (first + voxels > grid.heads.size())
            return; // without a mark: rays may come before it is known that there was too little room
        marks.set(row, x);
        for (uint64_t voxel = first; voxel < first + voxels; ++voxel)
            grid.heads[voxel] = no_link;
    }
};

/// The same for a cloud that is only planned: marks alone.
template <class Real> struct MarkPlannedBricks {
    GridView<Real> grid; ///< with its cloud's size
    GeometryView<Real> geometry;
    BrickMarks marks; ///< none at the start

    HD void operator()(uint32_t id) const {
        for_each_cell_of(brick_grid(grid), geometry, id,
                         [&](int32_t x, int32_t y, int32_t z) { marks.set(uint32_t(y + grid.cloud.size.y * z), x); });
    }
};

/// Primitives -> each becomes the first of the list of each voxel that it overlaps. The heads are no_link at the start.
/// One item is `together` primitives, which take their links at once: cores would wait for each other's at each.
template <class Real, uint32_t together> struct LinkPrimitives {
    GridView<Real> grid;
    GeometryView<Real> geometry;
    std::span<GridCounts> counts; ///< one

    HD static uint32_t item_count(uint32_t primitives) { return (primitives + together - 1) / together; }

    HD void operator()(uint32_t item) const {
        const uint32_t first = item * together, end = smaller(first + together, geometry.round_count());
        SmallCells cells[together];
        uint32_t count = 0, occupied = 0;
        for (uint32_t i = 0; i < together && first + i < end; ++i) {
            cells[i] = small_cells_of(grid, geometry, first + i);
            if (cells[i].is_small)
                count += cells[i].count();
            else
                for_each_cell_of(grid, geometry, first + i, cells[i], [&](int32_t, int32_t, int32_t) { ++count; });
        }
        uint64_t link = take_from(&counts[0].links, count);
        if (link + count > grid.links.size())
            return;
        for (uint32_t i = 0; i < together && first + i < end; ++i)
            occupied += cells[i].is_small ? link_small(first + i, cells[i], link) : link_one(first + i, cells[i], link);
        count_up(&counts[0].occupied, occupied);
    }

private:
    /// Puts a primitive into its lists, by the links from `link` on. Returns how many of them were empty.
    HD uint32_t link_one(uint32_t id, const SmallCells& cells, uint64_t& link) const {
        uint32_t occupied = 0;
        for_each_cell_of(grid, geometry, id, cells, [&](int32_t x, int32_t y, int32_t z) {
            const uint32_t next = exchange(x, y, z, uint32_t(link));
            grid.links[link++] = {id, next};
            occupied += next == no_link;
        });
        return occupied;
    }
    /// The same all at once, since each exchange takes a long way to memory.
    HD uint32_t link_small(uint32_t id, const SmallCells& cells, uint64_t& link) const {
        uint32_t occupied = 0, next[8], place = uint32_t(link);
        for (int i = 0; i < 8; ++i)
            if (cells.mask >> i & 1)
                next[i] =
                    exchange(cells.first.x + (i & 1), cells.first.y + (i >> 1 & 1), cells.first.z + (i >> 2), place++);
        for (int i = 0; i < 8; ++i)
            if (cells.mask >> i & 1) {
                grid.links[link++] = {id, next[i]};
                occupied += next[i] == no_link;
            }
        return occupied;
    }
    /// Puts a link in front of a voxel's list; returns the next one.
    HD uint32_t exchange(int32_t x, int32_t y, int32_t z, uint32_t link) const {
        const uint32_t slot = grid.slot(x, y, z);
        return slot < grid.heads.size() ? atomic_exchange(&grid.heads[slot], link)
                                        : no_link; // else more bricks than room
    }
};

} // namespace proxima
