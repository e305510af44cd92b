// SPDX-License-Identifier: Apache-2.0
// Builds the grid of the primitives outside of the core: few, and far apart or large.
#pragma once
#include "kernels/grid_build.h"
#include "renderer/grid_resolution.h"

namespace proxima {

template <class Backend, class Real> class OutskirtsBuilder {
public:
    explicit OutskirtsBuilder(Backend& backend)
        : backend_(backend), heads_(backend), links_(backend), counts_(backend) {}

    /// Starts to make scene.outskirts, over all bounds. `core`: the grid that is not for them. `count`: the primitives
    /// outside of the core; none has a larger radius than `largest`.
    void build(SceneView<Real>& scene, const GridView<Real>& core, uint32_t count, Real largest) {
        const Box<Real>& bounds = scene.geometry.bounds;
        const Vec3<double> extent(bounds.upper - bounds.lower);
        auto size = grid_resolution({extent.x, extent.y, extent.z}, count, {.voxels_per_primitive = 8});
        for (int i = 0; i < 3; ++i)
            size[i] = uint32_t(std::clamp(extent[i] / (2.5 * double(largest)), 1.0, double(size[i])));
        GridView<Real>& grid = scene.outskirts = make_grid(bounds, Vec3<int32_t>(size[0], size[1], size[2]));
        grid.part = GridPart::outskirts;
        grid.core = core.core;
        grid.core_radius = core.core_radius;
        heads_.resize(grid.cell_count());
        heads_.fill_bytes(0xff); // no_link
        grid.heads = heads_.view();
        links_.resize(size_t(most_voxels) * count);
        grid.links = links_.view();
        counts_.resize(1);
        counts_.fill_bytes(0);
        const LinkPrimitives<Real, Backend::primitives_together> link{grid, scene.geometry, counts_.view()};
        backend_.for_each(link.item_count(scene.geometry.round_count()), link);
    }

    uint64_t bytes() const { return heads_.bytes() + links_.bytes(); }

private:
    static constexpr uint32_t most_voxels = 27; ///< that one with a diameter of less than a voxel may be in
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    Backend& backend_;
    Buffer<uint32_t> heads_;
    Buffer<GridLink> links_;
    Buffer<GridCounts> counts_;
};

} // namespace proxima
