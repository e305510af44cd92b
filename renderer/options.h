// SPDX-License-Identifier: Apache-2.0
// The command line as checked values. Whatever can be found wrong without reading a file is found here.
#pragma once
#include "parser/scene_script.h"
#include "renderer/animation.h"
#include "renderer/color.h"
#include "renderer/device_choice.h"
#include "renderer/fault_plan.h"
#include "renderer/frame_rate.h"
#include "renderer/frame_renderer.h"
#include "renderer/multi_gpu.h"
#include "renderer/output_name.h"
#include "renderer/progress.h"
#include "renderer/scene_overrides.h"
#include "renderer/tradeoff/picture_error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace proxima {

/// What decides how a scene file reads.
struct SceneOptions {
    std::filesystem::path scene;
    std::vector<std::filesystem::path> include_paths;
    std::vector<std::pair<std::string, std::string>> declares;
    uint32_t width = 640, height = 480; ///< pixels
    Animation animation;
    EvaluationBudget budget;
    SceneOverrides overrides;
};

/// How several devices share the work.
struct MultiGpuOptions {
    MultiGpu mode = MultiGpu::automatic;
    uint32_t in_flight = 0;    ///< frames on each device at once; 0: what suits it
    uint32_t tile_rows = 0;    ///< 0: by the number of devices
    std::vector<Fault> faults; ///< for tests
    bool discard = false;      ///< for measurements: frames are rendered and read back, and no file is made
};

/// --max-error: the program chooses what is not kept. Trace level, bail-out, area lights and shutter are never made
/// more accurate than asked for.
struct QualityRequest {
    std::string text; ///< as the user wrote it
    ErrorLimit limit;
    bool is_verified = false;
    bool keeps_sampling = false, keeps_precision = false;
};

struct RenderOptions {
    SceneOptions scene;
    std::optional<OutputName> output; ///< always set by parse_command_line
    SampleType type = SampleType::uint8;
    Compression compression = Compression::zip;
    FrameRate rate;
    std::optional<std::filesystem::path> movie;
    bool dither = false;
    bool dry_run = false;
    bool skip_existing = false;
    FrameSettings frame;
    std::optional<QualityRequest> max_error;
    DeviceChoice device;
    MultiGpuOptions multi_gpu;
    unsigned threads = 0; ///< 0: one for each core that the process may use
    ColorSettings color;
    ProgressStyle progress = ProgressStyle::automatic;
    std::optional<std::filesystem::path> stats_json, timeline, report;
};

/// Two pictures or sets of pictures; or, with `povray`, a scene that both programs render.
struct CompareOptions {
    std::filesystem::path a, b;
    std::vector<int64_t> frames; ///< that A and B must have; empty: those that are found
    bool povray = false;
    SceneOptions scene;
    FrameSettings frame;
    DeviceChoice device;
    unsigned threads = 0;
    double time_limit = 0;    ///< seconds for a frame by POV-Ray
    double tolerance = 0;     ///< white is 1
    double allowed_share = 0; ///< of the pixels that may be over it
    bool linear = false;      ///< decode levels to linear light first
    std::optional<std::filesystem::path> heatmap, report, json;
};

/// Frames that `render` would have made.
struct VerifyOptions {
    RenderOptions render;
};

/// What a colour configuration has to choose from.
struct ColorChoicesOptions {
    ColorSettings color;
};

struct CheckOptions {
    SceneOptions scene;
};

struct PlanOptions {
    SceneOptions scene;
    FrameSettings frame;
    DeviceChoice device;
    unsigned threads = 0;
    bool json = false;
};

/// Settings of one frame, measured against each other.
struct TradeoffOptions {
    SceneOptions scene;
    FrameSettings frame;
    DeviceChoice device;
    unsigned threads = 0;
    std::filesystem::path folder;
    uint32_t budget = 60; ///< seconds
    uint32_t repeats = 3;
    bool quiet = false;
};

struct DevicesOptions {
    bool json = false;
};

/// Experiments with scenes of the program's own.
struct BenchOptions {
    enum class Name { seed, sparse, scale } name = Name::seed;
    std::optional<std::filesystem::path> output; ///< the folder of tables, charts and scenes
    DeviceChoice device;
    unsigned threads = 0;
    bool full = false;               ///< everything, instead of about a minute's worth on two cores
    uint32_t width = 0, height = 0;  ///< 0: what suits
    uint32_t repeats = 0;            ///< frames that a time is the median of; 0: what suits
    std::vector<uint64_t> spheres;   ///< empty: what suits
    std::vector<std::string> scenes; ///< empty: all of the experiment's
    bool json = false;
};

/// --help and --version: text for standard output, and nothing else to do.
struct Information {
    std::string text;
};

using Command = std::variant<RenderOptions, VerifyOptions, ColorChoicesOptions, CheckOptions, PlanOptions,
                             CompareOptions, TradeoffOptions, BenchOptions, DevicesOptions, Information>;

/// Throws UsageError.
Command parse_command_line(int argc, const char* const* argv);

} // namespace proxima
