// SPDX-License-Identifier: Apache-2.0
// What `proxima plan` says of the rendering, and whether render does as it says.
#include "tests/renderer/workplace.h"

#include <nlohmann/json.hpp>

using namespace proxima::testing;

namespace {

constexpr const char* head = "#version 3.7;\n"
                             "global_settings { assumed_gamma 1 }\n"
                             "camera { location <0.5, 0.7, -1.5> look_at 0.5 }\n"
                             "light_source { <3, 5, -4>, 1 }\n"
                             "#declare Stream = seed(7);\n";

/// 6,000 spheres in two sheets far apart, or everywhere.
std::string spheres(bool in_sheets) {
    return std::string(head) + "#for (I, 1, 6000)\n  sphere { <rand(Stream), rand(Stream), " +
           (in_sheets ? "mod(I, 2)" : "rand(Stream)") + ">, 0.007 }\n#end\n";
}

nlohmann::json plan_of(const Workplace& work, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"plan", "a.scn", "--json", "--device", "cpu", "--size", "160x120"});
    const ProcessResult run = work.run(arguments);
    CHECK_MESSAGE(run.exit_code == 0, run.standard_error);
    return nlohmann::json::parse(run.standard_output).at("rendering");
}

} // namespace

TEST_CASE("plan: foretells both methods, each at its best, and render takes the one that it picks") {
    const Workplace work("plan_program_test");
    for (const bool in_sheets : {false, true}) {
        work.write("a.scn", spheres(in_sheets));
        const nlohmann::json plan = plan_of(work, {});
        for (const std::string method : {"grid", "cloud"}) {
            for (const char* what : {"voxels_a_primitive", "references", "megabytes", "lookups_a_pixel",
                                     "tests_a_pixel", "build_ms", "trace_ms", "frame_ms"})
                CHECK_MESSAGE(plan.at(method + "_" + what).get<double>() > 0, method, " ", what);
            CHECK(plan.at(plan.at("method").get<std::string>() + "_frame_ms").get<double>() <=
                  1.04 * plan.at(method + "_frame_ms").get<double>()); // a present choice has 3 % of advance
        }
        CHECK(plan.at("cloud_occupied_percent").get<double>() > (in_sheets ? 0 : 50));
        CHECK(plan.at("cloud_mean_distance").get<double>() >= (in_sheets ? 3 : 0));

        REQUIRE(
            work.run({"render", "a.scn", "--device", "cpu", "--size", "160x120", "--stats-json", "a.json"}).exit_code ==
            0);
        const auto frame = nlohmann::json::parse(work.content("a.json")).at("frames").at(0);
        CHECK(frame.at("choose_ms").get<double>() > 0);
        CHECK(frame.at("predicted_ms").get<double>() > 0);
        CHECK(frame.at("wanted_grid").is_null());
    }
}

TEST_CASE("plan: says so when there is nothing to choose") {
    const Workplace work("plan_program_test");
    work.write("a.scn", still_scene);
    CHECK(plan_of(work, {}).at("decision").get<std::string>().find("every primitive") != std::string::npos);
    work.write("a.scn", spheres(false));
    const nlohmann::json plan = plan_of(work, {"--grid", "20"});
    CHECK(plan.at("grid_voxels") == "20x20x20");
    CHECK_FALSE(plan.contains("cloud_voxels"));
    CHECK(plan_of(work, {"--accel", "cloud"}).at("method") == "cloud");
}
