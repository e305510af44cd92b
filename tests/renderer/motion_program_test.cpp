// SPDX-License-Identifier: Apache-2.0
// Animations as a user meets them: whatever way their frames come from the script, the bytes are those of each frame
// rendered alone, for which the script is evaluated.
#include "tests/renderer/workplace.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

using namespace proxima::testing;

namespace {

constexpr const char* head = "#version 3.7;\n"
                             "global_settings { assumed_gamma 1 }\n"
                             "background { rgb <0.2, clock, 0.4> }\n"
                             "light_source { <-5, 5*clock, -5>, rgb 1 }\n";

/// Renders frames 1 to 4 in one run and each of them in a run of its own.
void compare_ways(const Workplace& work, const std::vector<std::string>& more = {}) {
    const auto render = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult run = work.render(arguments);
        CHECK_MESSAGE(run.exit_code == 0, run.standard_error);
    };
    render({"a.scn", "-o", "all.##.png", "--frames", "1-4", "--stats-json", "all.json"});
    for (int frame = 1; frame <= 4; ++frame) {
        render({"a.scn", "-o", "one.##.png", "--frames", "1-4", "--subset", std::to_string(frame)});
        CHECK(work.content(fmt::format("all.{:02}.png", frame)) == work.content(fmt::format("one.{:02}.png", frame)));
    }
    CHECK(work.content("all.01.png") != work.content("all.04.png"));
}

nlohmann::json plan_of(const Workplace& work) {
    const ProcessResult run = work.run({"plan", "a.scn", "--frames", "1-4", "--json"});
    CHECK_MESSAGE(run.exit_code == 0, run.standard_error);
    return nlohmann::json::parse(run.standard_output).at("motion");
}

} // namespace

TEST_CASE("motion: an animation by motion programs has the bytes of frames rendered alone") {
    const Workplace work;
    work.write("a.scn", std::string(head) +
                            "camera { location <clock, 0, -4> look_at clock*y }\n"
                            "#for (I, 1, 20) sphere { <sin(I+clock), I/10-1, cos(I*clock)>, 0.2\n"
                            "  pigment { rgb <I/20, clock, 0> } } #end\n"
                            "sphere { 1, 0.3 scale <2+clock, 1, 1> }\n"
                            "plane { y, -1-clock pigment { checker rgb 1 rgb 0 rotate clock*y*40 } }\n");
    compare_ways(work);
    const nlohmann::json plan = plan_of(work);
    CHECK(plan.at("moving_spheres") == 20);
    CHECK(plan.at("programs") == 1);
    CHECK(plan.at("decision") == "the script is evaluated once; motion programs say the frames");
    CHECK(nlohmann::json::parse(work.content("all.json")).at("moving") == 20);
}

TEST_CASE("motion: a frame that programs cannot say is the script's") {
    const Workplace work;
    const std::string camera = "camera { location -4*z look_at 0 }\n";
    SUBCASE("a sphere without a place") { // 0/0 in frame 3, not taken
        work.write("a.scn", head + camera + "sphere { <(frame_number = 3 ? 0 : 1/(frame_number-2.5)), clock, 0>, 1 }");
    }
    SUBCASE("a sphere that becomes an ellipsoid") {
        work.write("a.scn", head + camera + "sphere { 0, 1 scale <1, 1+(frame_number > 2)*clock, 1> }");
    }
    SUBCASE("a program whose guards never hold again") {
        work.write("a.scn",
                   head + camera + "sphere { 0, 1 scale <1, 1+clock, 1> matrix <1,clock,0, 0,1,0, 0,0,1, 0,0,0> }");
    }
    compare_ways(work);
}

TEST_CASE("motion: a script that looks at the time is evaluated for every frame, and plan says where") {
    const Workplace work;
    work.write("a.scn", std::string(head) + "camera { location -4*z look_at 0 }\n"
                                            "#if (clock < 0.5)\n  sphere { clock*x, 1 }\n"
                                            "#else\n  sphere { clock*y, 0.5 }\n#end\n");
    compare_ways(work);
    const nlohmann::json plan = plan_of(work);
    CHECK(plan.at("forced_by") == "#if");
    CHECK(plan.at("line") == 6);
    const ProcessResult text = work.run({"plan", "a.scn"});
    CHECK(says(text.standard_output, "would be evaluated again for every frame: a.scn:6:1: '#if' looks at a number"));
    CHECK(work.run({"plan", "still.scn"}).exit_code == 0);
    CHECK(says(work.run({"plan", "still.scn"}).standard_output, "nothing follows from the time"));
}

TEST_CASE("motion: a data file a frame streams") {
    const Workplace work;
    for (int frame = 1; frame <= 4; ++frame) {
        std::string text;
        for (int i = 0; i < 50; ++i)
            text += fmt::format("{}, {},\n", i * 0.05 - 1, frame * 0.2 - i * 0.01);
        work.write(fmt::format("data{}.txt", frame), text);
    }
    work.write("a.scn", std::string(head) + "camera { location -4*z look_at 0 }\n"
                                            "#fopen F concat(\"data\", str(frame_number, 0, 0), \".txt\") read\n"
                                            "#while (defined(F)) #read (F, X, Y) sphere { <X, Y, 0>, 0.1 } #end\n");
    compare_ways(work);
    CHECK(plan_of(work).at("forced_by") == "str");
}

TEST_CASE("motion: blur is the mean of the frame's moments, by programs and by the script alike") {
    const Workplace work;
    const std::string scene = std::string(head) + "camera { location -4*z look_at 0 }\n"
                                                  "sphere { clock*x*3, 0.5 pigment { rgb <1, clock, 0> } }\n";
    work.write("a.scn", scene);
    const std::vector<std::string> blurred{"--shutter", "-0.5:0.5", "--shutter-samples", "4", "--precision", "double"};
    compare_ways(work, blurred);
    std::filesystem::copy_file(work.folder / "all.02.png", work.folder / "by_programs.png");
    work.write("a.scn", scene + "#if (clock > 0) sphere { 9*y, 0.1 } #end\n"); // behind the camera's sight
    compare_ways(work, blurred);
    const auto differs = [&](const char* name) { // in pixels: the files also hold hashes of their scenes
        return work.run({"compare", name, "by_programs.png"}).exit_code;
    };
    CHECK(differs("all.02.png") == 0);
    for (const char* format : {"exr", "tif"}) // halves would be made on the device, frame by frame
        CHECK(work.render({"a.scn", "-o", std::string("blurred.##.") + format, "--frames", "1-4", "--shutter",
                           "-0.5:0.5", "--shutter-samples", "4"})
                  .exit_code == 0);
    REQUIRE(work.render({"a.scn", "-o", "sharp.##.png", "--frames", "1-4", "--subset", "2"}).exit_code == 0);
    CHECK(differs("sharp.02.png") == 4);
}

TEST_CASE("motion: a shutter that means nothing is refused") {
    const Workplace work;
    const auto message = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "moving.scn");
        const ProcessResult run = work.render(arguments);
        CHECK(run.exit_code == 2);
        return run.standard_error;
    };
    CHECK(says(message({"--shutter", "0:0.5"}), "give --frames A-B too"));
    CHECK(says(message({"--shutter-samples", "4"}), "give --shutter OPEN:CLOSE too"));
    CHECK(says(message({"--frames", "1-4", "--shutter", "0.5:0"}), "OPEN not above CLOSE"));
    CHECK(says(message({"--frames", "1-4", "--shutter", "wide"}), "write OPEN:CLOSE"));
    CHECK(says(message({"--frames", "1-4", "--shutter", "0:1", "--shutter-samples", "0"}), "from 1 to 1024"));
}
