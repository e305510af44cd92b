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

/// Looks; `at_once`: at all that is wanted, otherwise at one plan at a time.
GridPlan look(PlanChooser& chooser, Costs& costs, bool at_once = true) {
    chooser.begin_look(1000);
    for (auto plans = chooser.wanted(); !plans.empty(); plans = chooser.wanted()) {
        plans.resize(at_once ? plans.size() : 1);
        std::vector<PlannedMethod> methods;
        for (const GridPlan& plan : plans)
            methods.push_back(costs(plan));
        chooser.see(methods);
    }
    const FramePlan seen = chooser.choose();
    CHECK(seen.methods[seen.picked].plan == chooser.choice());
    return chooser.choice();
}

} // namespace

TEST_CASE("plan chooser: finds each method's best resolution from where it begins, all at once or one by one") {
    for (const bool at_once : {true, false}) {
        for (const double at : {0.5, 1.0, 2.0, 4.0, 32.0}) {
            PlanChooser chooser;
            Costs costs{.grid_at = at, .cloud = 20};
            CHECK(look(chooser, costs, at_once) == chooser.grid_plan(at));
        }
        for (const double at : {2.0, 8.0, 32.0, 128.0, 2048.0}) {
            PlanChooser chooser;
            Costs costs{.cloud_at = at, .cloud = 5};
            CHECK(look(chooser, costs, at_once) == chooser.cloud_plan(at));
        }
    }
}

TEST_CASE("plan chooser: looks at no plan twice, and at six where the method's best is where it was") {
    PlanChooser chooser;
    Costs costs{.cloud = 11};
    look(chooser, costs);
    CHECK(costs.looks == 6);
    look(chooser, costs, false);
    CHECK(costs.looks == 12);
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

TEST_CASE("plan chooser: one by one it does not look for the best of clouds that are far too dear") {
    PlanChooser chooser;
    Costs costs{.cloud = 100};
    look(chooser, costs, false);
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

TEST_CASE("plan chooser: looks now and then, less often where nothing changes, and when there are many more primitives") {
    PlanChooser chooser;
    Costs costs{.cloud = 20};
    look(chooser, costs);
    const auto frames_to_next_look = [&] {
        for (uint32_t frame = 0;; ++frame)
            if (chooser.looks_on(1000)) {
                CHECK(chooser.looks_on(1000)); // until it is over
                return frame;
            }
    };
    CHECK(frames_to_next_look() == PlanChooser::interval - 1);
    look(chooser, costs);
    CHECK(frames_to_next_look() == 2 * PlanChooser::interval - 1);
    for (int i = 0; i < 5; ++i)
        look(chooser, costs);
    CHECK(frames_to_next_look() == PlanChooser::longest_interval - 1);
    costs.grid_at = 16;
    look(chooser, costs);
    CHECK(frames_to_next_look() == PlanChooser::interval - 1);
    look(chooser, costs);
    CHECK_FALSE(chooser.looks_on(1200));
    CHECK(chooser.looks_on(1300));
}

TEST_CASE("plan chooser: frames that take longer than foretold give a method up, and it is not tried again") {
    PlanChooser chooser;
    Costs costs{.grid = 8, .cloud = 10};
    CHECK_FALSE(look(chooser, costs).has_cloud());
    const auto frames = [&](double grid, double cloud) {
        std::vector<bool> clouds;
        for (int frame = 0; frame < 12; ++frame) {
            clouds.push_back(chooser.choice().has_cloud());
            chooser.time(clouds.back() ? cloud : grid);
        }
        return clouds;
    };
    // The device is half as fast as foretold, and grids are even slower: the cloud is tried, and stays.
    const std::vector<bool> kept{false, false, false, true, true, true, true, true, true, true, true, true};
    CHECK(frames(30, 20) == kept);
    CHECK(chooser.correction(false) == doctest::Approx(30.0 / 8));
    CHECK(chooser.correction(true) == doctest::Approx(2));
    CHECK(look(chooser, costs).has_cloud());
    costs.grid = 5; // foretold: 5 * 30 / 8 against 20
    CHECK_FALSE(look(chooser, costs).has_cloud());
}

TEST_CASE("plan chooser: the other method is tried for a few frames where it is in reach, and only there") {
    for (const double cloud : {10.0, 13.0}) {
        PlanChooser chooser;
        Costs costs{.grid = 8, .cloud = cloud};
        look(chooser, costs);
        int tried = 0;
        for (int frame = 0; frame < 40; ++frame) {
            tried += chooser.choice().has_cloud();
            chooser.time(chooser.choice().has_cloud() ? cloud : 8);
        }
        CHECK(tried == (cloud < 12 ? int(PlanChooser::timed_frames) : 0));
    }
}

TEST_CASE("plan chooser: frames that take much longer than before, three in a row, are a reason to look") {
    PlanChooser chooser;
    Costs costs{.grid = 8, .cloud = 100};
    look(chooser, costs);
    for (const double milliseconds : {8.0, 8.0, 8.0, 8.0, 20.0, 8.0, 20.0, 20.0}) {
        chooser.time(milliseconds);
        CHECK_FALSE(chooser.looks_on(1000));
    }
    chooser.time(20);
    CHECK(chooser.looks_on(1000));
}
