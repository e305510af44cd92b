// SPDX-License-Identifier: Apache-2.0
// The program on several devices. They are cuda:0 and cuda:1 where there are two, or else two CPU workers that stand in
// for them; PROXIMA_TEST_DEVICES names others, and PROXIMA_PROGRAM another program. The same bytes come out in every
// mode as from one device, and after faults.
#include "tests/process.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

/// Mirrors, glass, fog, and a jittered area light: what a pixel looks like depends on its place in the picture.
constexpr const char* scene = R"(#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <0, 0, -3> look_at 0 }
light_source { <-5, 5, -5>, rgb 1 area_light <1, 0, 0>, <0, 1, 0>, 3, 3 jitter adaptive 1 }
fog { distance 20 rgb <0.5, 0.6, 0.7> }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
#for (I, -4, 4)
  sphere { <I / 4, sin(I + 6 * clock) / 2, 0>, 0.15 pigment { rgb <1, 0.3, 0.2> } finish { reflection 0.2 } }
#end
sphere { <0, 0.5 * clock, -1>, 0.4 pigment { rgbt <0.9, 1, 0.9, 0.8> } interior { ior 1.4 } }
)";

constexpr int frame_count = 6;
constexpr int exit_out_of_memory = 33, exit_try_elsewhere = 75;

std::string environment(const char* name, const std::string& otherwise) {
    const char* value = std::getenv(name);
    return value && *value ? value : otherwise;
}

/// The one that was built beside the test, or the one that is found in PATH.
std::string program() {
    return environment("PROXIMA_PROGRAM", fs::exists(PROXIMA_PROGRAM) ? PROXIMA_PROGRAM : "proxima");
}

struct Devices {
    std::string one, two; ///< lists for --device
};

Devices find_devices() {
    const std::string listed = run_process({program(), "devices"}).standard_output;
    const bool has_two = listed.find("cuda:0") != std::string::npos && listed.find("cuda:1") != std::string::npos;
    const std::string two = environment("PROXIMA_TEST_DEVICES", has_two ? "cuda:0,cuda:1" : "cpu,cpu");
    return {two.substr(0, two.find(',')), two};
}

const Devices& devices() {
    static const Devices found = find_devices();
    return found;
}

using Frames = std::map<std::string, std::string>; ///< name -> bytes

class Workplace {
public:
    Workplace() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        std::ofstream(folder_ / "scene.scn") << scene;
    }
    ~Workplace() { fs::remove_all(folder_); }

    /// Renders small frames into a folder `name` that had been empty.
    ProcessResult render(const std::string& name, const std::string& devices,
                         std::vector<std::string> arguments = {}) const {
        fs::remove_all(folder_ / name);
        fs::create_directories(folder_ / name);
        arguments.insert(arguments.begin(),
                         {program(), "render", "scene.scn", "--device", devices, "--frames",
                          fmt::format("1-{}", frame_count), "--size", "56x70", "-o", name + "/f.##.exr"});
        return run_process(arguments, folder_, 20);
    }
    Frames frames(const std::string& name) const {
        Frames bytes;
        for (const auto& entry : fs::directory_iterator(folder_ / name)) {
            std::ifstream file(entry.path(), std::ios::binary);
            bytes[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
        }
        return bytes;
    }
    nlohmann::json json(const std::string& name) const {
        std::ifstream file(folder_ / name);
        return nlohmann::json::parse(file);
    }

private:
    fs::path folder_ = fs::absolute("multi_device_program_test");
};

/// Every file of `part` is the same in `whole`: finished frames are whole, and there is nothing else.
bool is_part(const Frames& part, const Frames& whole) {
    return std::includes(whole.begin(), whole.end(), part.begin(), part.end());
}

bool says(const ProcessResult& run, const std::string& text) {
    return run.standard_error.find(text) != std::string::npos;
}

} // namespace

TEST_CASE("devices: two give the same bytes as one, in every mode") {
    MESSAGE("devices: " << devices().two);
    const Workplace work;
    const std::vector<std::vector<std::string>> ways{
        {},
        {"--samples", "3"},
        {"--antialias", "method1:0.05:2"},
        {"--antialias", "method2:0.05:2"},
        {"--precision", "double", "--accel", "cloud"},
        {"--aov", "depth,normal,id,steps"},
        {"--aov", "depth,steps", "--shutter", "-0.5:0.5", "--shutter-samples", "3", "--accel", "cloud"},
    };
    for (const std::vector<std::string>& way : ways) {
        CAPTURE(fmt::format("{}", fmt::join(way, " ")));
        REQUIRE(work.render("one", devices().one, way).exit_code == 0);
        const Frames one = work.frames("one");
        CHECK(one.size() == frame_count);
        for (const std::string mode : {"frames", "tiles", "relay"}) {
            CAPTURE(mode);
            std::vector<std::string> arguments = way;
            arguments.insert(arguments.end(), {"--multi-gpu", mode});
            REQUIRE(work.render("two", devices().two, arguments).exit_code == 0);
            CHECK(work.frames("two") == one);
        }
    }
}

TEST_CASE("devices: a single frame is rendered in tiles by both") {
    const Workplace work;
    const std::vector<std::string> still{"--subset", "3", "--stats-json", "run.json"};
    REQUIRE(work.render("one", devices().one, still).exit_code == 0);
    REQUIRE(work.render("two", devices().two, still).exit_code == 0);
    CHECK(work.frames("two") == work.frames("one"));
    CHECK(work.json("run.json").at("frames").size() == 1);
}

TEST_CASE("devices: records are in order, whoever rendered the frames") {
    const Workplace work;
    REQUIRE(work.render("two", devices().two, {"--stats-json", "run.json"}).exit_code == 0);
    int64_t frame = 0;
    const nlohmann::json json = work.json("run.json");
    for (const auto& record : json.at("frames")) {
        CHECK(record.at("frame") == ++frame);
        CHECK(record.at("device").get<std::string>().starts_with(devices().one.substr(0, 3)));
    }
    CHECK(frame == frame_count);
}

TEST_CASE("devices: the timeline has every step of every frame, and is drawn") {
    const Workplace work;
    REQUIRE(
        work.render("two", devices().two,
                    {"--accel", "cloud", "--multi-gpu", "relay", "--stats-json", "run.json", "--timeline", "run.svg"})
            .exit_code == 0);
    const nlohmann::json json = work.json("run.json");
    std::map<std::string, std::set<int>> frames_of;
    for (const auto& span : json.at("timeline")) {
        CHECK(span.at("begin_ms") <= span.at("end_ms"));
        frames_of[span.at("step")].insert(span.at("frame").get<int>());
        const bool builds = span.at("step") == "build" || span.at("step") == "map";
        if (builds)
            CHECK(span.at("device") == devices().one); // the first one, for the others
    }
    for (const char* step : {"build", "map", "relay", "trace", "read-back", "color", "encode", "write"})
        CHECK_MESSAGE(frames_of[step].size() == frame_count, step);
    CHECK(json.at("busy").contains(devices().one));
    CHECK(fs::file_size("multi_device_program_test/run.svg") > 1000);
}

TEST_CASE("devices: frames that are discarded leave no files") {
    const Workplace work;
    CHECK(work.render("two", devices().two, {"--discard"}).exit_code == 0);
    CHECK(work.frames("two").empty());
}

TEST_CASE("devices: a fault at any step of a frame leaves the frame to the others, and the bytes as they are") {
    const Workplace work;
    REQUIRE(work.render("one", devices().one).exit_code == 0);
    const Frames one = work.frames("one");
    for (const std::string mode : {"frames", "tiles"})
        for (const std::string kind : {"gpu-lost", "out-of-memory"})
            for (const std::string step : {"build", "map", "trace", "read-back"}) {
                const std::string fault = fmt::format("{}@frame3:{}", kind, step);
                CAPTURE(mode);
                CAPTURE(fault);
                const ProcessResult run =
                    work.render("two", devices().two, {"--accel", "cloud", "--multi-gpu", mode, "--inject", fault});
                CHECK(run.exit_code == 0);
                CHECK(work.frames("two") == one);
                const bool retries = says(run, "out of memory; goes on in tiles of ");
                const bool leaves = says(run, "; frame 3 goes to another device");
                CHECK((retries || leaves));
                CHECK((leaves || kind == "out-of-memory"));
            }
}

TEST_CASE("devices: one whose builder fails builds for itself") {
    const Workplace work;
    REQUIRE(work.render("one", devices().one).exit_code == 0);
    for (const std::string step : {"build", "map"}) {
        CAPTURE(step);
        const ProcessResult run = work.render(
            "two", devices().two, {"--accel", "cloud", "--multi-gpu", "relay", "--inject", "gpu-lost@frame3:" + step});
        CHECK(run.exit_code == 0);
        CHECK(says(run, "builds no more grids for this device: the device was lost"));
        CHECK(work.frames("two") == work.frames("one"));
    }
    const ProcessResult run = // the tracers die, of whom there are two in flight
        work.render("two", devices().two, {"--multi-gpu", "relay", "--inject", "gpu-lost@frame3:relay*99"});
    CHECK(run.exit_code == exit_try_elsewhere);
    CHECK(is_part(work.frames("two"), work.frames("one")));
}

TEST_CASE("devices: with none left, every finished frame is whole, and the exit code says what to do") {
    const Workplace work;
    REQUIRE(work.render("one", devices().one).exit_code == 0);
    const Frames one = work.frames("one");
    const std::pair<std::string, int> kinds[] = {{"gpu-lost", exit_try_elsewhere},
                                                 {"out-of-memory", exit_out_of_memory}};
    for (const std::string mode : {"frames", "tiles"})
        for (const auto& [kind, code] : kinds)
            for (const std::string step : {"build", "trace", "read-back", "color", "encode", "write"}) {
                const std::string fault = fmt::format("{}@frame3:{}*99", kind, step);
                CAPTURE(mode);
                CAPTURE(fault);
                const ProcessResult run = work.render("two", devices().two, {"--multi-gpu", mode, "--inject", fault});
                CHECK(run.exit_code == code);
                const Frames two = work.frames("two");
                CHECK(!two.contains("f.03.exr"));
                CHECK(is_part(two, one));
            }
}

TEST_CASE("devices: a single one without memory for a frame goes on in tiles") {
    const Workplace work;
    REQUIRE(work.render("one", devices().one).exit_code == 0);
    const ProcessResult run = work.render(
        "tiles", devices().one, {"--in-flight", "1", "--inject", "out-of-memory@frame2:trace,gpu-lost@frame9:trace"});
    CHECK(run.exit_code == 0);
    CHECK(says(run, devices().one + ": out of memory; goes on in tiles of 32 rows"));
    CHECK(work.frames("tiles") == work.frames("one"));
}

TEST_CASE("devices: one that is asked for by name and missing is exit code 2") {
    const Workplace work;
    const ProcessResult run = work.render("none", "cpu,cuda:99");
    CHECK(run.exit_code == 2);
    CHECK(says(run, "--device cuda:99: there is no device cuda:99"));
    CHECK(work.frames("none").empty());
    for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{{"--multi-gpu", "title"},
                                                                                       {"--multi-gpu", "relay"},
                                                                                       {"--inject", "fire"},
                                                                                       {"--tile-rows", "33"},
                                                                                       {"--in-flight", "0"}})
        CHECK(work.render("none", "cpu", wrong).exit_code == 2);
}
