// SPDX-License-Identifier: Apache-2.0
// Whole programs on the same spheres, side by side: Proxima, POV-Ray and Tachyon, each run several times in turn,
// medians. Usage: scene_bench PROXIMA [RUNS [LARGEST_COUNT]]
#include "tests/bench/scene_files.h"
#include "tests/process.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

using namespace proxima;
using testing::ProcessResult;
namespace fs = std::filesystem;

namespace {

constexpr unsigned width = 1280, height = 720;

/// One run's figures by name; seconds, but for "MB".
using Figures = std::map<std::string, double>;

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// The number that the first group of `pattern` matches in `text`, or 0.
double number_in(const std::string& text, const std::string& pattern) {
    std::smatch match;
    return std::regex_search(text, match, std::regex(pattern)) ? std::stod(match[1]) : 0.0;
}

Figures whole_process(const std::vector<std::string>& command,
                      const std::function<Figures(const ProcessResult&)>& steps) {
    const ProcessResult run = testing::run_process(command);
    if (run.exit_code != 0)
        throw std::runtime_error(fmt::format("{} ended with {}\n{}", command[0], run.exit_code, run.standard_error));
    Figures figures = steps(run);
    figures["whole"] = run.wall_seconds;
    figures["MB"] = double(run.peak_bytes) / 1e6;
    return figures;
}

Figures run_proxima(const std::string& program, const fs::path& scene, const std::string& size) {
    return whole_process({program, "render", scene, "-o", "proxima.png", "--size", size, "--device", "cpu",
                          "--progress", "none", "--stats-json", "proxima.json"},
                         [](const ProcessResult&) {
                             const auto json = nlohmann::json::parse(std::ifstream("proxima.json"));
                             const auto& frame = json["frames"][0];
                             return Figures{
                                 {"parse", 1e-3 * (json["parse_ms"].get<double>() + json["evaluate_ms"].get<double>())},
                                 {"parse only", 1e-3 * json["parse_ms"].get<double>()},
                                 {"build", 1e-3 * frame["build_ms"].get<double>()},
                                 {"trace", 1e-3 * frame["trace_ms"].get<double>()},
                                 {"write", 1e-3 * (frame["color_ms"].get<double>() + frame["encode_ms"].get<double>() +
                                                   frame["write_ms"].get<double>())}};
                         });
}

Figures run_povray(const fs::path& scene) {
    return whole_process({"povray", "+I" + scene.string(), "+Opovray.png", fmt::format("+W{}", width),
                          fmt::format("+H{}", height), "-D", "-A", "-V"},
                         [](const ProcessResult& run) {
                             const std::string& text = run.standard_error;
                             return Figures{{"parse", number_in(text, R"(Parse Time:[^(]*\(([0-9.]+) seconds)")},
                                            {"build", number_in(text, R"(Bounding Time:[^(]*\(([0-9.]+) seconds)")},
                                            {"trace", number_in(text, R"(Trace Time:[^(]*\(([0-9.]+) seconds)")}};
                         });
}

Figures run_tachyon(const fs::path& scene) {
    return whole_process({"tachyon", scene, "-format", "TARGA", "-o", "tachyon.tga"}, [](const ProcessResult& run) {
        const std::string& text = run.standard_output;
        return Figures{{"parse", number_in(text, R"(Parsing Time:\s*([0-9.]+))")},
                       {"build", number_in(text, R"(Preprocessing Time:\s*([0-9.]+))")},
                       {"trace", number_in(text, R"(Tracing Time:\s*([0-9.]+))")},
                       {"write", number_in(text, R"(I/O Time:\s*([0-9.]+))")}};
    });
}

/// Runs the programs in turn, `runs` times, and returns each one's medians.
std::vector<Figures> in_turn(const std::vector<std::function<Figures()>>& programs, unsigned runs) {
    std::vector<std::map<std::string, std::vector<double>>> samples(programs.size());
    for (unsigned run = 0; run < runs; ++run)
        for (size_t i = 0; i < programs.size(); ++i)
            for (const auto& [name, value] : programs[i]())
                samples[i][name].push_back(value);
    std::vector<Figures> medians(programs.size());
    for (size_t i = 0; i < programs.size(); ++i)
        for (const auto& [name, values] : samples[i])
            medians[i][name] = median(values);
    return medians;
}

void print_row(uint64_t spheres, const std::string& program, const Figures& f, double own_whole) {
    const auto at = [&](const char* name) { return f.contains(name) ? f.at(name) : 0.0; };
    fmt::print("{:>9} {:<8} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f} {:>7.1f} {:>7.2f}\n", spheres, program,
               at("parse"), at("build"), at("trace"), at("write"), at("whole"), at("MB"), at("whole") / own_whole);
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: scene_bench PROXIMA [RUNS [LARGEST_COUNT]]\n");
        return 2;
    }
    const std::string program = fs::absolute(argv[1]);
    const unsigned runs = argc > 2 ? unsigned(std::stoul(argv[2])) : 3;
    const uint64_t largest = argc > 3 ? std::stoull(argv[3]) : 1'000'000;
    try {
        const fs::path folder = fs::temp_directory_path() / "proxima-scene-bench";
        fs::create_directories(folder);
        fs::current_path(folder);

        bench::write_scene("one.scn", 1);
        const Figures one = in_turn({[&] { return run_proxima(program, "one.scn", "160x120"); }}, 2 * runs + 1)[0];
        fmt::print("One sphere, 160x120, to PNG: {:.3f} s, {:.1f} MB. Medians of {} runs; seconds.\n", one.at("whole"),
                   one.at("MB"), runs);
        fmt::print("{:>9} {:<8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>7} {:>7}\n", "spheres", "program", "parse", "build",
                   "trace", "write", "whole", "MB", "ratio");

        for (uint64_t spheres = 10'000; spheres <= largest; spheres *= 10) {
            bench::write_scene("scene.scn", spheres);
            bench::write_nff("scene.nff", spheres, width, height);
            const auto medians =
                in_turn({[&] { return run_proxima(program, "scene.scn", fmt::format("{}x{}", width, height)); },
                         [&] { return run_povray("scene.scn"); }, [&] { return run_tachyon("scene.nff"); }},
                        runs);
            const double whole = medians[0].at("whole");
            print_row(spheres, "Proxima", medians[0], whole);
            print_row(spheres, "POV-Ray", medians[1], whole);
            print_row(spheres, "Tachyon", medians[2], whole);
            const double text = double(fs::file_size("scene.scn"));
            fmt::print(
                "          Proxima parses {:.0f} MB/s; peak memory {:.0f} bytes a sphere above one sphere's, the "
                "text ({:.1f} MB) apart\n",
                text / 1e6 / medians[0].at("parse only"),
                ((medians[0].at("MB") - one.at("MB")) * 1e6 - text) / double(spheres), text / 1e6);
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "scene_bench: {}\n", error.what());
        return 1;
    }
}
