// SPDX-License-Identifier: Apache-2.0
// Builds a frame's grid on a device: which primitives are too large for it, the bounds of the others, a resolution that
// fits into memory, the cloud over it if there is to be one, and the lists.
#pragma once
#include "kernels/grid_build.h"
#include "renderer/cloud_builder.h"
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"
#include "renderer/grid_resolution.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace proxima {

/// What a grid is to be like.
struct GridPlan {
    std::array<uint32_t, 3> size{0, 0, 0}; ///< voxels along each axis; 0: by voxels_per_primitive
    double voxels_per_primitive = GridRule{}.voxels_per_primitive;
    uint32_t brick = 0; ///< voxels along a brick of the cloud, a power of two; 0: no cloud
    Metric metric = Metric::chessboard;
};

template <class Backend, class Real> class GridBuilder {
public:
    explicit GridBuilder(Backend& backend)
        : backend_(backend), cloud_(backend), starts_(backend), references_(backend), large_(backend),
          large_count_(backend) {}

    /// Sets apart what is much larger than the rest, so that a ground sphere does not blow up the grid: what exceeds 32
    /// times the geometric mean of all radii, but never more than `most_large`, since every ray tests them. The rule
    /// looks at nothing but the scene: whatever the grid's resolution, the bounds, and so all distances, are the same.
    void find_bounds(GeometryView<Real>& geometry) {
        bounded_ = 0;
        const uint32_t count = geometry.round_count();
        const SizeTotal size = backend_.template reduce<SizeTotal>(count, MeasureSize<Real>{geometry});
        if (size.count == 0)
            return;
        int exponent = int(std::lround(double(size.exponents) / double(size.count))) + 5;
        BoundsTotal<Real> total;
        do {
            geometry.large_radius = std::ldexp(Real(1), exponent++);
            total = backend_.template reduce<BoundsTotal<Real>>(count, MeasureBounds<Real>{geometry});
        } while (total.large > most_large);
        if (total.large > 0)
            list_large(geometry, total.large);
        if (total.bounded > 0)
            geometry.bounds = padded(total.box);
        bounded_ = total.bounded;
    }

    /// Makes scene.grid as `plan` has it, or coarser where there is not memory enough.
    void build(SceneView<Real>& scene, const GridPlan& plan, FrameStatistics& statistics) {
        if (bounded_ == 0)
            return;
        const Box<Real>& bounds = scene.geometry.bounds;
        const Vec3<double> extent(bounds.upper - bounds.lower);
        const uint64_t budget =
            (backend_.available_memory() + starts_.bytes() + references_.bytes() + cloud_.bytes()) / 2;
        GridRule rule;
        rule.voxels_per_primitive = plan.voxels_per_primitive;
        rule.most_voxels = std::min(rule.most_voxels, budget / 2 / sizeof(uint32_t));
        for (;; rule.voxels_per_primitive /= 2) {
            std::array<uint32_t, 3> voxels = grid_resolution({extent.x, extent.y, extent.z}, bounded_, rule);
            for (int i = 0; i < 3; ++i)
                if (plan.size[i] > 0)
                    voxels[i] = std::min(plan.size[i], uint32_t(rule.longest));
            limit(voxels, rule);
            scene.grid = grid_over(bounds, voxels, plan.brick);
            if (plan.brick > 0)
                scene.grid.cloud = cloud_.mark(scene, plan.metric);
            const ReferenceTotal total = count_references(scene);
            const uint64_t most = std::min<uint64_t>(most_references, budget / sizeof(uint32_t));
            if (total.references <= most || scene.grid.cell_count() == 1) {
                fill(scene, total);
                for (int i = 0; i < 3; ++i)
                    statistics.grid[i] = uint32_t(scene.grid.size[i]);
                statistics.references = total.references;
                statistics.occupied = total.occupied;
                return;
            }
            rule.most_voxels = std::max<uint64_t>(scene.grid.cell_count() / 4, 1); // also against a size asked for
        }
    }

    /// The mean distance over the empty bricks of the cloud that `plan` would make: only its bricks are marked, and no
    /// lists are made.
    double mean_distance(SceneView<Real> scene, const GridPlan& plan) {
        if (bounded_ == 0)
            return 0;
        const Vec3<double> extent(scene.geometry.bounds.upper - scene.geometry.bounds.lower);
        GridRule rule;
        rule.voxels_per_primitive = plan.voxels_per_primitive;
        scene.grid = grid_over(scene.geometry.bounds, grid_resolution({extent.x, extent.y, extent.z}, bounded_, rule),
                               plan.brick);
        scene.grid.cloud = cloud_.mark(scene, plan.metric);
        cloud_.measure(scene.grid.cloud);
        return cloud_.mean_distance();
    }

    /// Measures the cloud's distances. The scene's grid must have been built with one.
    void build_distances(SceneView<Real>& scene, FrameStatistics& statistics) {
        cloud_.measure(scene.grid.cloud);
        statistics.metric = scene.grid.cloud.metric;
        statistics.brick = 1u << scene.grid.cloud.shift;
        statistics.mean_distance = cloud_.mean_distance();
    }

private:
    static constexpr uint32_t most_large = 64;
    static constexpr uint64_t most_references = 1ull << 31;
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    void list_large(GeometryView<Real>& geometry, uint32_t count) {
        large_.resize(count);
        large_count_.resize(1);
        large_count_.fill_bytes(0);
        backend_.for_each(geometry.round_count(), ListLarge<Real>{geometry, large_.view(), large_count_.view()});
        geometry.large = large_.view();
    }

    /// Wide enough for all rounding of boxes, entry points and walks; a flat scene gets some thickness.
    static Box<Real> padded(Box<Real> box) {
        const Real epsilon = std::numeric_limits<Real>::epsilon();
        Real reach = 0;
        for (int i = 0; i < 3; ++i)
            reach = larger(reach, larger(magnitude(box.lower[i]), magnitude(box.upper[i])));
        const Real pad = max_component(box.upper - box.lower) * Real(64) * epsilon + reach * Real(16) * epsilon;
        box.lower -= Vec3<Real>(pad);
        box.upper += Vec3<Real>(pad);
        return box;
    }

    static void limit(std::array<uint32_t, 3>& voxels, const GridRule& rule) {
        while (uint64_t(voxels[0]) * voxels[1] * voxels[2] > rule.most_voxels)
            for (uint32_t& n : voxels)
                n = std::max(1u, uint32_t(n * 0.8));
    }

    /// The grid over the bounds; with bricks, as many whole ones as hold the voxels that were asked for.
    static GridView<Real> grid_over(const Box<Real>& bounds, std::array<uint32_t, 3> voxels, uint32_t brick) {
        Vec3<int32_t> bricks;
        for (int i = 0; i < 3 && brick > 0; ++i) {
            bricks[i] = int32_t((voxels[i] + brick - 1) / brick);
            voxels[i] = uint32_t(bricks[i]) * brick;
        }
        GridView<Real> grid = make_grid(bounds, Vec3<int32_t>(voxels[0], voxels[1], voxels[2]));
        if (brick > 0)
            grid.cloud = {.size = bricks, .shift = std::countr_zero(brick)};
        return grid;
    }

    ReferenceTotal count_references(const SceneView<Real>& scene_without_lists) {
        SceneView<Real> scene = scene_without_lists;
        const uint32_t slots =
            scene.grid.cloud.in_use() ? cloud_.occupied() << (3 * scene.grid.cloud.shift) : scene.grid.cell_count();
        starts_.resize(size_t(slots) + 2); // one in front and one behind: see CountReferences
        starts_.fill_bytes(0);
        scene.grid.starts = starts_.view();
        backend_.for_each(scene.geometry.round_count(), CountReferences<Real>{scene.grid, scene.geometry});
        return backend_.template reduce<ReferenceTotal>(slots, MeasureReferences{starts_.view().subspan(1)});
    }

    void fill(SceneView<Real>& scene, const ReferenceTotal& total) {
        references_.resize(total.references);
        backend_.exclusive_scan(starts_.view().subspan(1));
        scene.grid.starts = starts_.view();
        scene.grid.references = references_.view();
        backend_.for_each(scene.geometry.round_count(), FillReferences<Real>{scene.grid, scene.geometry});
    }

    Backend& backend_;
    CloudBuilder<Backend, Real> cloud_;
    Buffer<uint32_t> starts_;
    Buffer<uint32_t> references_;
    Buffer<uint32_t> large_;
    Buffer<uint32_t> large_count_;
    uint32_t bounded_ = 0;
};

} // namespace proxima
