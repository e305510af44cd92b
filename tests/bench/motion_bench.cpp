// SPDX-License-Identifier: Apache-2.0
// Spheres that all move, three sines each: milliseconds a frame for every step, from --stats-json; and a hundred frames
// to PNG beside POV-Ray. Usage: motion_bench PROXIMA [DEVICE [FRAMES]]
#include "tests/process.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/os.h>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

/// N spheres on orbits of their own in the unit cube. The text is POV-Ray's, too.
void write_scene(const std::string& path, size_t spheres) {
    fmt::output_file(path).print(
        "#version 3.7;\n"
        "global_settings {{ assumed_gamma 1.0 }}\n"
        "camera {{ location <0.5, 0.5, -1.6> look_at 0.5 angle 46 right x*image_width/image_height }}\n"
        "light_source {{ <4, 6, -5>, 1 }}\n"
        "#declare T = texture {{ pigment {{ rgb <0.9, 0.6, 0.3> }} }}\n"
        "#declare S = seed(4);\n"
        "#for (I, 1, {})\n"
        "  sphere {{\n"
        "    <rand(S) + 0.05*sin(2*pi*clock + 7*rand(S)), rand(S) + 0.05*sin(4*pi*clock + 7*rand(S)),\n"
        "     rand(S) + 0.05*sin(6*pi*clock + 7*rand(S))>, {:.6f}\n"
        "    texture {{ T }}\n"
        "  }}\n"
        "#end\n",
        spheres, 0.3 / std::cbrt(double(spheres)));
}

testing::ProcessResult run(const std::vector<std::string>& command) {
    testing::ProcessResult result = testing::run_process(command, ".", 7200);
    if (result.exit_code != 0)
        throw std::runtime_error(fmt::format("{}:\n{}", command[0], result.standard_error));
    return result;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

void print_row(const std::string& program, const std::string& device, unsigned frames, size_t spheres,
               const std::string& size) {
    run({program, "render", fmt::format("{}.scn", spheres), "-o", "frame.####.png", "--frames",
         fmt::format("1-{}", frames), "--cyclic", "--size", size, "--device", device, "--stats-json", "stats.json",
         "--progress", "none"});
    const nlohmann::json stats = nlohmann::json::parse(std::ifstream("stats.json"));
    const auto milliseconds = [&](const char* step) {
        const auto& all = stats.at("frames");
        std::vector<double> values;
        for (size_t i = all.size() > 4 ? 2 : 0; i < all.size(); ++i) // the first two start the device
            values.push_back(all[i].at(step));
        return median(values);
    };
    fmt::print("{:>9} {:>10} {:>9.1f} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} {:>10.1f}\n", spheres, size,
               double(stats.at("evaluate_ms")), milliseconds("motion_ms"),
               milliseconds("build_ms") + milliseconds("cloud_ms"), milliseconds("trace_ms"),
               milliseconds("readback_ms"), double(stats.at("wall_ms")) / frames);
    std::fflush(stdout);
}

/// A hundred frames to PNG by both programs, one after the other.
void race(const std::string& program, const std::string& device, unsigned frames) {
    const auto ours =
        run({program, "render", "1000.scn", "-o", "ours.####.png", "--frames", fmt::format("1-{}", frames), "--cyclic",
             "--size", "640x480", "--device", device, "--progress", "none"});
    const auto theirs = run(
        {"povray", "+I1000.scn", "+Otheirs.png", "+W640", "+H480", "-A", "-D", fmt::format("+KFF{}", frames), "+KC"});
    fmt::print("\n{} frames of 1000 spheres, 640x480, to PNG: Proxima {:.1f} s, POV-Ray {:.1f} s, ratio {:.1f}; CPU "
               "seconds {:.1f} and {:.1f}, ratio {:.1f}\n",
               frames, ours.wall_seconds, theirs.wall_seconds, theirs.wall_seconds / ours.wall_seconds,
               ours.cpu_seconds, theirs.cpu_seconds, theirs.cpu_seconds / ours.cpu_seconds);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: motion_bench PROXIMA [DEVICE [FRAMES]]\n");
        return 2;
    }
    const std::string program = fs::absolute(argv[1]), device = argc > 2 ? argv[2] : "cpu";
    const unsigned frames = argc > 3 ? unsigned(std::stoul(argv[3])) : 100;
    try {
        const fs::path folder = fs::temp_directory_path() / "proxima-motion-bench";
        fs::create_directories(folder);
        fs::current_path(folder);
        fmt::print(
            "{}: milliseconds a frame, medians of {} frames\n{:>9} {:>10} {:>9} {:>9} {:>9} {:>9} {:>9} {:>10}\n",
            device, frames, "spheres", "size", "evaluate", "motion", "build", "trace", "read back", "wall/frame");
        for (const size_t spheres : {1000, 100'000, 1'000'000}) {
            write_scene(fmt::format("{}.scn", spheres), spheres);
            for (const char* size : {"640x480", "1920x1080"})
                print_row(program, device, frames, spheres, size);
        }
        if (device == "cpu") // where POV-Ray is
            race(program, device, frames);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "motion_bench: {}\n", error.what());
        return 1;
    }
}
