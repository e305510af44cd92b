// SPDX-License-Identifier: Apache-2.0
// `proxima tradeoff` and `proxima render --max-error`, as a user meets them.
#include "tests/renderer/workplace.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace proxima::testing;

namespace {

constexpr const char* mirror_scene = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 0, -3> look_at 0 }
light_source { <-5, 5, -5>, rgb 1 }
sphere { <-0.6, 0, 0>, 0.5 pigment { rgb <1, 0.3, 0.2> } finish { reflection 0.6 } }
sphere { <0.6, 0, 0>, 0.5 pigment { rgb <0.1, 0.3, 1> } finish { reflection 0.6 } }
)";

ProcessResult tradeoff(const Workplace& work, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "tradeoff");
    arguments.insert(arguments.end(), {"--size", "32x24", "--device", "cpu", "--budget", "2", "--repeats", "1"});
    return work.run(std::move(arguments));
}

} // namespace

TEST_CASE("tradeoff: a folder with tables, a chart, a page and pictures") {
    const Workplace work("tradeoff_test");
    work.write("mirrors.scn", mirror_scene);
    const ProcessResult run = tradeoff(work, {"mirrors.scn", "-o", "out"});
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    CHECK(says(run.standard_error, "/255"));
    CHECK(run.standard_output.starts_with(work.content("out/table.txt")));
    const auto json = nlohmann::json::parse(work.content("out/table.json"));
    const auto& points = json["points"];
    REQUIRE(points.size() > 15);
    double best = 1e300, last = 0;
    for (const auto& point : points) {
        CHECK(point["ms"].get<double>() >= last); // by time, and the front falls
        last = point["ms"];
        CHECK(point["on_front"].get<bool>() == (point["levels_rms"].get<double>() < best));
        best = std::min(best, point["levels_rms"].get<double>());
    }
    size_t kept = 0;
    for (const auto& recommendation : json["recommendations"])
        if (!recommendation["point"].is_null()) {
            CHECK(points[recommendation["point"].get<size_t>()]["levels_rms"] <= recommendation["levels"]);
            ++kept;
        }
    CHECK(kept > 0);
    for (const auto& aspect : json["aspects"]) {
        const std::string name = aspect["name"];
        CAPTURE(name);
        CHECK((aspect["options"] > 1) == (name != "area lights" && name != "shutter"));
    }
    for (const auto& file : json["files"])
        CHECK(fs::file_size(work.folder / "out" / file["file"].get<std::string>()) == file["bytes"]);
    CHECK(json["files"][0]["levels_rms"] > 0); // half
    CHECK(json["files"].back()["rms"] == 0);   // float
    for (size_t i = 1; i <= points.size(); ++i)
        CHECK(fs::exists(work.folder / "out" / "pictures" / fmt::format("{}.difference.png", i)));
    CHECK(says(work.content("out/index.html"), "\"recommendations\""));
    CHECK(work.content("out/chart.svg").ends_with("</svg>\n"));
    const std::string csv = work.content("out/table.csv");
    CHECK(size_t(std::ranges::count(csv, '\n')) == points.size() + 1);
}

TEST_CASE("tradeoff: options, scene and folder are refused with their exit codes") {
    const Workplace work("tradeoff_test");
    work.write("wrong.scn", "sphere { 0, }\n");
    work.write("file", "");
    CHECK(tradeoff(work, {"wrong.scn", "-o", "out"}).exit_code == 1);
    CHECK(tradeoff(work, {"still.scn"}).exit_code == 2);
    CHECK(tradeoff(work, {"-", "-o", "out"}).exit_code == 2);
    CHECK(tradeoff(work, {"still.scn", "-o", "out", "--repeats", "0"}).exit_code == 2);
    CHECK(tradeoff(work, {"still.scn", "-o", "file/out"}).exit_code == 3);
    CHECK(tradeoff(work, {"missing.scn", "-o", "out"}).exit_code == 3);
}

TEST_CASE("max error: the choice keeps it, stands in the statistics, and is the same in every part of an animation") {
    const Workplace work("max_error_test");
    const std::vector<std::string> asked = {"moving.scn", "--frames",    "1-4",  "--clock",
                                            "-0.5:0.5",   "--max-error", "6/255"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), asked.begin(), asked.end());
        return more;
    };
    const ProcessResult whole =
        work.render(with({"-o", "a.#.png", "--stats-json", "s.json", "--verify-error", "--progress", "plain"}));
    REQUIRE_MESSAGE(whole.exit_code == 0, whole.standard_error);
    const auto quality = nlohmann::json::parse(work.content("s.json"))["quality"];
    CHECK(says(whole.standard_error, "--max-error 6/255: " + quality["options"].get<std::string>()));
    CHECK(quality["predicted"]["levels_rms"] <= 6);
    CHECK(quality["measured"]["levels_rms"] <= 6);
    CHECK(quality["measured"]["levels_rms"] > 0);
    REQUIRE(work.render(with({"-o", "b.#.png", "--shard", "2/2", "--threads", "1"})).exit_code == 0);
    for (const int frame : {2, 4})
        CHECK(work.content(fmt::format("a.000{}.png", frame)) == work.content(fmt::format("b.000{}.png", frame)));
    // What --max-error chose is what the options say, so that its files are those of a run with them.
    std::vector<std::string> plain = {"moving.scn", "--frames", "1-4", "--clock", "-0.5:0.5", "-o", "c.#.png"};
    std::istringstream words(quality["options"].get<std::string>());
    for (std::string word; words >> word;)
        plain.push_back(word);
    REQUIRE(work.render(plain).exit_code == 0);
    CHECK(work.content("a.0003.png") == work.content("c.0003.png"));
    const auto verify = [&](const char* error) {
        return work.run({"verify", "moving.scn", "a.#.png", "--frames", "1-4", "--clock", "-0.5:0.5", "--size", "32x24",
                         "--max-error", error});
    };
    CHECK(verify("6/255").exit_code == 0);
    CHECK(verify("60/255").exit_code == 4);
}

TEST_CASE("max error: more error allowed is never more rays; what cannot be kept is refused") {
    const Workplace work("max_error_test");
    work.write("mirrors.scn", mirror_scene);
    uint64_t last = 0;
    for (const char* error : {"200/255", "8/255", "3/255"}) {
        const ProcessResult run =
            work.render({"mirrors.scn", "-o", "a.png", "--max-error", error, "--stats-json", "s.json"});
        REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
        const auto json = nlohmann::json::parse(work.content("s.json"));
        CHECK(json["frames"][0]["camera_rays"] >= last);
        last = json["frames"][0]["camera_rays"];
    }
    CHECK(last > 32 * 24);
    const ProcessResult impossible = work.render({"mirrors.scn", "-o", "b.png", "--max-error", "1e-9"});
    CHECK(impossible.exit_code == 2);
    CHECK(says(impossible.standard_error, "the nearest is"));
    for (const char* wrong : {"0", "-1", "2/256", "x"})
        CHECK(work.render({"mirrors.scn", "-o", "b.png", "--max-error", wrong}).exit_code == 2);
    CHECK(work.render({"mirrors.scn", "-o", "b.png", "--verify-error"}).exit_code == 2);
    CHECK(work.files() == std::set<std::string>{"a.png", "s.json"});
}

TEST_CASE("max error: samples and precision that are given are kept") {
    const Workplace work("max_error_test");
    const ProcessResult run = work.render({"still.scn", "-o", "a.png", "--max-error", "0.5", "--samples", "3",
                                           "--precision", "double", "--stats-json", "s.json"});
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    CHECK(nlohmann::json::parse(work.content("s.json"))["quality"]["options"] == "--precision double --samples 3");
}

TEST_CASE("render: trace level, bail-out and area places can be set, and are part of the frame's hash") {
    const Workplace work("max_error_test");
    work.write("mirrors.scn", mirror_scene);
    const auto picture = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"mirrors.scn", "-o", "a.png"});
        REQUIRE(work.render(options).exit_code == 0);
        return work.content("a.png");
    };
    const std::string whole = picture({});
    CHECK(picture({"--max-trace-level", "4"}) == whole);
    CHECK(picture({"--max-trace-level", "1"}) != whole);
    CHECK(picture({"--adc-bailout", "0.5"}) != whole);
    const ProcessResult kept =
        work.render({"mirrors.scn", "-o", "a.png", "--adc-bailout", "0.5", "--skip-existing", "--progress", "plain"});
    CHECK(says(kept.standard_error, "1 of 1 frames are there"));
    const ProcessResult other =
        work.render({"mirrors.scn", "-o", "a.png", "--adc-bailout", "0.4", "--skip-existing", "--progress", "plain"});
    CHECK(says(other.standard_error, "0 of 1 frames are there"));
    CHECK(work.render({"mirrors.scn", "-o", "a.png", "--max-trace-level", "0"}).exit_code == 2);
    CHECK(work.render({"mirrors.scn", "-o", "a.png", "--area-places", "0"}).exit_code == 2);
}
