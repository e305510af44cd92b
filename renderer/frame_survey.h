// SPDX-License-Identifier: Apache-2.0
// Looks ahead: what a frame would do with another grid or cloud than the one that was built. Pilot rays are traced once
// through what was built; then each plan's lookups and tests are counted along them, its lists' entries on a part of
// the primitives, and its bricks for what they are.
#pragma once
#include "kernels/pilot.h"
#include "renderer/cloud_builder.h"
#include "renderer/frame_cost.h"
#include "renderer/frame_renderer.h"
#include "renderer/grid_builder.h"
#include "renderer/scene_needs.h"

#include <algorithm>
#include <vector>

namespace proxima {

template <class Backend, class Real> class FrameSurvey {
public:
    explicit FrameSurvey(Backend& backend)
        : backend_(backend), cloud_(backend), brick_counts_(backend), rays_(backend), counts_(backend) {}

    /// Sends the pilots out: a number that suits the picture, or `many`. The scene's grid must be complete.
    void send_pilots(const SceneView<Real>& scene, const SceneNeeds& needs, const FrameSettings& settings,
                     bool many = false) {
        const uint64_t pixels = uint64_t(settings.width) * settings.height;
        pattern_ = {.width = settings.width, .height = settings.height};
        const uint64_t suiting = std::clamp<uint64_t>(pixels / pixels_a_pilot, fewest_pilots, most_pilots);
        pattern_.tiles = (many ? many_pilots : uint32_t(suiting)) / pattern_.together;
        pattern_.surfaces = needs.features == Features::opaque ? 1 : std::min(most_surfaces, scene.max_trace_level);
        pattern_.surfaces = std::max(1u, pattern_.surfaces);
        pattern_.lights = std::min(most_lights, uint32_t(scene.lights.size()));
        rays_.resize(pattern_.rays());
        counts_.resize(pattern_.rays());
        backend_.for_each(pattern_.pilots(), FindPilotRays<Real>{scene, pattern_, rays_.view()});
        pixels_ = samples_of(settings);
        light_share_ = pattern_.lights ? double(scene.lights.size()) / pattern_.lights : 1.0;
    }

    /// What the frame would do with `plan`. Waits for the device.
    PlannedMethod look_at(const SceneView<Real>& scene, const GridBuilder<Backend, Real>& builder,
                          const GridPlan& plan) {
        PlannedMethod method{.plan = plan};
        SceneView<Real> planned = scene;
        planned.grid = builder.planned(scene.geometry.bounds, plan);
        const GridView<Real>& grid = planned.grid;
        for (int i = 0; i < 3; ++i)
            method.size[i] = uint32_t(grid.size[i]);
        method.work = {.primitives = double(scene.geometry.round_count()),
                       .cells = double(grid.cell_count()),
                       .links = links(planned),
                       .pixels = pixels_};
        if (plan.has_cloud())
            map(planned, method);
        count(scene, planned.grid, method.work);
        method.bytes = bytes(grid, method.work);
        return method;
    }

    /// The mean distance over the empty bricks that `plan` would have. Waits for the device.
    double mean_distance(const SceneView<Real>& scene, const GridBuilder<Backend, Real>& builder,
                         const GridPlan& plan) {
        PlannedMethod method;
        SceneView<Real> planned = scene;
        planned.grid = builder.planned(scene.geometry.bounds, plan);
        map(planned, method);
        return method.mean_distance;
    }

    /// Camera rays of a frame; adaptive antialiasing is taken to double them. Where the file shows the choice, it is
    /// made for one ray a pixel.
    static double samples_of(const FrameSettings& settings) {
        using Method = Antialiasing::Method;
        const Antialiasing& antialiasing = settings.antialiasing;
        const double samples = settings.aovs.steps                   ? 1
                               : antialiasing.method == Method::none ? settings.samples
                               : antialiasing.method == Method::grid ? antialiasing.depth * antialiasing.depth + 1
                                                                     : 2;
        return samples * settings.width * settings.height;
    }

    /// Gives the memory back.
    void free() {
        cloud_.free();
        rays_.free();
        counts_.free();
    }

private:
    static constexpr uint32_t pixels_a_pilot = 512, fewest_pilots = 512, most_pilots = 2048, many_pilots = 8192;
    static constexpr uint32_t most_lights = 4, most_surfaces = 3;
    static constexpr uint32_t sampled_primitives = 16384;
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    double links(const SceneView<Real>& planned) {
        const uint32_t primitives = planned.geometry.round_count();
        const uint32_t stride = std::max(1u, primitives / sampled_primitives), sampled = primitives / stride;
        const LinkTotal total =
            backend_.template reduce<LinkTotal>(sampled, SampleLinks<Real>{planned.grid, planned.geometry, stride});
        return double(total.links) * primitives / sampled;
    }

    void map(SceneView<Real>& planned, PlannedMethod& method) {
        brick_counts_.resize(1);
        brick_counts_.fill_bytes(0);
        cloud_.mark(planned, method.plan.metric, brick_counts_.view());
        cloud_.measure(planned.grid.cloud);
        seen_counts_.request(brick_counts_);
        backend_.synchronize();
        method.mean_distance = cloud_.mean_distance();
        method.occupied_bricks = seen_counts_.value().bricks;
        method.work.bricks = double(planned.grid.cloud.brick_count());
        method.work.distances = method.mean_distance * (method.work.bricks - method.occupied_bricks);
        method.work.cells = std::ldexp(method.occupied_bricks, 3 * planned.grid.cloud.shift);
    }

    void count(const SceneView<Real>& scene, const GridView<Real>& planned, FrameWork& work) {
        backend_.for_each(pattern_.rays(), CountWalk<Real>{scene, planned, rays_.view(), counts_.view()});
        walks_.resize(pattern_.rays());
        counts_.download(walks_.data());
        const uint32_t group = pattern_.together;
        for (uint32_t first = 0; first < pattern_.rays(); first += group) {
            const bool to_light = first / pattern_.pilots() % (1 + pattern_.lights) > 0;
            const double weight = (to_light ? light_share_ : 1.0) / pattern_.pilots();
            const WalkCount* slowest = &walks_[first];
            for (uint32_t i = first; i < first + group; ++i) {
                add(work.mean, walks_[i], weight);
                if (walks_[i].sum() > slowest->sum())
                    slowest = &walks_[i];
            }
            add(work.together, *slowest, weight * group);
        }
    }
    static void add(FrameWork::Walk& walk, const WalkCount& count, double weight) {
        walk.lookups += weight * count.lookups;
        walk.tests += weight * count.tests;
    }

    static uint64_t bytes(const GridView<Real>& grid, const FrameWork& work) {
        const double maps = work.bricks > 0 ? 2 * grid.cloud.map_count() : 0;
        return uint64_t(work.cells * sizeof(uint32_t) + work.links * sizeof(GridLink) +
                        work.primitives * sizeof(uint32_t) + work.bricks * (1 + sizeof(uint32_t) + maps));
    }

    Backend& backend_;
    CloudBuilder<Backend, Real> cloud_;
    Buffer<GridCounts> brick_counts_;
    typename Backend::template Receipt<GridCounts> seen_counts_{backend_};
    Buffer<PilotRay<Real>> rays_;
    Buffer<WalkCount> counts_;
    std::vector<WalkCount> walks_;
    PilotPattern pattern_;
    double pixels_ = 0;
    double light_share_ = 1; ///< lights over those that pilots look at
};

} // namespace proxima
