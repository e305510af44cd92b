// SPDX-License-Identifier: Apache-2.0
// Builds a frame's grid on a device: which primitives are too large for it, the bounds of the others, a resolution that
// fits into memory, the cloud over it if there is to be one, and the lists.
#pragma once
#include "kernels/grid_build.h"
#include "renderer/cloud_builder.h"
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"
#include "renderer/grid_plan.h"
#include "renderer/method_record.h"
#include "renderer/outlier_rule.h"
#include "renderer/outskirts_builder.h"

#include <algorithm>
#include <cmath>

namespace proxima {

template <class Backend, class Real> class GridBuilder {
public:
    explicit GridBuilder(Backend& backend)
        : backend_(backend), cloud_(backend), outskirts_(backend), heads_(backend), links_(backend), large_(backend),
          large_count_(backend), counts_(backend), seen_counts_(backend) {}

    /// What is known of the lists' lengths is of another scene.
    void forget() {
        has_seen_ = {};
        most_voxels_ = GridRule{}.most_voxels;
        outliers_.forget();
    }

    /// Sets apart what is much larger than the rest, so that a ground sphere does not blow up the grid: what exceeds
    /// large_exponent(), but never more than `most_large`, since every ray tests them. The rule
    /// looks at nothing but the scene: whatever the grid's resolution, the bounds, and so all distances, are the same.
    void find_bounds(GeometryView<Real>& geometry) {
        total_ = {};
        has_core_ = false;
        const uint32_t count = geometry.round_count();
        const auto size = backend_.template reduce<SizeTotal<Real>>(count, MeasureSize<Real>{geometry});
        if (size.count == 0)
            return;
        int exponent = large_exponent(size.exponents, size.count);
        geometry.large_radius = std::ldexp(Real(1), exponent);
        total_ = {size.box, uint32_t(size.count), 0};
        if (size.largest > geometry.large_radius)
            do {
                geometry.large_radius = std::ldexp(Real(1), exponent++);
                total_ = backend_.template reduce<BoundsTotal<Real>>(count, MeasureBounds<Real>{geometry});
            } while (total_.left_out > most_large);
        if (total_.left_out > 0)
            list_large(geometry, total_.left_out);
        if (total_.bounded > 0) {
            geometry.bounds = padded(total_.box, pad_of(total_.box));
            geometry.slack = rounding_slack(glm::length(geometry.bounds.upper - geometry.bounds.lower));
        }
        typical_radius_ = std::ldexp(Real(1), large_exponent(size.exponents, size.count) - 5);
        largest_radius_ = std::min(size.largest, geometry.large_radius);
    }

    /// Whether most primitives are close together, far from all others, or much smaller than these: then grids are for
    /// those, and the others get one of their own. After find_bounds(). `anew`: whatever was found in the frames
    /// before.
    void find_core(const GeometryView<Real>& geometry, bool anew) {
        if (anew)
            outliers_.forget();
        if (total_.bounded >= fewest_for_core)
            outliers_.look(backend_, geometry, total_, typical_radius_, largest_radius_);
        has_core_ = total_.bounded >= fewest_for_core && outliers_.found();
    }

    /// Starts to make scene.grid as `plan` has it, or coarser where there is not memory enough. Room is made for lists
    /// as long as those that were seen last; whether that was enough, is_complete() tells.
    void build(SceneView<Real>& scene, const GridPlan& plan) {
        if (total_.bounded == 0)
            return;
        do {
            start(scene, plan);
            if (has_seen_[plan.brick > 0] && !Backend::is_immediate)
                return;
            backend_.synchronize();
        } while (!is_complete());
    }

    /// After a synchronize(): whether the grid is whole. If not, there is room now, and it has to be built again.
    bool is_complete() {
        if (total_.bounded == 0)
            return true;
        const GridCounts counts = seen_counts_.value();
        const bool whole = counts.links <= links_.size() && counts.bricks <= brick_room_;
        const uint64_t most_links_now = link_budget();
        if (!whole && counts.links > most_links_now && !is_coarsest_)
            most_voxels_ = std::max<uint64_t>(std::min(most_voxels_, cells_) / 4, 1); // whole bricks may be more
        link_room_ = counts.links + counts.links / 8;
        if (!is_coarsest_) // otherwise there is no way but to ask the device, which may be out of memory then
            link_room_ = std::min(link_room_, most_links_now);
        if (counts.bricks > 0) // a grid without them in between does not take the cloud's room
            brick_room_ = uint32_t(std::min<uint64_t>(counts.bricks + counts.bricks / 8 + 64, 0xfffffffe));
        has_seen_[counts.bricks > 0] = whole;
        return whole;
    }

    /// What the grid and its cloud are like, once they are complete.
    void report(const GridView<Real>& grid, FrameStatistics& statistics) const {
        if (!grid.in_use())
            return;
        for (int i = 0; i < 3; ++i)
            statistics.grid[i] = uint32_t(grid.size[i]);
        if (grid.size != wanted_) {
            for (int i = 0; i < 3; ++i)
                statistics.wanted_grid[i] = uint32_t(wanted_[i]);
            statistics.most_voxels = most_voxels_;
        }
        statistics.outliers = has_core_ ? outliers_.total().left_out : 0;
        statistics.references = seen_counts_.value().links;
        statistics.occupied = seen_counts_.value().occupied;
        if (!grid.cloud.in_use())
            return;
        statistics.metric = grid.cloud.metric;
        statistics.brick = 1u << grid.cloud.shift;
        statistics.mean_distance = cloud_.mean_distance();
    }

    /// What there is of the cloud that `plan` would make: only its bricks are marked, and no lists are made. Waits for
    /// the device.
    EmptySpace look(SceneView<Real> scene, const GridPlan& plan) {
        if (total_.bounded == 0)
            return {};
        scene.grid = planned(scene.geometry.bounds, plan, most_voxels_);
        cloud_.mark_planned(scene, plan.metric);
        cloud_.measure(scene.grid.cloud);
        backend_.synchronize();
        return {total_.bounded, scene.grid.cloud.brick_count(), cloud_.empty_bricks(), cloud_.mean_distance()};
    }

    /// Starts to measure the cloud's distances. The scene's grid must have been built with one.
    void build_distances(SceneView<Real>& scene) { cloud_.measure(scene.grid.cloud); }

private:
    static constexpr uint32_t most_large = 64;
    static constexpr uint32_t fewest_for_core = 64;
    static constexpr uint64_t most_links = 0xfffffff0; ///< links are numbered in 32 bits
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    void list_large(GeometryView<Real>& geometry, uint32_t count) {
        large_.resize(count);
        large_count_.resize(1);
        large_count_.fill_bytes(0);
        backend_.for_each(geometry.round_count(), ListLarge<Real>{geometry, large_.view(), large_count_.view()});
        geometry.large = large_.view();
    }

    /// Bytes that the lists may take: what they have, and half of what is left.
    uint64_t budget() const {
        return (backend_.available_memory() + heads_.bytes() + links_.bytes() + cloud_.bytes()) / 2;
    }
    uint64_t link_budget() const { return std::min<uint64_t>(most_links, budget() / sizeof(GridLink)); }

    /// A grid without lists, over the bounds or the core.
    GridView<Real> planned(const Box<Real>& bounds, const GridPlan& plan, uint64_t most_voxels) const {
        if (!has_core_)
            return grid_over(bounds, planned_voxels(bounds, total_.bounded, plan, most_voxels), plan.brick);
        const Box<Real> box = padded(outliers_.total().box, pad_of(total_.box));
        std::array<uint32_t, 3> size = planned_voxels(box, outliers_.total().bounded, plan, most_voxels);
        // Rays come from afar: by what they may stray then, a voxel must be larger.
        const Real stray = max_component(bounds.upper - bounds.lower) * Real(16) * std::numeric_limits<Real>::epsilon();
        for (int i = 0; i < 3; ++i)
            size[i] = uint32_t(std::clamp((box.upper[i] - box.lower[i]) / (4 * stray), Real(1), Real(size[i])));
        GridView<Real> grid = grid_over(box, size, plan.brick);
        grid.inflation += stray;
        grid.part = GridPart::core;
        grid.core = outliers_.core();
        grid.core_radius = outliers_.radius();
        return grid;
    }

    void clear_counts() {
        counts_.resize(1);
        counts_.fill_bytes(0);
    }

    void start(SceneView<Real>& scene, const GridPlan& plan) {
        if (!has_seen_[plan.brick > 0] && link_room_ == 0)
            link_room_ = std::min<uint64_t>(uint64_t(total_.bounded) * expected_links, link_budget());
        if (!has_seen_[plan.brick > 0])
            most_voxels_ = std::min(most_voxels_, budget() / 2 / sizeof(uint32_t));
        scene.grid = planned(scene.geometry.bounds, plan, most_voxels_);
        wanted_ = planned(scene.geometry.bounds, plan, ~uint64_t(0)).size;
        cells_ = scene.grid.cell_count();
        is_coarsest_ = (plan.brick > 0 ? scene.grid.cloud.brick_count() : cells_) == 1;
        if (links_.size() < link_room_)
            links_.resize(link_room_);
        scene.grid.links = links_.view();
        clear_counts();
        if (plan.brick > 0) {
            brick_room_ = std::min(std::max(brick_room_, 1024u), scene.grid.cloud.brick_count());
            heads_.resize(size_t(brick_room_) << (3 * scene.grid.cloud.shift));
            scene.grid.heads = heads_.view();
            cloud_.mark(scene, plan.metric, counts_.view());
        } else {
            heads_.resize(scene.grid.cell_count());
            heads_.fill_bytes(0xff); // no_link
            scene.grid.heads = heads_.view();
        }
        const uint32_t primitives = scene.geometry.round_count();
        const LinkPrimitives<Real, Backend::primitives_together> link{scene.grid, scene.geometry, counts_.view()};
        backend_.for_each(link.item_count(primitives), link);
        scene.outskirts = {};
        if (has_core_)
            outskirts_.build(scene, scene.grid, outliers_.total().left_out, largest_radius_);
        seen_counts_.request(counts_);
    }

    static constexpr uint32_t expected_links = 6; ///< a primitive, in a scene that was not seen yet

    Backend& backend_;
    CloudBuilder<Backend, Real> cloud_;
    OutskirtsBuilder<Backend, Real> outskirts_;
    Buffer<uint32_t> heads_;
    Buffer<GridLink> links_;
    Buffer<uint32_t> large_;
    Buffer<uint32_t> large_count_;
    Buffer<GridCounts> counts_;
    typename Backend::template Receipt<GridCounts> seen_counts_;
    OutlierRule<Backend, Real> outliers_;
    BoundsTotal<Real> total_; ///< of the scene
    Real typical_radius_ = Real(0), largest_radius_ = Real(0);
    bool has_core_ = false;
    Vec3<int32_t> wanted_{0}; ///< the grid's size, were there no limit
    uint64_t cells_ = 0;
    bool is_coarsest_ = false; ///< the grid is one voxel, or one brick
    uint64_t link_room_ = 0;
    uint32_t brick_room_ = 0;
    uint64_t most_voxels_ = GridRule{}.most_voxels;
    std::array<bool, 2> has_seen_{}; ///< whole lists: without a cloud, with one
};

} // namespace proxima
