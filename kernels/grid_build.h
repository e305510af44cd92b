// SPDX-License-Identifier: Apache-2.0
// Building a frame's grid on the device. In order: how big the primitives are, which of them are too large for a grid,
// the bounds of the others; then references are counted, summed up (by the backend) and filled in.
#pragma once
#include "kernels/scene_view.h"

namespace proxima {

/// The mean size of the primitives in powers of two; integers, so that every order of summation agrees.
struct SizeTotal {
    int64_t exponents = 0;
    uint64_t count = 0;

    HD static SizeTotal combine(const SizeTotal& a, const SizeTotal& b) {
        return {a.exponents + b.exponents, a.count + b.count};
    }
};

/// Primitive -> its part of the SizeTotal.
template <class Real> struct MeasureSize {
    GeometryView<Real> geometry;

    HD SizeTotal operator()(uint32_t id) const {
        const float radius = float(geometry.radius(id));
        return radius > 0 ? SizeTotal{ilogbf(radius), 1} : SizeTotal{};
    }
};

/// The bounds of the primitives that a grid can hold, and how many it cannot.
template <class Real> struct BoundsTotal {
    Box<Real> box{Vec3<Real>(infinity<Real>), Vec3<Real>(-infinity<Real>)};
    uint32_t bounded = 0;
    uint32_t large = 0;

    HD static BoundsTotal combine(const BoundsTotal& a, const BoundsTotal& b) {
        BoundsTotal sum{a.box, a.bounded + b.bounded, a.large + b.large};
        for (int i = 0; i < 3; ++i) {
            sum.box.lower[i] = smaller(a.box.lower[i], b.box.lower[i]);
            sum.box.upper[i] = larger(a.box.upper[i], b.box.upper[i]);
        }
        return sum;
    }
};

/// Primitive -> its part of the BoundsTotal.
template <class Real> struct MeasureBounds {
    GeometryView<Real> geometry;

    HD BoundsTotal<Real> operator()(uint32_t id) const {
        const Real radius = geometry.radius(id);
        if (radius > geometry.large_radius)
            return {.large = 1};
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

template <class Real, class Visit>
HD void for_each_cell_of(const GridView<Real>& grid, const GeometryView<Real>& geometry, uint32_t id,
                         const Visit& visit) {
    const Real radius = geometry.radius(id);
    if (!(radius > 0) || radius > geometry.large_radius)
        return;
    if (geometry.is_sphere(id))
        for_each_cell(grid, geometry.spheres[id], visit);
    else
        for_each_cell(grid, bounding_box(geometry.ellipsoid(id)), visit);
}

/// Primitive -> the bricks that it overlaps are occupied: their distance is 0.
template <class Real> struct MarkBricks {
    GridView<Real> bricks;
    GeometryView<Real> geometry;
    std::span<uint8_t> distances;

    HD void operator()(uint32_t id) const {
        uint8_t* occupied = distances.data();
        for_each_cell_of(bricks, geometry, id, [&](int32_t x, int32_t y, int32_t z) {
            store_relaxed(&occupied[bricks.index(x, y, z)], uint8_t(0));
        });
    }
};

/// Brick -> 1 where it is occupied; the exclusive sum of these is CloudView::ranks.
struct CountBricks {
    std::span<const uint8_t> distances;
    std::span<uint32_t> ranks;

    HD void operator()(uint32_t brick) const { ranks[brick] = brick < distances.size() && distances[brick] == 0; }
};

/// Primitive -> counts[slot] grows by one for each voxel that lists it. counts are the grid's starts, shifted by one:
/// after an exclusive sum they are where each list begins, and after FillReferences where it ends.
template <class Real> struct CountReferences {
    GridView<Real> grid;
    GeometryView<Real> geometry;

    HD void operator()(uint32_t id) const {
        uint32_t* counts = grid.starts.data() + 1;
        for_each_cell_of(grid, geometry, id,
                         [&](int32_t x, int32_t y, int32_t z) { atomic_add(&counts[grid.slot(x, y, z)], 1); });
    }
};

template <class Real> struct FillReferences {
    GridView<Real> grid;
    GeometryView<Real> geometry;

    HD void operator()(uint32_t id) const {
        uint32_t* ends = grid.starts.data() + 1;
        for_each_cell_of(grid, geometry, id, [&](int32_t x, int32_t y, int32_t z) {
            grid.references[atomic_add(&ends[grid.slot(x, y, z)], 1)] = id;
        });
    }
};

/// What the counts add up to, in 64 bits.
struct ReferenceTotal {
    uint64_t references = 0;
    uint64_t occupied = 0;

    HD static ReferenceTotal combine(const ReferenceTotal& a, const ReferenceTotal& b) {
        return {a.references + b.references, a.occupied + b.occupied};
    }
};

/// Voxel -> its part of the ReferenceTotal.
struct MeasureReferences {
    std::span<const uint32_t> counts;

    HD ReferenceTotal operator()(uint32_t voxel) const { return {counts[voxel], counts[voxel] != 0}; }
};

} // namespace proxima
