// SPDX-License-Identifier: Apache-2.0
#include "renderer/statistics_json.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace proxima;

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
    for (const char* name : {"frame", "file", "device", "precision", "method", "metric", "grid", "references",
                             "occupied", "mean_distance", "motion_ms", "build_ms", "cloud_ms", "trace_ms",
                             "readback_ms", "color_ms", "encode_ms", "write_ms", "peak_device_bytes"})
        CHECK_MESSAGE(frame.contains(name), name);
    CHECK(frame["grid"] == nlohmann::json{2, 3, 4});
    CHECK(frame["frame"] == 3);
}
