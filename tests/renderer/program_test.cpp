// SPDX-License-Identifier: Apache-2.0
// The program as a user meets it: arguments in, files, messages and the documented exit codes out.
#include "tests/renderer/workplace.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <thread>

using namespace proxima::testing;

TEST_CASE("program: a scene becomes a picture beside the caller") {
    const Workplace work;
    const ProcessResult run = work.render({"still.scn"});
    CHECK(run.exit_code == 0);
    CHECK(run.standard_output.empty());
    CHECK(says(run.standard_error, "wrote still.png"));
    CHECK(work.files() == std::set<std::string>{"still.png"});
    OIIO::ImageSpec spec;
    CHECK(work.corner("still.png", &spec) == std::array<uint16_t, 3>{118 * 257, 188 * 257, 63 * 257});
    CHECK(spec.width == 32);
    CHECK(spec.height == 24);
    CHECK(spec.get_string_attribute("oiio:ColorSpace") == "sRGB");
    CHECK(work.render({"still.scn", "--progress", "none"}).standard_error.empty());
}

TEST_CASE("program: the Raw view writes the linear numbers") {
    const Workplace work;
    REQUIRE(work.render({"still.scn", "-o", "a.png", "--view", "Raw", "--bits", "16"}).exit_code == 0);
    CHECK(work.corner("a.png") == std::array<uint16_t, 3>{11796, 32768, 3277});
    REQUIRE(work.render({"still.scn", "-o", "a.exr"}).exit_code == 0);
    const std::array<uint16_t, 3> linear = work.corner("a.exr");
    CHECK(linear[0] == doctest::Approx(11796).epsilon(5e-4));
    CHECK(linear[1] == 32768);
}

TEST_CASE("program: an animation has a file a frame, and a subset gives the same bytes") {
    const Workplace work;
    REQUIRE(work.render({"moving.scn", "-o", "a.##.png", "--frames", "1-4"}).exit_code == 0);
    CHECK(work.files() == std::set<std::string>{"a.01.png", "a.02.png", "a.03.png", "a.04.png"});
    CHECK(work.content("a.01.png") != work.content("a.02.png"));
    REQUIRE(work.render({"moving.scn", "-o", "b.%02d.png", "--frames", "1-4", "--subset", "4,2"}).exit_code == 0);
    CHECK(work.files().size() == 6);
    CHECK(work.content("a.02.png") == work.content("b.02.png"));
    CHECK(work.content("a.04.png") == work.content("b.04.png"));
}

TEST_CASE("program: an animation in which nothing moves has a file a frame, too") {
    const Workplace work;
    CHECK(work.render({"still.scn", "-o", "a.##.tif", "--frames", "1-5"}).exit_code == 0);
    CHECK(work.files().size() == 5);
    CHECK(work.corner("a.01.tif") == work.corner("a.05.tif"));
}

TEST_CASE("program: two runs give the same bytes in every format") {
    const Workplace work;
    const std::string extensions[] = {"png", "exr", "tif", "jpg"};
    for (const std::string& extension : extensions)
        REQUIRE(work.render({"still.scn", "-o", "a." + extension}).exit_code == 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(1100)); // a time in a file would differ now
    for (const std::string& extension : extensions) {
        CAPTURE(extension);
        REQUIRE(work.render({"still.scn", "-o", "b." + extension, "--threads", "1"}).exit_code == 0);
        CHECK(work.content("a." + extension).size() > 100);
        CHECK(work.content("a." + extension) == work.content("b." + extension));
    }
}

TEST_CASE("program: statistics are one JSON object") {
    const Workplace work;
    REQUIRE(work.render({"moving.scn", "-o", "a.#.exr", "--frames", "1-3", "--stats-json", "s.json"}).exit_code == 0);
    const auto json = nlohmann::json::parse(work.content("s.json"));
    CHECK(json["scene"] == "moving.scn");
    CHECK(json["spheres"] == 1);
    REQUIRE(json["frames"].size() == 3);
    CHECK(json["frames"][2]["file"] == "a.0003.exr");
    CHECK(json["frames"][2]["device"] == "cpu");
    CHECK(json["wall_ms"] > 0);
}

TEST_CASE(
    "program: progress is a line a frame, or a JSON object a line, and no escape codes where there is no terminal") {
    const Workplace work;
    const std::vector<std::string> animation{"moving.scn", "-o", "a.#.png", "--frames", "1-3", "--progress"};
    const auto with = [&](const std::string& style) {
        auto arguments = animation;
        arguments.push_back(style);
        return work.render(arguments).standard_error;
    };
    for (const char* style : {"auto", "plain"}) {
        const std::string text = with(style);
        CHECK(std::count(text.begin(), text.end(), '\n') == 3);
        CHECK(says(text, "wrote a.0002.png (2 of 3, "));
        CHECK_FALSE(says(text, "\r"));
        CHECK_FALSE(says(text, "\033"));
    }
    std::istringstream lines(with("json"));
    size_t count = 0;
    for (std::string line; std::getline(lines, line);)
        CHECK(nlohmann::json::parse(line)["done"] == ++count);
    CHECK(count == 3);
    CHECK(with("none").empty());
    const std::string farm = with("openjd");
    for (const char* line : {"openjd_progress: 0\n", "openjd_progress: 33.3\n", "openjd_progress: 100.0\n",
                             "openjd_status: wrote a.0002.png (2 of 3)\n"})
        CHECK_MESSAGE(says(farm, line), farm);
    CHECK(says(work.render({"missing.scn", "--progress", "openjd"}).standard_error, "openjd_fail: cannot read missing.scn: "));
    CHECK(says(with("bar"), "\r[="));
}

TEST_CASE("program: check counts what is in a scene") {
    const Workplace work;
    const ProcessResult run = work.run({"check", "still.scn"});
    CHECK(run.exit_code == 0);
    CHECK(says(run.standard_output, "still.scn: the scene is right"));
    CHECK(says(run.standard_output, "spheres                1"));
    CHECK(work.run({"check", "moving.scn", "--frames", "1-3"}).exit_code == 0);
}

TEST_CASE("program: devices lists the CPU") {
    const Workplace work;
    CHECK(says(work.run({"devices"}).standard_output, "cpu "));
    const auto json = nlohmann::json::parse(work.run({"devices", "--json"}).standard_output);
    CHECK(json[0]["id"] == "cpu");
    CHECK(json[0]["memory_bytes"] > 0);
}

TEST_CASE("program: a wrong scene is exit code 1, with the place of each mistake") {
    const Workplace work;
    work.write("wrong.scn", "sphere { <0, 0, 0>, 1\nlight_sauce { 0 rgb 1 }\n");
    for (const char* command : {"check", "render"}) {
        const ProcessResult run = work.run({command, "wrong.scn"});
        CHECK(run.exit_code == 1);
        CHECK(run.standard_output.empty());
        CHECK(says(run.standard_error, "wrong.scn:2:1: error: "));
        CHECK(says(run.standard_error, "proxima: error: wrong.scn: "));
    }
    CHECK(work.files().empty());
}

TEST_CASE("program: a wrong command line is exit code 2") {
    const Workplace work;
    const std::vector<std::string> rows[] = {
        {},
        {"paint"},
        {"render"},
        {"render", "still.scn", "--colour"},
        {"render", "still.scn", "--size", "big"},
        {"render", "still.scn", "-o", "a.bmp"},
        {"render", "still.scn", "--view", "Filmic"},
        {"render", "still.scn", "--display", "Wall"},
        {"render", "still.scn", "--device", "cuda:1000"},
    };
    for (const auto& arguments : rows) {
        const ProcessResult run = work.run(arguments);
        CHECK(run.exit_code == 2);
        CHECK(run.standard_error.find("proxima: error: ") == 0);
        CHECK(run.standard_output.empty());
    }
    CHECK(work.files().empty());
}

TEST_CASE("program: help and version are exit code 0 on standard output") {
    const Workplace work;
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--help"}, {"render", "--help"}, {"check", "--help"}, {"--version"}}) {
        const ProcessResult run = work.run(arguments);
        CHECK(run.exit_code == 0);
        CHECK(run.standard_error.empty());
        CHECK_FALSE(run.standard_output.empty());
    }
}

TEST_CASE("program: a file that cannot be read or written is exit code 3, before anything is rendered") {
    const Workplace work;
    fs::create_directory(work.folder / "folder.png");
    const std::vector<std::string> rows[] = {
        {"missing.scn"},
        {"."},
        {"still.scn", "-o", "folder.png"},
        {"still.scn", "-o", "no/such/folder/a.png"},
        {"still.scn", "-o", "still.scn/a.png"},
        {"still.scn", "-o", "/proc/a.png"},
        {"still.scn", "--ocio", "missing.ocio"},
        {"still.scn", "--stats-json", "missing/s.json"},
    };
    for (const auto& arguments : rows) {
        CAPTURE(arguments.back());
        const ProcessResult run = work.render(arguments);
        CHECK(run.exit_code == 3);
        CHECK(run.standard_error.find("proxima: error: ") == 0);
    }
    CHECK(work.files() == std::set<std::string>{"folder.png"});
}

TEST_CASE("program: a disk that fills up while a frame is written leaves no partial file") {
    const Workplace work;
    const ProcessResult run =
        work.render({"still.scn", "-o", "a.tif", "--progress", "none"}, {"prlimit", "--fsize=200"});
    CHECK(run.exit_code == 3);
    CHECK(says(run.standard_error, "a.tif: cannot be written: File too large"));
    CHECK(work.files().empty());
    const ProcessResult full = work.render({"still.scn", "--stats-json", "/dev/full"});
    CHECK(full.exit_code == 3);
    CHECK(says(full.standard_error, "/dev/full: cannot be written: No space left on device"));
}

#if !defined(__SANITIZE_ADDRESS__)
TEST_CASE("program: too little memory is exit code 33") {
    const Workplace work;
    const ProcessResult run =
        work.run({"render", "still.scn", "--device", "cpu", "--size", "30000x30000"}, {"prlimit", "--as=2000000000"});
    CHECK(run.exit_code == 33);
    CHECK(says(run.standard_error, "proxima: error: "));
    CHECK(work.files().empty());
}
#endif

TEST_CASE("program: a signal stops the run after the frame in flight") {
    const Workplace work;
    for (const auto& [signal, code] : {std::pair{"INT", 130}, std::pair{"TERM", 143}}) {
        CAPTURE(signal);
        const ProcessResult run = work.render({"moving.scn", "-o", "a.######.png", "--frames", "1-100000"},
                                              {"timeout", "--preserve-status", "--signal", signal, "1"});
        CHECK(run.exit_code == code);
        CHECK(says(run.standard_error, "proxima: error: stopped by signal"));
        for (const std::string& name : work.files()) {
            CHECK(name.size() == std::string("a.000001.png").size()); // no temporary file
            work.corner(name);
        }
        CHECK_FALSE(work.files().empty());
    }
}

TEST_CASE("program: a signal ends the run within two seconds, however long a frame takes") {
    const Workplace work;
    work.write("endless.scn", "#version 3.7;\n#declare I = 0;\n#while (I < 1e9) #declare I = I + 1; #end\n");
    const char* script = "\"$@\" & pid=$!; sleep 0.5; kill -TERM $pid; wait $pid";
    for (const std::string scene : {"still.scn", "endless.scn"}) { // each would take minutes
        CAPTURE(scene);
        const ProcessResult run = work.run({"render", scene, "--size", "4000x4000", "--samples", "4096", "--max-steps",
                                            "1000000", "--device", "cpu,cpu", "--multi-gpu", "frames"},
                                           {"sh", "-c", script, "sh"});
        CHECK(run.exit_code == 143);
        CHECK(run.wall_seconds < 3); // with some for the machine
        CHECK(says(run.standard_error, "proxima: error: stopped by "));
        CHECK(work.files().empty());
    }
}

TEST_CASE("program: a second signal, a second later, ends the run at once") {
    const Workplace work;
    work.write("endless.scn", "#version 3.7;\n#declare I = 0;\n#while (I < 1e9) #declare I = I + 1; #end\n");
    const char* script = "\"$@\" & pid=$!; sleep 0.5; kill -TERM $pid; sleep 1.2; kill -TERM $pid; wait $pid";
    const ProcessResult run =
        work.run({"render", "endless.scn", "--max-steps", "1000000", "--device", "cpu"}, {"sh", "-c", script, "sh"});
    CHECK(run.exit_code == 143);
    CHECK_FALSE(says(run.standard_error, "stopped by "));
}
