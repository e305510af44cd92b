// SPDX-License-Identifier: Apache-2.0
// What a feature costs that no ray of the picture needs: the trace of `features` with one thing more that nobody sees.
// Usage: feature_bench PROXIMA SCENES [DEVICE [COUNT [SIZE [ROUNDS]]]]
#include "tests/process.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

constexpr const char* features[] = {"none",          "reflection", "transparency", "pattern",
                                    "spot light",    "area light", "sky sphere",   "fog",
                                    "no_reflection", "ellipsoid",  "motion"};

struct Bench {
    std::string program, scene, device, count, size;

    /// Milliseconds of tracing, of frames that are all alike but the first two.
    std::vector<double> trace(size_t extra) const {
        const auto result = testing::run_process({program,
                                                  "render",
                                                  scene,
                                                  "-o",
                                                  "frame.####.exr",
                                                  "--frames",
                                                  "1-8",
                                                  "--cyclic",
                                                  "--size",
                                                  size,
                                                  "--accel",
                                                  "grid",
                                                  "--device",
                                                  device,
                                                  "--declare",
                                                  "Count=" + count,
                                                  "--declare",
                                                  fmt::format("Extra={}", extra),
                                                  "--stats-json",
                                                  "stats.json",
                                                  "--progress",
                                                  "none"},
                                                 ".", 7200);
        if (result.exit_code != 0)
            throw std::runtime_error(result.standard_error);
        const nlohmann::json stats = nlohmann::json::parse(std::ifstream("stats.json"));
        std::vector<double> values;
        for (size_t i = 2; i < stats.at("frames").size(); ++i)
            values.push_back(stats["frames"][i].at("trace_ms"));
        return values;
    }
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Rounds over all features, so that what disturbs the machine disturbs all alike.
void run(const Bench& bench, size_t rounds) {
    std::vector<std::vector<double>> all(std::size(features));
    for (size_t round = 0; round < rounds; ++round)
        for (size_t extra = 0; extra < all.size(); ++extra) {
            const std::vector<double> values = bench.trace(extra);
            all[extra].insert(all[extra].end(), values.begin(), values.end());
        }
    fmt::print("{} spheres, {}, {}: milliseconds to trace a frame\n{:<14} {:>9} {:>9} {:>7}\n", bench.count, bench.size,
               bench.device, "one more", "median", "least", "times");
    for (size_t extra = 0; extra < all.size(); ++extra)
        fmt::print("{:<14} {:>9.3f} {:>9.3f} {:>7.3f}\n", features[extra], median(all[extra]),
                   std::ranges::min(all[extra]), median(all[extra]) / median(all[0]));
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(stderr, "usage: feature_bench PROXIMA SCENES [DEVICE [COUNT [SIZE [ROUNDS]]]]\n");
        return 2;
    }
    const auto text = [&](int index, const char* otherwise) {
        return std::string(argc > index ? argv[index] : otherwise);
    };
    try {
        const Bench bench{fs::absolute(argv[1]), fs::absolute(fs::path(argv[2]) / "features.scn"), text(3, "cpu"),
                          text(4, "100000"), text(5, "640x480")};
        const fs::path folder = fs::temp_directory_path() / "proxima-feature-bench";
        fs::create_directories(folder);
        fs::current_path(folder);
        run(bench, std::stoul(text(6, "3")));
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "feature_bench: {}\n", error.what());
        return 1;
    }
}
