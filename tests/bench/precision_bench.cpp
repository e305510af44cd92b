// SPDX-License-Identifier: Apache-2.0
// What precisions cost: milliseconds a frame of some scenes in each, of one program or of several builds of it, in
// turn. Usage: precision_bench SOURCES DEVICE FRAMES PROXIMA...
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

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

struct Times {
    double trace = 0, device = 0; ///< of the trace, and of all steps on the device; milliseconds
};

/// Medians over the frames but the first two, which start the device.
Times measure(const fs::path& program, const std::string& precision, const fs::path& scene, const std::string& device,
              unsigned frames) {
    const auto result = testing::run_process({program, "render", scene, "--frames", fmt::format("1-{}", frames),
                                              "--size", "1920x1080", "--device", device, "--precision", precision,
                                              "--discard", "--stats-json", "stats.json", "--progress", "none"},
                                             ".", 3600);
    if (result.exit_code != 0)
        throw std::runtime_error(result.standard_error);
    const nlohmann::json stats = nlohmann::json::parse(std::ifstream("stats.json"));
    std::vector<double> trace, device_times;
    const auto& all = stats.at("frames");
    for (size_t i = all.size() > 4 ? 2 : 0; i < all.size(); ++i) {
        const auto& frame = all[i];
        trace.push_back(frame.at("trace_ms"));
        device_times.push_back(double(frame.at("motion_ms")) + double(frame.at("build_ms")) +
                               double(frame.at("cloud_ms")) + trace.back() + double(frame.at("readback_ms")));
    }
    return {median(trace), median(device_times)};
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 5) {
        fmt::print(stderr, "usage: precision_bench SOURCES DEVICE FRAMES PROXIMA...\n");
        return 2;
    }
    const fs::path sources = fs::absolute(argv[1]);
    std::vector<fs::path> programs;
    for (int i = 4; i < argc; ++i)
        programs.push_back(fs::absolute(argv[i]));
    try {
        const fs::path folder = fs::temp_directory_path() / "proxima-precision-bench";
        fs::create_directories(folder);
        fs::current_path(folder);
        fmt::print("{}: milliseconds a frame of 1920x1080, medians of {} frames\n{:<24} {:>9} {:>8} {:>9} {:>9}\n",
                   argv[2], argv[3], "scene", "precision", "program", "trace", "device");
        for (const char* scene :
             {"tests/bench/scenes/uniform.scn", "tests/bench/scenes/planes.scn", "tests/bench/scenes/clusters.scn",
              "examples/02_sphereflake.scn", "examples/06_glass.scn"})
            for (const char* precision : {"double", "float"})
                for (size_t i = 0; i < programs.size(); ++i) {
                    const Times times = measure(programs[i], precision, sources / scene, argv[2], std::stoul(argv[3]));
                    fmt::print("{:<24} {:>9} {:>8} {:>9.3f} {:>9.3f}\n", fs::path(scene).stem().string(), precision,
                               i + 1, times.trace, times.device);
                    std::fflush(stdout);
                }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "precision_bench: {}\n", error.what());
        return 1;
    }
}
