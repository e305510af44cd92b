// SPDX-License-Identifier: Apache-2.0
// A frame's grid or cloud: the one that is asked for, or the one that is chosen, now and then, by looking ahead: at a
// first frame all at once, later a plan a frame, which nobody waits for.
#pragma once
#include "renderer/frame_survey.h"
#include "renderer/grid_builder.h"
#include "renderer/plan_chooser.h"

#include <utility>

namespace proxima {

template <class Backend, class Real> class PlannedGrid {
public:
    enum class Look { when_due, around, at_everything };

    explicit PlannedGrid(Backend& backend) : backend_(backend), builder_(backend), survey_(backend) {}

    /// Another scene follows. It may be the next frame of the same film: a choice is kept, see PlanChooser.
    void forget() { builder_.forget(); }

    /// Starts to build for a scene whose primitives are where they are to be. `step(name, work)` takes the steps.
    template <class Step>
    void build(SceneView<Real>& scene, const SceneNeeds& needs, const FrameSettings& settings, Look how,
               const Step& step) {
        const bool uses_grid = wants_grid(settings, scene);
        const bool is_asked_for = settings.grid[0] != 0 || settings.density != 0;
        take_over_look();
        is_chosen_ = false;
        if (!is_asked_for)
            allow_methods(settings, how);
        const bool is_known = is_asked_for || chooser_.has_choice();
        const bool looks_now =
            uses_grid && (how != Look::when_due || (!is_asked_for && (!is_known || chooser_.is_first_look())));
        if (is_asked_for || looks_now)
            plan_ = {};
        if (is_known)
            built_ = is_asked_for ? asked_for(settings) : chooser_.choice();
        step(FrameStep::build, [&] {
            builder_.find_bounds(scene.geometry);
            if (uses_grid && is_known)
                builder_.build(scene, built_, looks_now);
        });
        if (!uses_grid || !builder_.has_bounded())
            return;
        if (!is_known) {
            step(FrameStep::choose, [&] { begin(scene); });
            build_again(scene, step);
        } else {
            map(scene, step);
        }
        if (looks_now && is_asked_for && how != Look::when_due)
            step(FrameStep::choose, [&] { look_at_built(scene, needs, settings); });
        else if (looks_now && !is_asked_for)
            look_around(scene, needs, settings, how, step);
        else if (!is_asked_for && chooser_.looks_on(scene.geometry.round_count()))
            step(FrameStep::choose, [&] { look_on(scene, needs, settings); });
        is_chosen_ = !is_asked_for && !looks_now;
    }
    /// What the frame that was built last took to build and to trace. Where the file shows the choice, clocks have no
    /// part in it, since every frame chooses anew.
    void time(double milliseconds) {
        if (std::exchange(is_chosen_, false))
            chooser_.time(milliseconds);
    }

    /// As those of GridBuilder.
    bool is_complete() {
        const bool whole = builder_.is_complete();
        looks_on_ = looks_on_ && whole; // pilots have seen nothing else
        return whole;
    }
    void report(const GridView<Real>& grid, FrameStatistics& statistics) const {
        builder_.report(grid, statistics);
        for (const PlannedMethod& method : plan_.methods)
            if (grid.in_use() && method.plan == built_)
                statistics.predicted_ms = method.cost.total() * chooser_.correction(method.plan.has_cloud());
    }
    /// As seen last.
    const FramePlan& plan() const { return plan_; }

private:
    static constexpr double far_apart = 3.5; ///< mean distance from which on a cloud is built first

    /// A handful of primitives is tested faster than a grid is walked.
    static bool wants_grid(const FrameSettings& settings, const SceneView<Real>& scene) {
        constexpr uint32_t few = 8;
        const Accelerator asked = settings.accelerator;
        return asked == Accelerator::grid || asked == Accelerator::cloud ||
               (asked == Accelerator::automatic && scene.geometry.round_count() > few);
    }

    /// A size that is asked for is a grid's unless a cloud is, too.
    static GridPlan asked_for(const FrameSettings& settings) {
        const bool has_cloud = settings.accelerator == Accelerator::cloud;
        GridPlan plan{.size = settings.grid, .metric = settings.metric};
        if (has_cloud)
            plan.brick = brick_of(settings);
        plan.voxels_per_primitive = settings.density != 0 ? settings.density
                                    : has_cloud           ? PlanChooser::first_cloud
                                                          : PlanChooser::first_grid;
        return plan;
    }
    static uint32_t brick_of(const FrameSettings& settings) { return settings.brick ? settings.brick : 4; }

    void allow_methods(const FrameSettings& settings, Look how) {
        const Accelerator asked = settings.accelerator;
        chooser_.allow({.grid = asked != Accelerator::cloud,
                        .cloud = asked != Accelerator::grid,
                        .brick = brick_of(settings),
                        .metric = settings.metric,
                        .pixels = FrameSurvey<Backend, Real>::samples_of(settings)});
        // Where the file shows the choice it must not depend on the frames before.
        if (settings.aovs.steps || how != Look::when_due)
            chooser_.forget();
        if (!chooser_.has_choice() && asked != Accelerator::automatic)
            chooser_.start_with(asked == Accelerator::cloud ? chooser_.cloud_plan() : chooser_.grid_plan());
    }

    /// Before anything was looked at, what lies between the primitives tells what to begin with.
    void begin(const SceneView<Real>& scene) {
        survey_.look_at_distances(scene, builder_, chooser_.cloud_plan());
        backend_.synchronize();
        built_ = survey_.mean_distance() >= far_apart ? chooser_.cloud_plan() : chooser_.grid_plan();
        chooser_.start_with(built_);
    }

    template <class Step> void build_again(SceneView<Real>& scene, const Step& step) {
        step(FrameStep::build, [&] { builder_.build(scene, built_, true); });
        map(scene, step);
    }
    template <class Step> void map(SceneView<Real>& scene, const Step& step) {
        if (scene.grid.cloud.in_use())
            step(FrameStep::map, [&] { builder_.build_distances(scene); });
    }

    /// What the device takes for what was counted.
    std::vector<PlannedMethod> priced_methods() const {
        std::vector<PlannedMethod> methods = survey_.methods();
        for (PlannedMethod& method : methods)
            method.cost = backend_.costs().of(method.plan).cost(method.work);
        return methods;
    }

    /// Chooses anew, by what the frame would do with other grids and clouds, and waits for that. This frame is made
    /// with the choice only if building it a second time pays at once.
    template <class Step>
    void look_around(SceneView<Real>& scene, const SceneNeeds& needs, const FrameSettings& settings, Look how,
                     const Step& step) {
        step(FrameStep::choose, [&] {
            survey_.send_pilots(scene, needs, settings, how == Look::at_everything);
            chooser_.begin_look(scene.geometry.round_count(), how == Look::at_everything);
            for (auto plans = chooser_.wanted(); !plans.empty(); plans = chooser_.wanted()) {
                plans.resize(std::min<size_t>(plans.size(), survey_.most_plans));
                survey_.look_at(scene, builder_, plans);
                backend_.synchronize();
                chooser_.see(priced_methods());
            }
            plan_ = chooser_.choose();
        });
        const PlannedMethod& picked = plan_.methods[plan_.picked];
        for (const PlannedMethod& method : plan_.methods)
            if (method.plan == built_ && picked.cost.total() < method.cost.trace && picked.plan != built_) {
                built_ = picked.plan;
                return build_again(scene, step);
            }
    }
    /// The same for one plan of many, without waiting: the next frame takes over what was found.
    void look_on(const SceneView<Real>& scene, const SceneNeeds& needs, const FrameSettings& settings) {
        survey_.send_pilots(scene, needs, settings);
        const std::vector<GridPlan> wanted = chooser_.wanted();
        survey_.look_at(scene, builder_, {wanted.data(), 1});
        looks_on_ = true;
    }
    void take_over_look() {
        if (!std::exchange(looks_on_, false) || !chooser_.is_looking())
            return;
        chooser_.see(priced_methods());
        if (chooser_.wanted().empty())
            plan_ = chooser_.choose();
    }
    /// What is foretold of the grid that was asked for.
    void look_at_built(const SceneView<Real>& scene, const SceneNeeds& needs, const FrameSettings& settings) {
        survey_.send_pilots(scene, needs, settings);
        survey_.look_at(scene, builder_, {&built_, 1});
        backend_.synchronize();
        plan_ = {.methods = priced_methods()};
    }

    Backend& backend_;
    GridBuilder<Backend, Real> builder_;
    FrameSurvey<Backend, Real> survey_;
    PlanChooser chooser_;
    GridPlan built_;
    FramePlan plan_;
    bool is_chosen_ = false; ///< and nothing else: what the last frame was built with
    bool looks_on_ = false;  ///< the survey's results are to be taken over
};

} // namespace proxima
