// SPDX-License-Identifier: Apache-2.0
// Reading and evaluating large scenes, beside POV-Ray's parser: CPU seconds, medians of several runs in turn.
// Usage: parse_bench PROXIMA [RUNS]
#include "tests/bench/scene_files.h"
#include "tests/process.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/os.h>
#include <random>
#include <regex>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

constexpr const char* head = "#version 3.7;\n"
                             "global_settings { assumed_gamma 1.0 }\n"
                             "camera { location -3*z look_at 0 }\n"
                             "light_source { <4, 6, -5>, 1 }\n"
                             "#declare T = texture { pigment { rgb <0.9, 0.6, 0.3> } }\n";

void write_loop() {
    fmt::output_file("loop.scn")
        .print("{}{}", head,
               "#declare S = seed(1);\n"
               "#for (I, 1, 1000000)\n"
               "  sphere { <rand(S), rand(S), rand(S)>, 0.003 texture { T } }\n"
               "#end\n");
}

/// A sphere with twelve smaller ones around it, to the fifth generation: 1 + 12 + ... + 12^5 = 271,453 spheres.
void write_flake() {
    fmt::output_file("flake.scn")
        .print("{}{}", head,
               "#macro Flake(Level)\n"
               "  union {\n"
               "    sphere { 0, 1 }\n"
               "    #if (Level > 0)\n"
               "      #local I = 0;\n"
               "      #while (I < 6)\n"
               "        #local J = 0;\n"
               "        #while (J < 2)\n"
               "          object { Flake(Level - 1) scale 1/3 translate 4/3*y\n"
               "                   rotate <0, 0, 60*I> rotate (20*Level + 90*J)*y }\n"
               "          #local J = J + 1;\n"
               "        #end\n"
               "        #local I = I + 1;\n"
               "      #end\n"
               "    #end\n"
               "    texture { T }\n"
               "  }\n"
               "#end\n"
               "Flake(5)\n");
}

void write_data() {
    std::mt19937_64 random(2014);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    auto file = fmt::output_file("data.txt");
    for (int i = 0; i < 1'000'000; ++i)
        file.print("{}{:.6f}, {:.6f}, {:.6f}, 0.003", i ? ",\n" : "", uniform(random), uniform(random),
                   uniform(random));
    fmt::output_file("read.scn")
        .print("{}{}", head,
               "#fopen Data \"data.txt\" read\n"
               "#while (defined(Data))\n"
               "  #read (Data, X, Y, Z, R)\n"
               "  sphere { <X, Y, Z>, R texture { T } }\n"
               "#end\n");
}

double proxima_seconds(const std::string& program, const std::string& scene) {
    const auto run = testing::run_process({program, "check", scene});
    if (run.exit_code != 0)
        throw std::runtime_error(run.standard_error);
    return run.cpu_seconds;
}

double povray_seconds(const std::string& scene) {
    const auto run = testing::run_process({"povray", "+I" + scene, "+W4", "+H4", "-D", "-F", "+WT1"});
    std::smatch match;
    const std::regex pattern(R"(Parse Time:[^\n]*\n\s*using \d+ thread\(s\) with ([0-9.]+) CPU-seconds)");
    if (run.exit_code != 0 || !std::regex_search(run.standard_error, match, pattern))
        throw std::runtime_error(run.standard_error);
    return std::stod(match[1]);
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: parse_bench PROXIMA [RUNS]\n");
        return 2;
    }
    const std::string program = fs::absolute(argv[1]);
    const unsigned runs = argc > 2 ? unsigned(std::stoul(argv[2])) : 3;
    try {
        const fs::path folder = fs::temp_directory_path() / "proxima-parse-bench";
        fs::create_directories(folder);
        fs::current_path(folder);
        bench::write_scene("literal.scn", 1'000'000);
        write_loop();
        write_flake();
        write_data();
        fmt::print("CPU seconds to read and evaluate, medians of {} runs\n{:<10} {:>8} {:>8} {:>7}\n", runs, "scene",
                   "Proxima", "POV-Ray", "ratio");
        for (const std::string scene : {"literal.scn", "loop.scn", "flake.scn", "read.scn"}) {
            std::vector<double> ours, theirs;
            for (unsigned run = 0; run < runs; ++run) {
                ours.push_back(proxima_seconds(program, scene));
                theirs.push_back(povray_seconds(scene));
            }
            fmt::print("{:<10} {:>8.3f} {:>8.3f} {:>7.1f}\n", fs::path(scene).stem().string(), median(ours),
                       median(theirs), median(theirs) / median(ours));
            std::fflush(stdout);
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "parse_bench: {}\n", error.what());
        return 1;
    }
}
