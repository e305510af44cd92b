// SPDX-License-Identifier: Apache-2.0
// A uniform grid over the frame's bounds: a linked list of primitives a voxel, all links in one array, so that one pass
// over the primitives builds it. With a cloud over it, its voxels stand in bricks of b^3, and only bricks that hold
// something have lists. Points go in, voxels come out.
#pragma once
#include "kernels/cloud.h"
#include "kernels/geometry.h"

#include <span>

namespace proxima {

/// One primitive of a voxel's list.
struct alignas(8) GridLink {
    uint32_t primitive;
    uint32_t next; ///< index of a GridLink, or no_link
};
inline constexpr uint32_t no_link = 0xffffffffu;

/// Which primitives a grid is for, by their centres and radii: see SceneView::outskirts.
enum class GridPart : uint8_t { all, core, outskirts };

template <class Real> struct GridView {
    Vec3<Real> lower{Real(0)};
    Vec3<Real> voxel{Real(1)}; ///< edge lengths
    Vec3<Real> inverse_voxel{Real(1)};
    Vec3<int32_t> size{0};
    Vec3<Real> end{Real(0)};   ///< the same as numbers: where the grid ends, in voxels
    Real inflation = Real(0);  ///< added to every radius on registration; covers all rounding of the walk and the tests
    std::span<uint32_t> heads; ///< of each slot's list: its first link, or no_link
    std::span<GridLink> links; ///< in no order
    CloudView cloud;           ///< without bricks: every voxel has a slot of its own
    GridPart part = GridPart::all;
    Box<Real> core;                    ///< those with their centres within it are the core
    Real core_radius = infinity<Real>; ///< but for larger ones

    HD bool in_use() const { return size.x > 0; }
    HD bool is_for(const Vec3<Real>& center, Real radius) const {
        const bool is_core = contains(core, center) && radius <= core_radius;
        return part == GridPart::all || is_core == (part == GridPart::core);
    }
    /// Where the grid lies: without a part, in all of the frame's bounds.
    HD Box<Real> box() const { return {lower, lower + voxel * end}; }
    HD uint32_t cell_count() const { return uint32_t(size.x) * uint32_t(size.y) * uint32_t(size.z); }
    HD uint32_t index(int32_t x, int32_t y, int32_t z) const {
        return uint32_t(x) + uint32_t(size.x) * (uint32_t(y) + uint32_t(size.y) * uint32_t(z));
    }
    /// Where a voxel's list stands in `heads`. With a cloud, its brick must be occupied.
    HD uint32_t slot(int32_t x, int32_t y, int32_t z) const {
        return cloud.in_use() ? cloud.slot(x, y, z) : index(x, y, z);
    }
    /// The voxel along one axis at `offset` from the lower side, moved into the grid.
    HD int32_t cell(Real offset, int axis) const {
        const Real c = clamped(offset * inverse_voxel[axis], Real(0), Real(size[axis] - 1));
        return int32_t(c);
    }
    HD Vec3<int32_t> cell_at(const Vec3<Real>& point) const {
        const Vec3<Real> p = point - lower;
        return {cell(p.x, 0), cell(p.y, 1), cell(p.z, 2)};
    }
};

/// A grid without lists: `size` voxels over `bounds`.
template <class Real> HD GridView<Real> make_grid(const Box<Real>& bounds, const Vec3<int32_t>& size) {
    GridView<Real> grid;
    grid.lower = bounds.lower;
    grid.size = size;
    grid.end = Vec3<Real>(size);
    grid.voxel = (bounds.upper - bounds.lower) / Vec3<Real>(size);
    grid.inverse_voxel = Vec3<Real>(size) / (bounds.upper - bounds.lower);
    // A walk strays from its ray by at most 5 * 2^-24 of the grid's length (in float), a sphere test by less; a
    // thousandth of a voxel on top is what the measurements asked for.
    const Real longest = Real(larger(larger(size.x, size.y), size.z));
    grid.inflation =
        (Real(1e-3) + longest * Real(8) * std::numeric_limits<Real>::epsilon()) * max_component(grid.voxel);
    return grid;
}

/// The grid of the bricks of a grid: what a primitive overlaps there holds all that it overlaps in the grid itself,
/// since multiplication by a power of two is exact.
template <class Real> HD GridView<Real> brick_grid(const GridView<Real>& grid) {
    GridView<Real> bricks;
    bricks.lower = grid.lower;
    bricks.size = grid.cloud.size;
    bricks.voxel = grid.voxel * Real(1 << grid.cloud.shift);
    bricks.inverse_voxel = grid.inverse_voxel / Real(1 << grid.cloud.shift);
    bricks.inflation = grid.inflation;
    bricks.part = grid.part;
    bricks.core = grid.core;
    bricks.core_radius = grid.core_radius;
    return bricks;
}

/// Calls `visit(x, y, z)` once for each voxel that the sphere, inflated, overlaps: row by row, exactly.
template <class Real, class Visit>
HD void for_each_cell(const GridView<Real>& grid, const Sphere<Real>& sphere, const Visit& visit) {
    const Vec3<Real> center = sphere.center - grid.lower;
    const Real radius = sphere.radius + grid.inflation;
    const auto gap = [](Real c, Real low, Real high) { return larger(larger(low - c, c - high), Real(0)); };
    const int32_t z_end = grid.cell(center.z + radius, 2), y_end = grid.cell(center.y + radius, 1);
    for (int32_t z = grid.cell(center.z - radius, 2); z <= z_end; ++z) {
        const Real dz = gap(center.z, Real(z) * grid.voxel.z, Real(z + 1) * grid.voxel.z);
        for (int32_t y = grid.cell(center.y - radius, 1); y <= y_end; ++y) {
            const Real dy = gap(center.y, Real(y) * grid.voxel.y, Real(y + 1) * grid.voxel.y);
            const Real half2 = radius * radius - dz * dz - dy * dy;
            if (!(half2 >= 0)) // nor where squares are too large for Real
                continue;
            const Real half = square_root(half2);
            const int32_t x_end = grid.cell(center.x + half, 0);
            for (int32_t x = grid.cell(center.x - half, 0); x <= x_end; ++x)
                visit(x, y, z);
        }
    }
}

/// The voxels that a sphere, inflated, overlaps, when it spans at most two along each axis: bit x + 2 y + 4 z of `mask`
/// is the voxel (x, y, z) behind the first one. Those of for_each_cell but for its rounding, without loops that
/// threads would go through at different paces.
struct SmallCells {
    Vec3<int32_t> first{0};
    uint32_t mask = 0;
    bool is_small = false;

    HD uint32_t count() const {
        uint32_t count = 0;
        for (int i = 0; i < 8; ++i)
            count += mask >> i & 1;
        return count;
    }
    /// Calls visit(x, y, z) for each of them.
    template <class Visit> HD void for_each(const Visit& visit) const {
        for (int i = 0; i < 8; ++i)
            if (mask >> i & 1)
                visit(first.x + (i & 1), first.y + (i >> 1 & 1), first.z + (i >> 2));
    }
};

template <class Real> HD SmallCells small_cells(const GridView<Real>& grid, const Sphere<Real>& sphere) {
    const Vec3<Real> center = sphere.center - grid.lower;
    const Real radius = sphere.radius + grid.inflation;
    SmallCells cells;
    Real gap2[3][2]; // along an axis, to the first and the second voxel; squared
    int32_t span[3];
    for (int i = 0; i < 3; ++i) {
        cells.first[i] = grid.cell(center[i] - radius, i);
        span[i] = grid.cell(center[i] + radius, i) - cells.first[i];
        const Real low = Real(cells.first[i]) * grid.voxel[i], middle = Real(cells.first[i] + 1) * grid.voxel[i];
        const Real below = larger(larger(low - center[i], center[i] - middle), Real(0));
        const Real above = larger(middle - center[i], Real(0)); // that it ends beyond is known
        gap2[i][0] = below * below;
        gap2[i][1] = above * above;
    }
    cells.is_small = larger(larger(span[0], span[1]), span[2]) <= 1;
    for (int i = 0; i < 8; ++i) {
        const int x = i & 1, y = i >> 1 & 1, z = i >> 2;
        const bool overlaps =
            x <= span[0] && y <= span[1] && z <= span[2] && gap2[2][z] + gap2[1][y] + gap2[0][x] <= radius * radius;
        cells.mask |= uint32_t(overlaps) << i;
    }
    return cells;
}

/// Calls `visit(x, y, z)` once for each voxel that the box, inflated, overlaps.
template <class Real, class Visit>
HD void for_each_cell(const GridView<Real>& grid, const Box<Real>& box, const Visit& visit) {
    const Vec3<Real> margin(grid.inflation);
    const Vec3<Real> low = box.lower - grid.lower - margin, high = box.upper - grid.lower + margin;
    for (int32_t z = grid.cell(low.z, 2); z <= grid.cell(high.z, 2); ++z)
        for (int32_t y = grid.cell(low.y, 1); y <= grid.cell(high.y, 1); ++y)
            for (int32_t x = grid.cell(low.x, 0); x <= grid.cell(high.x, 0); ++x)
                visit(x, y, z);
}

} // namespace proxima
