// SPDX-License-Identifier: Apache-2.0
#include "renderer/statistics_json.h"

#include <chrono>
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <thread>

using namespace proxima;

TEST_CASE("timeline: a device is busy where its spans are, once where they overlap") {
    Timeline timeline;
    const auto start = std::chrono::steady_clock::now();
    const auto at = [&](int ms) { return start + std::chrono::milliseconds(ms); };
    timeline.add("cuda:0", FrameStep::build, 1, at(0), at(10));
    timeline.add("cuda:0", FrameStep::trace, 1, at(5), at(20));
    std::thread([&] { timeline.add("cuda:0", FrameStep::trace, 2, at(15), at(50)); }).join();
    timeline.add("cuda:1", FrameStep::trace, 3, at(30), at(40));
    timeline.add("cuda:1", FrameStep::trace, 3, at(80), at(100));
    timeline.add(Timeline::writer, FrameStep::encode, 1, at(0), at(400));
    const auto busy = timeline.busy_shares();
    CHECK(busy.size() == 2);
    CHECK(busy.at("cuda:0") == doctest::Approx(0.5));
    CHECK(busy.at("cuda:1") == doctest::Approx(0.3));
    CHECK(timeline.lanes().size() == 4); // two threads of cuda:0

    const auto json = nlohmann::json::parse(to_json({}, timeline));
    CHECK(json["timeline"].size() == 6);
    CHECK(json["timeline"][5]["step"] == "encode");
    CHECK(json["busy"]["cuda:1"] == doctest::Approx(0.3));

    const std::string svg = to_svg(timeline);
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.ends_with("</svg>\n"));
    CHECK(svg.find("<title>frame 3: trace, 10.000 ms</title>") != std::string::npos);
    CHECK(to_svg({}).starts_with("<svg "));
}

TEST_CASE("statistics: the documented names are there") {
    RunRecord run{.scene = "a \"quoted\" \xff name.scn", .width = 4, .height = 2};
    run.frames.push_back({.frame = 3, .file = "out.0003.png", .device = "cpu", .precision = "float"});
    run.frames[0].statistics.grid = {2, 3, 4};
    const auto json = nlohmann::json::parse(to_json(run));
    for (const char* name : {"program", "version", "scene", "parse_ms", "evaluate_ms", "spheres", "moving",
                             "peak_host_bytes", "wall_ms", "frames"})
        CHECK_MESSAGE(json.contains(name), name);
    CHECK(json["peak_host_bytes"] > 1'000'000);
    const auto& frame = json["frames"][0];
    for (const char* name :
         {"frame",       "file",       "device",      "precision", "method",        "metric",    "grid",
          "wanted_grid", "references", "occupied",    "outliers",  "mean_distance", "motion_ms", "build_ms",
          "cloud_ms",    "trace_ms",   "readback_ms", "color_ms",  "encode_ms",     "write_ms",  "peak_device_bytes"})
        CHECK_MESSAGE(frame.contains(name), name);
    CHECK(frame["grid"] == nlohmann::json{2, 3, 4});
    CHECK(frame["frame"] == 3);
}
