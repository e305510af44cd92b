// SPDX-License-Identifier: Apache-2.0
// The choice between grid and cloud as a user meets it: frames, --stats-json, and `proxima plan`.
#include "renderer/device_costs.h"
#include "renderer/method_choice.h"
#include "tests/bench/choice_scenes.h"
#include "tests/renderer/workplace.h"

#include <nlohmann/json.hpp>

using namespace proxima;
using namespace proxima::testing;

namespace {

constexpr const char* two_sheets = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 0.7, -1.5> look_at 0.5 }
light_source { <3, 5, -4>, rgb 1 }
#declare Stream = seed(1);
#for (I, 1, 6000)
  sphere { <rand(Stream), rand(Stream), 0.05 + 0.9 * mod(I, 2)>, 0.01 pigment { rgb 1 } }
#end
)";

nlohmann::json choice_of(const Workplace& work, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", "a.png", "--stats-json", "a.json"});
    const ProcessResult run = work.render(arguments);
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    return nlohmann::json::parse(work.content("a.json")).at("frames").at(0).at("choice");
}

nlohmann::json plan_of(const Workplace& work, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "plan");
    arguments.insert(arguments.end(), {"--device", "cpu", "--json"});
    const ProcessResult run = work.run(arguments);
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    return nlohmann::json::parse(run.standard_output).at("method");
}

/// Grid and cloud are close by these.
DeviceCosts close_costs() {
    DeviceCosts costs;
    costs.of.grid.ray = 1;
    costs.of.cloud.ray = 1.2;
    return costs;
}

} // namespace

TEST_CASE("method: a renderer tries what is close, and its pictures are the same") {
    const auto scene = bench::choice_scene(bench::SceneSet::fit, 2, 0.2);
    const auto choice = std::make_shared<MethodChoice>(close_costs());
    const auto renderer = make_cpu_renderer(0, choice), other = make_cpu_renderer(0, choice);
    for (FrameRenderer* each : {renderer.get(), other.get()})
        each->set_scene(scene.scene, Precision::float32);
    FrameSettings settings;
    settings.width = 64;
    settings.height = 36;
    Image first, image;
    for (int frame = 0; frame < 12; ++frame) {
        const FrameStatistics statistics = renderer->render(settings, frame == 0 ? first : image);
        CAPTURE(frame);
        const MethodReason reason = statistics.choice.reason;
        CHECK(reason == (frame < 5 ? MethodReason::prior : frame < 7 ? MethodReason::trial : reason));
        if (frame == 5)
            CHECK(statistics.method == "cloud");
        if (frame >= 9)
            CHECK(reason == MethodReason::measured);
        if (frame > 0)
            CHECK(image.rgb == first.rgb);
    }
    SUBCASE("another worker of the device knows it, too") {
        const FrameStatistics statistics = other->render(settings, image);
        CHECK(statistics.choice.reason == MethodReason::measured);
        CHECK(statistics.choice.measured.grid > 0);
        CHECK(statistics.choice.measured.cloud > 0);
        CHECK(image.rgb == first.rgb);
    }
    SUBCASE("where the lookups are in the file, every frame is chosen for as the first") {
        settings.aovs.steps = true;
        for (int frame = 0; frame < 8; ++frame)
            CHECK(renderer->render(settings, image).choice.reason == MethodReason::prior);
    }
    SUBCASE("bands of a picture are not timed") {
        settings.height = 64;
        for (int frame = 0; frame < 8; ++frame)
            for (const uint32_t row : {0u, 32u}) {
                const FrameStatistics statistics = renderer->render(settings.with_rows({row, 32}), image);
                CHECK(statistics.choice.reason == MethodReason::prior);
            }
    }
}

TEST_CASE("method: --stats-json says what was chosen, why, and what was known") {
    const Workplace work("method_test");
    work.write("sheets.scn", two_sheets);
    const nlohmann::json choice = choice_of(work, {"sheets.scn"});
    CHECK(choice.at("why") == "prior");
    CHECK(choice.at("mean_distance") > 1.5);
    CHECK(choice.at("occupied_bricks") < 0.5);
    CHECK(choice.at("grid").at("predicted_ms") > 0);
    CHECK(choice.at("cloud").at("predicted_ms") > 0);
    CHECK(choice.at("grid").at("measured_ms").is_null());
    CHECK(choice_of(work, {"sheets.scn", "--accel", "cloud"}).at("why") == "asked");
    CHECK(choice_of(work, {"sheets.scn", "--grid", "20"}).at("why") == "asked");
    const nlohmann::json few = choice_of(work, {"still.scn"});
    CHECK(few.at("why") == "few");
    CHECK(few.at("mean_distance").is_null());
}

TEST_CASE("method: plan counts lookups in a grid and a cloud that are built, and says what is picked") {
    const Workplace work("method_test");
    work.write("sheets.scn", two_sheets);
    const nlohmann::json plan = plan_of(work, {"sheets.scn", "--size", "320x180"});
    CHECK(plan.at("device") == "cpu");
    CHECK(says(plan.at("decision").get<std::string>(), "a look predicts that the cloud takes"));
    CHECK(plan.at("cloud_lookups_a_ray") < plan.at("grid_lookups_a_ray"));
    CHECK(plan.at("grid_references") >= 6000);
    CHECK(plan.at("grid_bytes") > 6000 * 8);
    for (const char* name : {"grid_build_ms", "grid_trace_ms", "cloud_map_ms", "cloud_frame_ms"})
        CHECK(plan.at(name) > 0);
    // More pixels cost more, by the rays that there are then, and the picked method is what a frame gets.
    const nlohmann::json large = plan_of(work, {"sheets.scn", "--size", "3200x1800"});
    CHECK(large.at("cloud_trace_ms").get<double>() > 90 * plan.at("cloud_trace_ms").get<double>());
    REQUIRE(work.run({"render", "sheets.scn", "--size", "320x180", "--device", "cpu", "-o", "a.png", "--stats-json",
                      "a.json"})
                .exit_code == 0);
    CHECK(plan.at("picked") == nlohmann::json::parse(work.content("a.json")).at("frames").at(0).at("method"));

    CHECK(plan_of(work, {"sheets.scn", "--accel", "cloud"}).at("decision") == "cloud: as asked for");
    CHECK(plan_of(work, {"still.scn"}).at("decision") == "brute: so few are tested one by one");
    CHECK(work.run({"plan", "still.scn", "--device", "nowhere"}).exit_code == 2);
}
