// SPDX-License-Identifier: Apache-2.0
#include "renderer/plan_chooser.h"

#include <doctest/doctest.h>

using namespace proxima;

namespace {

/// A scene whose costs are parabolas over the resolution, least at these.
struct Costs {
    double grid_at = 2, grid = 10, cloud_at = 32, cloud = 10;
    int looks = 0;

    PlannedMethod operator()(const GridPlan& plan) {
        ++looks;
        const double off = std::log2(plan.voxels_per_primitive / (plan.has_cloud() ? cloud_at : grid_at));
        return {.plan = plan, .cost = {0, 0, (plan.has_cloud() ? cloud : grid) * (1 + 0.05 * off * off)}};
    }
};

GridPlan look(PlanChooser& chooser, Costs& costs) {
    const FramePlan seen = chooser.look([&](const GridPlan& plan) { return costs(plan); });
    CHECK(seen.methods[seen.picked].plan == chooser.choice());
    return chooser.choice();
}

} // namespace

TEST_CASE("plan chooser: finds each method's best resolution from where it begins") {
    for (const double at : {0.5, 1.0, 2.0, 4.0, 32.0}) {
        PlanChooser chooser;
        Costs costs{.grid_at = at, .cloud = 20};
        CHECK(look(chooser, costs) == chooser.grid_plan(at));
    }
    for (const double at : {2.0, 8.0, 32.0, 128.0, 2048.0}) {
        PlanChooser chooser;
        Costs costs{.cloud_at = at, .cloud = 5};
        CHECK(look(chooser, costs) == chooser.cloud_plan(at));
    }
}

TEST_CASE("plan chooser: stays with its choice until another one is clearly cheaper") {
    PlanChooser chooser;
    Costs costs{.cloud = 9};
    CHECK(look(chooser, costs).has_cloud());
    costs.grid = 8.9;
    CHECK(look(chooser, costs).has_cloud());
    costs.grid = 8;
    CHECK_FALSE(look(chooser, costs).has_cloud());
    costs.cloud = 7.9;
    CHECK_FALSE(look(chooser, costs).has_cloud());
}

TEST_CASE("plan chooser: does not look for the best of clouds that are far too dear") {
    PlanChooser chooser;
    Costs costs{.cloud = 100};
    look(chooser, costs);
    CHECK(costs.looks == 4); // three grids and a cloud
}

TEST_CASE("plan chooser: looks at what is allowed only, and anew when that changes") {
    PlanChooser chooser;
    Costs costs{.cloud = 5};
    chooser.allow({.cloud = false});
    CHECK_FALSE(look(chooser, costs).has_cloud());
    chooser.allow({.grid = false, .brick = 2, .metric = Metric::octant});
    CHECK_FALSE(chooser.has_choice());
    const GridPlan plan = look(chooser, costs);
    CHECK(plan.brick == 2);
    CHECK(plan.metric == Metric::octant);
}

TEST_CASE("plan chooser: looks at the first frame, now and then, and when there are many more primitives or less") {
    PlanChooser chooser;
    CHECK(chooser.is_due(1000));
    for (uint32_t frame = 1; frame < PlanChooser::interval; ++frame)
        CHECK_FALSE(chooser.is_due(1000 + frame));
    CHECK(chooser.is_due(1000));
    CHECK_FALSE(chooser.is_due(1200));
    CHECK(chooser.is_due(1300));
    CHECK_FALSE(chooser.is_due(1100));
    CHECK(chooser.is_due(1000));
}
