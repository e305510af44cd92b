// SPDX-License-Identifier: Apache-2.0
// What the choice between grid and cloud loses, without a clock: frames take what is counted in grids and clouds that
// are built and walked, times the devices' costs.
#include "renderer/device_costs.h"
#include "renderer/frame_renderer.h"
#include "renderer/method_choice.h"
#include "tests/bench/choice_scenes.h"
#include "tests/bench/choice_table.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace proxima;
using namespace proxima::bench;

namespace {

/// The work of frames of a scene by both methods, and what a look finds there; rays as in a picture of 1920x1080.
ChoiceRow count(const ChoiceScene& scene) {
    const auto renderer = make_cpu_renderer(0);
    renderer->set_scene(scene.scene, Precision::float32);
    FrameSettings settings;
    settings.width = 128;
    settings.height = 72;
    settings.aovs.steps = true;
    ChoiceRow row;
    row.scene = scene.name;
    Image image;
    row.space = renderer->render(settings, image).choice.space;
    for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud}) {
        settings.accelerator = method == SearchMethod::grid ? Accelerator::grid : Accelerator::cloud;
        const FrameStatistics statistics = renderer->render(settings, image);
        double lookups = 0;
        for (const AovSample& sample : image.aovs)
            lookups += sample.steps;
        row.of[method].work = {.primitives = double(scene.scene.spheres.size()),
                               .references = double(statistics.references),
                               .voxels = double(statistics.grid[0]) * statistics.grid[1] * statistics.grid[2],
                               .rays = 1920 * 1080,
                               .lookups = lookups / double(image.aovs.size())};
    }
    row.of.cloud.work.voxels = 64.0 * double(row.space.bricks - row.space.empty);
    row.of.cloud.work.bricks = double(row.space.bricks);
    return row;
}

/// Marks and distances of a cloud, without lists.
double look_ms(const MethodCosts& costs, const ChoiceRow& row) {
    return costs.build_ms + costs.map({.bricks = double(row.space.bricks)}) +
           1e-6 * costs.primitive * double(row.space.primitives);
}

} // namespace

TEST_CASE("method choice: over scenes that nothing was fitted to, little is lost to the better method") {
    REQUIRE(choice_scene_count(SceneSet::test) >= 40);
    std::vector<ChoiceRow> rows;
    for (size_t i = 0; i < choice_scene_count(SceneSet::test); ++i)
        rows.push_back(count(choice_scene(SceneSet::test, i, 0.5)));
    uint32_t by_cloud = 0;
    for (DeviceCosts costs : {cpu_costs, cuda_costs}) {
        costs.fewest = 0;
        double sum = 0, worst = 0;
        for (ChoiceRow& row : rows) {
            for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud})
                row.of[method].frame_ms = costs.of[method].frame(row.of[method].work);
            const double ms = simulated_ms(costs, row, look_ms(costs.of.cloud, row), 120);
            const double loss = ms / row.best_ms() - 1;
            INFO(fmt::format("{}: {:.1f} %", row.scene, 100 * loss));
            CHECK(loss <= 0.15);
            CHECK(loss > 0); // looks are counted in
            sum += loss;
            worst = std::max(worst, loss);
            by_cloud += row.of.cloud.frame_ms < row.of.grid.frame_ms;
        }
        MESSAGE(
            fmt::format("loss {:.2f} % in the mean, {:.1f} % at worst", 100 * sum / double(rows.size()), 100 * worst));
        CHECK(sum / double(rows.size()) <= 0.03);
    }
    CHECK(by_cloud >= 5); // of 92: there is something to choose
}
