// SPDX-License-Identifier: Apache-2.0
// Looks ahead: what a frame would do with other grids and clouds than the one that was built. Pilot rays are traced
// once through what was built; then each plan's lookups and tests are counted along them, its lists' entries on a part
// of the primitives, and its bricks for what they are. Nothing waits for the device until the results are asked for.
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
    static constexpr uint32_t most_plans = CountWalk<Real>::most_plans; ///< at a time

    explicit FrameSurvey(Backend& backend)
        : backend_(backend), cloud_(backend), rays_(backend), counts_(backend), totals_(backend), seen_(backend) {}

    /// Starts to send the pilots out: a number that suits the picture, or `many`. The scene's grid must be complete.
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
        backend_.for_each(pattern_.pilots(), FindPilotRays<Real>{scene, pattern_, rays_.view()});
        pixels_ = samples_of(settings);
        light_share_ = pattern_.lights ? double(scene.lights.size()) / pattern_.lights : 1.0;
    }

    /// Starts to count what the pilots' frame would do with each of `plans`, at most most_plans.
    void look_at(const SceneView<Real>& scene, const GridBuilder<Backend, Real>& builder,
                 std::span<const GridPlan> plans) {
        begin(scene, builder, plans);
        counts_.resize(plans.size() * pattern_.rays());
        CountWalk<Real> grids{scene, rays_.view(), counts_.view(), {}};
        uint32_t grid_count = 0;
        for (uint32_t place = uint32_t(plans.size()); place-- > 0;) { // the finest first: memory is made once
            sample_links(scene.geometry, place);
            if (!plans[place].has_cloud()) {
                grids.plans[grid_count++] = {planned_[place], place};
                continue;
            }
            const SceneView<Real> with_cloud = map(scene, place);
            backend_.for_each(pattern_.rays(),
                              CountWalk<Real>{scene, rays_.view(), counts_.view(), {{with_cloud.grid, place}}});
        }
        backend_.for_each(grid_count * pattern_.rays(), grids);
        for (uint32_t place = 0; place < plans.size(); ++place)
            backend_.for_each(pattern_.rays() / pattern_.together,
                              SumWalks{pattern_, counts_.view().subspan(place * pattern_.rays(), pattern_.rays()),
                                       {&totals().walks[place], 1}});
        seen_.request(totals_);
    }
    /// Starts to measure the distances of a plan alone; see mean_distance().
    void look_at_distances(const SceneView<Real>& scene, const GridBuilder<Backend, Real>& builder,
                           const GridPlan& plan) {
        begin(scene, builder, {&plan, 1});
        map(scene, 0);
        seen_.request(totals_);
    }

    /// After a synchronize(): what was found, in the order of the plans.
    std::vector<PlannedMethod> methods() const {
        std::vector<PlannedMethod> methods;
        for (uint32_t place = 0; place < plans_.size(); ++place)
            methods.push_back(method(place));
        return methods;
    }
    /// After a synchronize(): over the empty bricks of the first plan.
    double mean_distance() const {
        const DistanceTotal& total = seen_.value().distances[0];
        return total.empty ? double(total.sum) / double(total.empty) : 0.0;
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

private:
    static constexpr uint32_t pixels_a_pilot = 1024, fewest_pilots = 512, most_pilots = 2048, many_pilots = 8192;
    static constexpr uint32_t most_lights = 4, most_surfaces = 3;
    static constexpr uint32_t sampled_primitives = 16384;
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    /// What is counted, of each plan.
    struct Totals {
        uint64_t links[most_plans]{};
        DistanceTotal distances[most_plans]{};
        WalkTotal walks[most_plans]{};
    };
    Totals& totals() { return totals_.view()[0]; } ///< the device's: for addresses

    void begin(const SceneView<Real>& scene, const GridBuilder<Backend, Real>& builder,
               std::span<const GridPlan> plans) {
        plans_.assign(plans.begin(), plans.end());
        planned_.clear();
        for (const GridPlan& plan : plans)
            planned_.emplace_back(builder.planned(scene.geometry.bounds, plan)).cloud.metric = plan.metric;
        primitives_ = scene.geometry.round_count();
        stride_ = std::max(1u, primitives_ / sampled_primitives);
        totals_.resize(1);
        totals_.fill_bytes(0);
    }

    void sample_links(const GeometryView<Real>& geometry, uint32_t place) {
        backend_.for_each(primitives_ / stride_,
                          SampleLinks<Real>{planned_[place], geometry, stride_, {&totals().links[place], 1}});
    }

    /// The scene with a planned cloud, whose distances last until the next one's.
    SceneView<Real> map(SceneView<Real> scene, uint32_t place) {
        scene.grid = planned_[place];
        cloud_.mark_planned(scene, plans_[place].metric);
        cloud_.measure(scene.grid.cloud, {&totals().distances[place], 1});
        return scene;
    }

    PlannedMethod method(uint32_t place) const {
        const Totals& totals = seen_.value();
        const GridView<Real>& grid = planned_[place];
        const DistanceTotal& distances = totals.distances[place];
        PlannedMethod method{.plan = plans_[place]};
        for (int i = 0; i < 3; ++i)
            method.size[i] = uint32_t(grid.size[i]);
        FrameWork& work = method.work;
        work.primitives = primitives_;
        work.pixels = pixels_;
        work.links = double(totals.links[place]) * primitives_ / (primitives_ / stride_);
        work.cells = double(grid.cell_count());
        if (method.plan.has_cloud()) {
            work.bricks = double(grid.cloud.brick_count());
            work.distances = double(distances.sum) / grid.cloud.map_count();
            method.occupied_bricks = work.bricks - double(distances.empty) / grid.cloud.map_count();
            method.mean_distance = distances.empty ? double(distances.sum) / double(distances.empty) : 0.0;
            work.cells = std::ldexp(method.occupied_bricks, 3 * grid.cloud.shift);
        }
        add(work.mean, totals.walks[place].all, 1.0);
        add(work.together, totals.walks[place].slowest, pattern_.together);
        const double maps = work.bricks > 0 ? 2 * grid.cloud.map_count() : 0;
        method.bytes =
            uint64_t(work.cells * sizeof(uint32_t) + work.links * sizeof(GridLink) +
                     work.primitives * sizeof(uint32_t) + work.bricks * (1.0 / 8 + sizeof(uint32_t) + maps));
        return method;
    }
    /// Of a pixel; rays to lights stand for those to the lights that were not looked at.
    void add(FrameWork::Walk& walk, const WalkTotal::Part (&parts)[2], double weight) const {
        for (int to_light = 0; to_light < 2; ++to_light) {
            const double each = weight * (to_light ? light_share_ : 1.0) / pattern_.pilots();
            walk.lookups += each * double(parts[to_light].lookups);
            walk.tests += each * double(parts[to_light].tests);
        }
    }

    Backend& backend_;
    CloudBuilder<Backend, Real> cloud_;
    Buffer<PilotRay<Real>> rays_;
    Buffer<WalkCount> counts_; ///< of each plan
    Buffer<Totals> totals_;    ///< one
    typename Backend::template Receipt<Totals> seen_;
    std::vector<GridPlan> plans_;
    std::vector<GridView<Real>> planned_;
    PilotPattern pattern_;
    uint32_t primitives_ = 0, stride_ = 1;
    double pixels_ = 0;
    double light_share_ = 1; ///< lights over those that pilots look at
};

} // namespace proxima
