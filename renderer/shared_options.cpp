// SPDX-License-Identifier: Apache-2.0
#include "renderer/shared_options.h"
#include "renderer/errors.h"
#include "renderer/frame_range.h"
#include "renderer/option_values.h"
#include "renderer/shard.h"

#include <unordered_set>

namespace proxima {
namespace {

Animation read_animation(const SceneTexts& texts) {
    const bool has_clock = !texts.clock.empty();
    const ClockValues clock = has_clock ? parse_clock(texts.clock) : ClockValues{};
    if (texts.frames.empty()) {
        if (!texts.subset.empty())
            throw UsageError("--subset: it chooses from an animation's frames; give --frames A-B too");
        if (!texts.shard.empty())
            throw UsageError("--shard: it chooses from an animation's frames; give --frames A-B too");
        if (texts.cyclic)
            throw UsageError("--cyclic: only an animation goes round; give --frames A-B too");
        if (clock.final)
            throw UsageError(
                fmt::format("--clock {}: a still has one clock; write --clock {}, or give --frames A-B too",
                            texts.clock, clock.initial));
        return Animation::still(has_clock ? std::optional(clock.initial) : std::nullopt);
    }
    if (has_clock && !clock.final)
        throw UsageError(fmt::format("--clock {0}: an animation's clock is a range; write --clock 0:{0}", texts.clock));

    const std::vector<int64_t> all = parse_frame_range("--frames", texts.frames);
    std::vector<int64_t> frames = texts.subset.empty() ? all : parse_frame_range("--subset", texts.subset);
    const std::unordered_set<int64_t> known(all.begin(), all.end());
    for (const int64_t frame : frames)
        if (!known.contains(frame))
            throw UsageError(
                fmt::format("--subset {}: frame {} is not one of --frames {}; --frames is the whole animation",
                            texts.subset, frame, texts.frames));
    if (!texts.shard.empty())
        frames = parse_shard(texts.shard).of(frames);
    Animation animation = Animation::sequence(all, std::move(frames));
    animation.cyclic = texts.cyclic;
    if (clock.final) {
        animation.initial_clock = clock.initial;
        animation.final_clock = *clock.final;
    }
    return animation;
}

/// --shutter and --shutter-samples.
Shutter read_shutter(const SceneTexts& texts, const Animation& animation) {
    constexpr uint32_t default_samples = 16;
    if (texts.shutter.empty()) {
        if (!texts.shutter_samples.empty())
            throw UsageError("--shutter-samples: there is no shutter; give --shutter OPEN:CLOSE too");
        return {};
    }
    if (animation.is_still)
        throw UsageError("--shutter: it is counted in steps from frame to frame; give --frames A-B too");
    const auto [open, close] = parse_shutter(texts.shutter);
    return {open, close,
            texts.shutter_samples.empty()
                ? default_samples
                : parse_count("--shutter-samples", texts.shutter_samples, 1, Shutter::most_samples)};
}

SceneOverrides read_overrides(const SceneTexts& texts) {
    SceneOverrides overrides;
    if (!texts.max_trace_level.empty())
        overrides.max_trace_level = parse_count("--max-trace-level", texts.max_trace_level, 1, 256);
    if (!texts.adc_bailout.empty())
        overrides.adc_bailout = float(parse_ratio("--adc-bailout", texts.adc_bailout, "0.01 or 1/255"));
    if (!texts.area_places.empty())
        overrides.area_places = parse_count("--area-places", texts.area_places, 1, AreaLight<double>::most);
    return overrides;
}

} // namespace

void add_shutter_options(CLI::App& command, SceneTexts& texts) {
    command
        .add_option("--shutter", texts.shutter,
                    "Motion blur: from where to where a frame is exposed, in steps from frame to frame [0:0]")
        ->type_name("OPEN:CLOSE");
    command
        .add_option("--shutter-samples", texts.shutter_samples,
                    "Moments that a frame is the mean of: the middles of N equal parts of the exposure [16]")
        ->type_name("N");
}

void add_override_options(CLI::App& command, SceneTexts& texts) {
    command
        .add_option("--max-trace-level", texts.max_trace_level,
                    "Surfaces that a path goes on from, in place of the scene's number: 1 to 256")
        ->type_name("N");
    command
        .add_option("--adc-bailout", texts.adc_bailout,
                    "The share of a pixel below which a path ends, in place of the scene's: 0.01, 1/255")
        ->type_name("B");
    command
        .add_option("--area-places", texts.area_places,
                    "Places that an area light has along each axis, at most; 1 makes a point of it")
        ->type_name("N");
}

void add_scene(CLI::App& command, SceneTexts& texts) {
    command.add_option("SCENE", texts.scene, "The scene file, - for standard input, or a POV-Ray .ini");
}

void add_choice_options(CLI::App& command, SceneTexts& texts, const char* doing) {
    command.add_option("--subset", texts.subset, fmt::format("The frames of --frames to {} now [all]", doing))
        ->type_name("RANGE");
    command
        .add_option("--shard", texts.shard,
                    "Part I of N of those, every Nth frame; slurm: the part that a Slurm array task is [1/1]")
        ->type_name("I/N");
}

void add_scene_options(CLI::App& command, SceneTexts& texts) {
    command.add_option("--size", texts.size, "Width x height in pixels [640x480]")->type_name("WxH");
    command.add_option("--frames", texts.frames, "The animation: sets clock and numbering (1-100, 1-100x2, 1,3,5..9)")
        ->type_name("RANGE");
    command.add_option("--clock", texts.clock, "A still's clock, or an animation's first and last [0:1]")
        ->type_name("V|A:B");
    command.add_flag("--cyclic", texts.cyclic, "The clock stops one step short of its last value");
    command.add_option("--declare", texts.declares, "Declares NAME before the scene is read; repeatable")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
    command.add_option("--include-path", texts.include_paths, "Folder for #include, after the scene's; repeatable")
        ->type_name("DIR")
        ->expected(1)
        ->take_all();
    command.add_option("--max-steps", texts.max_steps, "Refuse a scene that takes more tokens, in millions [500]")
        ->type_name("N");
    command
        .add_option("--max-memory", texts.max_memory, "... more memory to evaluate [three quarters of the machine's]")
        ->type_name("MB");
    command.add_option("--max-seconds", texts.max_seconds, "... more time to evaluate, for each frame [600]")
        ->type_name("S");
}

void add_device_options(CLI::App& command, DeviceTexts& texts) {
    command
        .add_option("--device", texts.device,
                    "auto, cpu, cuda (every one), cuda:N, or a list like cuda:0,2 or cuda,cpu [auto: every CUDA "
                    "device, or the CPU]")
        ->type_name("DEVICE");
    command.add_option("--accel", texts.accelerator, "How rays find spheres: auto, grid, cloud, brute [auto]")
        ->type_name("METHOD");
    command
        .add_option("--metric", texts.metric, "Of the cloud: chessboard, city-block, euclidean, octant [chessboard]")
        ->type_name("M");
    command.add_option("--brick", texts.brick, "Voxels along a brick of the cloud: 1, 2, 4 or 8 [auto]")
        ->type_name("B");
    command.add_option("--grid", texts.grid, "Voxels along each axis [auto: chosen from the scene]")
        ->type_name("N|NxNxN");
    command
        .add_option("--precision", texts.precision,
                    "auto (float, or double for a scene that float does not hold: it says so), float or double [" +
                        texts.precision + "]")
        ->type_name("P");
    command.add_option("--threads", texts.threads, "CPU threads [0: all cores]")->type_name("N");
}

void add_antialias_option(CLI::App& command, std::string& text) {
    command
        .add_option(
            "--antialias", text,
            "POV-Ray's without jitter: grid:N, method1[:THRESHOLD[:DEPTH]] or method2[:THRESHOLD[:DEPTH]] [none]")
        ->type_name("MODE");
}

SceneOptions read_scene_options(const SceneTexts& texts) {
    SceneOptions options;
    options.scene = texts.scene;
    options.include_paths.assign(texts.include_paths.begin(), texts.include_paths.end());
    for (const std::string& declare : texts.declares)
        options.declares.push_back(parse_declare(declare));
    std::tie(options.width, options.height) = parse_size(texts.size);
    options.animation = read_animation(texts);
    options.animation.shutter = read_shutter(texts, options.animation);
    if (!texts.max_steps.empty())
        options.budget.steps = 1'000'000ull * parse_count("--max-steps", texts.max_steps, 1, 1'000'000'000);
    if (!texts.max_memory.empty())
        options.budget.bytes = uint64_t(parse_count("--max-memory", texts.max_memory, 1, 1'000'000'000)) << 20;
    if (!texts.max_seconds.empty())
        options.budget.seconds = parse_count("--max-seconds", texts.max_seconds, 1, 1'000'000);
    options.overrides = read_overrides(texts);
    return options;
}

FrameSettings read_frame_settings(const SceneOptions& scene, const DeviceTexts& texts) {
    FrameSettings frame;
    frame.width = scene.width;
    frame.height = scene.height;
    frame.precision = parse_choice<Precision>(
        "--precision", texts.precision,
        {{"auto", Precision::automatic}, {"float", Precision::float32}, {"double", Precision::float64}});
    frame.accelerator = parse_choice<Accelerator>("--accel", texts.accelerator,
                                                  {{"auto", Accelerator::automatic},
                                                   {"grid", Accelerator::grid},
                                                   {"cloud", Accelerator::cloud},
                                                   {"brute", Accelerator::brute}});
    frame.metric = parse_choice<Metric>("--metric", texts.metric,
                                        {{"chessboard", Metric::chessboard},
                                         {"city-block", Metric::city_block},
                                         {"euclidean", Metric::euclidean},
                                         {"octant", Metric::octant}});
    frame.brick = parse_choice<uint32_t>("--brick", texts.brick, {{"auto", 0}, {"1", 1}, {"2", 2}, {"4", 4}, {"8", 8}});
    if (texts.grid != "auto")
        frame.grid = parse_grid(texts.grid);
    return frame;
}

} // namespace proxima
