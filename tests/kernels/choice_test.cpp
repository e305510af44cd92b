// SPDX-License-Identifier: Apache-2.0
// How well the choice between grids and clouds is made, without a clock: what pilots foretell against what the rays of
// the frame really do in grids and clouds that were really built, both times the devices' coefficients.
#include "renderer/backend_cpu.h"
#include "renderer/device_scene.h"
#include "renderer/frame_survey.h"
#include "renderer/plan_chooser.h"
#include "tests/bench/choice_scenes.h"

#include <doctest/doctest.h>

using namespace proxima;
using namespace proxima::bench;

namespace {

/// Passes on what it is shown, and counts it.
template <class Visitor> struct Counting {
    Visitor& visitor;
    uint32_t tests = 0;

    bool meet(uint32_t id) {
        ++tests;
        return visitor.meet(id);
    }
    bool meet_sphere(uint32_t id) {
        ++tests;
        return visitor.meet_sphere(id);
    }
    bool is_done(float reached) const { return visitor.is_done(reached); }
};

/// Pixel -> what its rays really do: the camera's, and one to each light.
struct CountFrame {
    static constexpr uint32_t most_parts = 4;

    SceneView<float> scene;
    FilmView film;
    std::span<const PixelPosition> pixels;
    std::span<WalkCount> counts; ///< part by part

    void operator()(uint32_t index) const {
        const SourcedRay<float> ray{pixel_ray(camera_in<float>(scene.camera), film, pixels[index], 0), {}};
        const BasedRay<float> based = rebase(ray, scene.geometry.bounds);
        NearestHit<float> nearest({scene, based, 0 - based.offset}, 0, infinity<float>);
        walk(index, 0, based, nearest);
        const Hit<float> hit = nearest.best();
        if (hit.primitive == no_primitive)
            return;
        const Surface<float> surface = surface_at(scene, ray, based, hit);
        for (uint32_t i = 0; i < scene.lights.size(); ++i) {
            const LightRay<float> way = straight_light_ray(surface.point, scene.lights[i].position);
            if (!(glm::dot(surface.normal, way.direction) > 0))
                continue;
            const auto to_light = leave<float>(scene.geometry, surface, way.direction, surface.from_inside);
            const BasedRay<float> from = rebase(to_light, scene.geometry.bounds);
            AnyHit<float> any({scene, from, 0 - from.offset}, way.distance - from.offset);
            walk(index, 1 + i, from, any);
        }
    }

private:
    template <class Visitor>
    void walk(uint32_t index, uint32_t part, const BasedRay<float>& ray, Visitor& visitor) const {
        if (!ray.meets_bounds)
            return;
        Counting<Visitor> counting{visitor};
        const uint32_t lookups = proxima::walk<RoundShapes::spheres>(scene.grid, ray.ray, counting);
        counts[part * pixels.size() + index] = {lookups, counting.tests};
    }
};

/// A scene on the CPU, rendered in no other way than by counting.
class CountedScene {
public:
    explicit CountedScene(const SceneProgram& program)
        : scene_(backend_), builder_(backend_), survey_(backend_), counts_(backend_) {
        scene_.upload(program);
        view_ = scene_.view();
        builder_.find_bounds(view_.geometry);
        settings_.width = 1920;
        settings_.height = 1080;
        // Every other pixel of tiles all over the picture, then the others of them: groups as the pilots have.
        PilotPattern pattern{.width = settings_.width, .height = settings_.height, .tiles = 1};
        const PixelPosition corner = pattern.pixel(0);
        for (uint32_t y = 0; y + 72 <= settings_.height; y += 72)
            for (uint32_t x = 0; x + 64 <= settings_.width; x += 64)
                for (uint32_t i = 0; i < pattern.together; ++i) {
                    const PixelPosition pixel = pattern.pixel(i);
                    pixels_.push_back({x + pixel.x - corner.x, y + pixel.y - corner.y});
                }
    }

    /// As FramePipeline does: what is chosen for a first frame.
    GridPlan choose(const CostCoefficients& costs) {
        PlanChooser chooser;
        survey_.look_at_distances(view_, builder_, chooser.cloud_plan());
        chooser.start_with(survey_.mean_distance() >= 3.5 ? chooser.cloud_plan() : chooser.grid_plan());
        build(chooser.choice());
        survey_.send_pilots(view_, scene_.needs(), settings_);
        chooser.begin_look(view_.geometry.round_count());
        for (auto plans = chooser.wanted(); !plans.empty(); plans = chooser.wanted()) {
            survey_.look_at(view_, builder_, plans);
            auto methods = survey_.methods();
            for (PlannedMethod& method : methods)
                method.cost = costs.of(method.plan).cost(method.work);
            chooser.see(methods);
        }
        chooser.choose();
        return chooser.choice();
    }

    /// What a frame really does with `plan`.
    FrameWork work(const GridPlan& plan) {
        build(plan);
        FrameStatistics statistics;
        builder_.report(view_.grid, statistics);
        const double primitives = double(view_.geometry.round_count());
        FrameWork work{.primitives = primitives,
                       .cells = double(view_.grid.cell_count()),
                       .links = double(statistics.references),
                       .pixels = double(settings_.width) * settings_.height};
        if (plan.has_cloud()) {
            const CloudView& cloud = view_.grid.cloud;
            uint32_t occupied = 0;
            for (uint32_t i = 0; i < cloud.brick_count(); ++i)
                occupied += cloud.distances[i] == 0;
            work.bricks = cloud.brick_count();
            work.cells = 64.0 * occupied;
            work.distances = statistics.mean_distance * (work.bricks - occupied);
        }
        const uint32_t parts = 1 + uint32_t(view_.lights.size()), count = uint32_t(pixels_.size());
        counts_.resize(size_t(parts) * count);
        counts_.fill_bytes(0);
        const FilmView film{.pixels = {}, .width = settings_.width, .height = settings_.height};
        backend_.for_each(count, CountFrame{view_, film, pixels_, counts_.view()});
        for (uint32_t first = 0; first < parts * count; first += PilotPattern::together) {
            const auto group = counts_.view().subspan(first, PilotPattern::together);
            for (const WalkCount& each : group)
                add(work.mean, each, 1.0 / count);
            add(work.together,
                *std::max_element(group.begin(), group.end(),
                                  [](const WalkCount& a, const WalkCount& b) { return a.sum() < b.sum(); }),
                double(PilotPattern::together) / count);
        }
        return work;
    }
    PlannedMethod foretold(const GridPlan& plan) {
        survey_.send_pilots(view_, scene_.needs(), settings_);
        survey_.look_at(view_, builder_, {&plan, 1});
        return survey_.methods().front();
    }

private:
    static void add(FrameWork::Walk& walk, const WalkCount& count, double weight) {
        walk.lookups += weight * count.lookups;
        walk.tests += weight * count.tests;
    }
    void build(const GridPlan& plan) {
        builder_.build(view_, plan, true);
        if (plan.has_cloud())
            builder_.build_distances(view_);
    }

    CpuBackend backend_;
    DeviceScene<CpuBackend, float> scene_;
    GridBuilder<CpuBackend, float> builder_;
    FrameSurvey<CpuBackend, float> survey_;
    CpuBackend::Buffer<WalkCount> counts_;
    SceneView<float> view_;
    FrameSettings settings_;
    std::vector<PixelPosition> pixels_;
};

std::vector<GridPlan> all_plans() {
    std::vector<GridPlan> plans;
    const PlanChooser chooser;
    for (double density = PlanChooser::coarsest_grid; density <= PlanChooser::finest_grid; density *= 2)
        plans.push_back(chooser.grid_plan(density));
    for (double density = PlanChooser::coarsest_cloud; density <= PlanChooser::finest_cloud; density *= 4)
        plans.push_back(chooser.cloud_plan(density));
    return plans;
}

} // namespace

TEST_CASE("choice: little is lost to the better of grid and cloud, in scenes that nothing was fitted on") {
    const struct {
        const char* name;
        CostCoefficients costs;
    } devices[] = {{"cpu", cpu_costs}, {"cuda", cuda_costs}};
    double sums[2]{};
    const size_t scenes = choice_scene_count(SceneSet::test);
    REQUIRE(scenes >= 40);
    for (size_t place = 0; place < scenes; ++place) {
        const ChoiceScene chosen = choice_scene(SceneSet::test, place, 0.5);
        CAPTURE(chosen.name);
        CountedScene scene(chosen.scene);
        std::vector<std::pair<GridPlan, FrameWork>> works;
        for (const GridPlan& plan : all_plans())
            works.emplace_back(plan, scene.work(plan));
        for (int device = 0; device < 2; ++device) {
            CAPTURE(devices[device].name);
            const CostCoefficients& costs = devices[device].costs;
            const GridPlan choice = scene.choose(costs);
            double least = infinity<double>, taken = 0;
            for (const auto& [plan, work] : works) {
                const double cost = costs.of(plan).cost(work).total();
                least = std::min(least, cost);
                if (plan == choice)
                    taken = cost;
            }
            REQUIRE(taken > 0);
            CHECK(taken <= 1.15 * least);
            sums[device] += taken / least - 1;
        }
    }
    for (int device = 0; device < 2; ++device) {
        CAPTURE(devices[device].name);
        CHECK(sums[device] / double(scenes) <= 0.03);
    }
}

TEST_CASE("choice: what is foretold of a frame comes true, through whatever grid the pilots went") {
    for (const size_t place : {0, 5, 12, 25, 43}) {
        const ChoiceScene chosen = choice_scene(SceneSet::test, place, 0.5);
        CAPTURE(chosen.name);
        CountedScene scene(chosen.scene);
        for (const GridPlan& plan : all_plans()) {
            CAPTURE(plan.has_cloud());
            CAPTURE(plan.voxels_per_primitive);
            const FrameWork work = scene.work(plan);
            const PlannedMethod through_itself = scene.foretold(plan);
            scene.work({});
            const PlannedMethod foretold = scene.foretold(plan);
            CHECK(foretold.work.mean.lookups == through_itself.work.mean.lookups);
            CHECK(foretold.work.mean.tests == doctest::Approx(through_itself.work.mean.tests).epsilon(1e-3));
            CHECK(foretold.work.mean.lookups == doctest::Approx(work.mean.lookups).epsilon(0.12));
            CHECK(foretold.work.together.lookups == doctest::Approx(work.together.lookups).epsilon(0.18));
            CHECK(foretold.work.mean.tests == doctest::Approx(work.mean.tests).epsilon(0.25));
            CHECK(foretold.work.links == doctest::Approx(work.links).epsilon(0.05));
            CHECK(foretold.work.cells == work.cells);
            CHECK(foretold.work.bricks == work.bricks);
            CHECK(foretold.work.distances == doctest::Approx(work.distances));
        }
    }
}
