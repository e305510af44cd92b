// SPDX-License-Identifier: Apache-2.0
// Two devices beside one: whole frames, tiles, relay, and files behind them; rates, busy shares and memory from the
// program's own statistics. Usage: multi_gpu_bench PROXIMA SCENES_FOLDER [DEVICE,DEVICE [FRAMES [COUNT
// [SIZE [LARGE_SIZE]]]]]
#include "tests/process.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

using namespace proxima;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct Setup {
    std::string program;
    fs::path scenes;
    std::string one = "cuda:0", two = "cuda:0,cuda:1";
    unsigned frames = 10'000;
    unsigned count = 1'000'000; ///< spheres
    std::string size = "1920x1080", large_size = "7680x4320";

    unsigned large_height() const { return unsigned(std::stoul(large_size.substr(large_size.find('x') + 1))); }
};

/// A run's figures. Times are in milliseconds.
struct Figures {
    json statistics;
    double wall = 0;             ///< of the process
    double begin = 0, end = 0;   ///< first step of any device and last one's end
    std::vector<double> read_at{}; ///< ends of read-backs, in order

    double at_work() const { return end - begin; }
    /// Median over the frames of the sum of some of their times.
    double median(const std::vector<std::string>& names) const {
        std::vector<double> sums;
        for (const json& frame : statistics["frames"]) {
            double sum = 0;
            for (const std::string& name : names)
                sum += frame[name].get<double>();
            sums.push_back(sum);
        }
        std::nth_element(sums.begin(), sums.begin() + long(sums.size() / 2), sums.end());
        return sums.at(sums.size() / 2);
    }
    double sum(const std::vector<std::string>& names) const {
        double sum = 0;
        for (const json& frame : statistics["frames"])
            for (const std::string& name : names)
                sum += frame[name].get<double>();
        return sum;
    }
    std::string busy() const {
        std::string text;
        for (const auto& [device, share] : statistics["busy"].items())
            text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", device, 100 * share.get<double>());
        return text;
    }
};

Figures render(const Setup& setup, const std::string& devices, const std::string& scene, unsigned frames,
               std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {setup.program, "render", (setup.scenes / scene).string(), "--device", devices, "--frames",
                      fmt::format("1-{}", frames), "--cyclic", "--progress", "none", "--stats-json", "bench.json"});
    const ProcessResult run = testing::run_process(arguments, ".", 300);
    if (run.exit_code != 0)
        throw std::runtime_error(fmt::format("{} ended with {}\n{}", scene, run.exit_code, run.standard_error));
    Figures figures{.statistics = json::parse(std::ifstream("bench.json")), .wall = 1e3 * run.wall_seconds};
    bool first = true;
    for (const json& span : figures.statistics["timeline"]) {
        if (span["device"] == "writer")
            continue;
        const double begin = span["begin_ms"], end = span["end_ms"];
        figures.begin = first ? begin : std::min(figures.begin, begin);
        figures.end = std::max(figures.end, end);
        first = false;
        if (span["step"] == "read-back")
            figures.read_at.push_back(end);
    }
    std::sort(figures.read_at.begin(), figures.read_at.end());
    return figures;
}

std::string declare(unsigned count) {
    return fmt::format("Count={}", count);
}

/// The largest `name` of some frames.
uint64_t largest(const json& frames, size_t first, size_t last, const std::string& name) {
    uint64_t most = 0;
    for (size_t i = first; i < std::min(last, frames.size()); ++i)
        most = std::max(most, frames[i][name].get<uint64_t>());
    return most;
}

void say(const std::string& what, const std::string& found) {
    fmt::print("| {} | {} |\n", what, found);
    std::fflush(stdout);
}

void measure_throughput(const Setup& setup) {
    const std::vector<std::string> arguments{"--declare", declare(setup.count),   "--size",   setup.size,
                                             "-o",        "discarded.######.exr", "--discard"};
    const Figures one = render(setup, setup.one, "swarm.scn", setup.frames, arguments);
    const Figures two = render(setup, setup.two, "swarm.scn", setup.frames, arguments);
    for (const auto& [name, figures] : {std::pair{"one", &one}, {"two", &two}}) {
        say(fmt::format("{} frames on {}: first launch to last read-back", setup.frames, name),
            fmt::format("{:.2f} s, {:.1f} frames/s", figures->at_work() / 1e3,
                        1e3 * setup.frames / figures->at_work()));
        say("- busy", figures->busy());
        say("- medians of a frame: motion, build, cloud, trace, read-back",
            fmt::format("{:.3f} {:.3f} {:.3f} {:.3f} {:.3f} ms", figures->median({"motion_ms"}),
                        figures->median({"build_ms"}), figures->median({"cloud_ms"}), figures->median({"trace_ms"}),
                        figures->median({"readback_ms"})));
        const json& frames = figures->statistics["frames"];
        for (const std::string memory : {"host_bytes", "peak_device_bytes"}) {
            const double early = double(largest(frames, 100, 200, memory));
            const double late =
                double(largest(frames, frames.size() - std::min<size_t>(frames.size(), 100), frames.size(), memory));
            if (early > 0)
                say("- " + memory + " after the first hundred and at the end",
                    fmt::format("{:.1f} and {:.1f} MB: {:+.2f} %", early / 1e6, late / 1e6, 100 * (late / early - 1)));
        }
    }
    say("ratio (at least 1.95)", fmt::format("{:.3f}", one.at_work() / two.at_work()));
}

constexpr unsigned large_frames = 60;

/// From the twentieth frame on: until then pictures are allocated, and their pages locked when they are used again.
double frame_interval(const Figures& figures, size_t bands) {
    constexpr size_t first = 20;
    const std::vector<double>& ends = figures.read_at;
    const size_t frames = ends.size() / bands;
    return (ends[frames * bands - 1] - ends[first * bands - 1]) / double(frames - first);
}

void measure_large_frame(const Setup& setup) {
    const auto run = [&](const std::string& devices, const std::string& mode, const std::string& in_flight,
                         const std::string& rows) {
        const Figures figures =
            render(setup, devices, "swarm.scn", large_frames,
                   {"--declare", declare(setup.count), "--size", setup.large_size, "-o", "discarded.######.exr",
                    "--discard", "--multi-gpu", mode, "--in-flight", in_flight, "--tile-rows", rows});
        const unsigned all = setup.large_height(), height = mode == "tiles" ? unsigned(std::stoul(rows)) : all;
        const double ms = frame_interval(figures, (all + height - 1) / height);
        say(fmt::format("{} on {}: {}, {} in flight, {} rows", setup.large_size, devices, mode, in_flight, height),
            fmt::format("{:.2f} ms; busy {}", ms, figures.busy()));
        return ms;
    };
    double one = run(setup.one, "frames", "1", "32");
    one = std::min(one, run(setup.one, "tiles", "2", "288"));
    double two = 1e9;
    for (const char* in_flight : {"1", "2"})
        for (const char* rows : {"160", "288", "544"})
            two = std::min(two, run(setup.two, "tiles", in_flight, rows));
    say("ratio of the best of each (at least 1.8)", fmt::format("{:.3f}", one / two));
}

void measure_files(const Setup& setup) {
    const unsigned frames = std::max(20u, setup.frames / 10);
    for (const std::string format : {"png", "exr"}) {
        fs::create_directories("bench_frames");
        const std::vector<std::string> arguments{
            "--declare", declare(setup.count), "--size", setup.size, "-o", "bench_frames/f.######." + format};
        std::vector<std::string> discarding = arguments;
        discarding.push_back("--discard");
        const Figures rendering = render(setup, setup.two, "swarm.scn", frames, discarding);
        const Figures both = render(setup, setup.two, "swarm.scn", frames, arguments);
        fs::remove_all("bench_frames");
        const double steps = both.sum({"color_ms", "encode_ms", "write_ms"});
        const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
        const double encoding = steps / threads;
        const double longest = std::max(rendering.at_work(), encoding);
        double last_written = 0; // starting the devices is not in it
        for (const json& span : both.statistics["timeline"])
            last_written = std::max(last_written, span["end_ms"].get<double>());
        const double last_read = both.at_work(), rest = last_written - both.begin;
        say(fmt::format("{} frames to {}: all, rendering alone, steps of {} writers with none idle", frames, format,
                        threads),
            fmt::format("{:.2f}, {:.2f}, {:.2f} s (last read-back at {:.2f})", rest / 1e3, rendering.at_work() / 1e3,
                        encoding / 1e3, last_read / 1e3));
        say("- ratio to the larger (at most 1.15)", fmt::format("{:.3f}", rest / longest));
    }
}

void measure_relay(const Setup& setup) {
    struct Row {
        const char* scene;
        unsigned count;
        const char* method;
    };
    const Row rows[] = {{"swarm.scn", setup.count, "grid"},
                        {"swarm.scn", setup.count, "cloud"},
                        {"clusters.scn", setup.count, "cloud"},
                        {"uniform.scn", 4 * setup.count, "grid"}};
    const unsigned frames = std::max(20u, setup.frames / 40);
    for (const Row& row : rows) {
        const std::vector<std::string> arguments{"--declare", declare(row.count),     "--size",    setup.size,
                                                 "-o",        "discarded.######.exr", "--discard", "--accel",
                                                 row.method};
        const auto run = [&](const std::string& devices, std::vector<std::string> more) {
            more.insert(more.begin(), arguments.begin(), arguments.end());
            return render(setup, devices, row.scene, frames, more);
        };
        const Figures alone = run(setup.one, {"--in-flight", "1"});
        const Figures two = run(setup.two, {"--multi-gpu", "frames"});
        const Figures relay = run(setup.two, {"--multi-gpu", "relay"});
        const Figures tiles = run(setup.two, {"--multi-gpu", "tiles"});
        const double motion = alone.median({"motion_ms"}), build = alone.median({"build_ms", "cloud_ms"}),
                     trace = alone.median({"trace_ms"}), copy = relay.median({"relay_ms"});
        const auto rate = [&](const Figures& figures) { return 1e3 * frames / figures.at_work(); };
        say(fmt::format("{}, {} spheres, {}", row.scene, row.count, row.method),
            fmt::format("motion {:.3f}, B {:.3f}, T {:.3f}, copy of grid and cloud {:.3f} ms", motion, build, trace,
                        copy));
        say("- frames/s: one, two by frames, by tiles, by relay",
            fmt::format("{:.0f}, {:.0f}, {:.0f}, {:.0f}", rate(alone), rate(two), rate(tiles), rate(relay)));
        say("- one build in two slabs, gathered (B / 2 and half of the copy) against B on each",
            fmt::format("{:.3f} against {:.3f} ms", build / 2 + copy / 2, build));
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(
            stderr,
            "usage: multi_gpu_bench PROXIMA SCENES_FOLDER [DEVICE,DEVICE [FRAMES [COUNT [SIZE [LARGE_SIZE]]]]]\n");
        return 2;
    }
    Setup setup{.program = argv[1], .scenes = argv[2]};
    if (argc > 3) {
        setup.two = argv[3];
        setup.one = setup.two.substr(0, setup.two.find(','));
    }
    if (argc > 4)
        setup.frames = unsigned(std::stoul(argv[4]));
    if (argc > 5)
        setup.count = unsigned(std::stoul(argv[5]));
    if (argc > 6)
        setup.size = argv[6];
    if (argc > 7)
        setup.large_size = argv[7];
    fmt::print("| what | found |\n|---|---|\n");
    measure_throughput(setup);
    measure_large_frame(setup);
    measure_files(setup);
    measure_relay(setup);
    return 0;
}
