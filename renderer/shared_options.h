// SPDX-License-Identifier: Apache-2.0
// Options that more than one command has: their declaration to CLI11, and their texts in, checked values out.
#pragma once
#include "renderer/options.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace proxima {

/// The options as the user wrote them; empty where absent.
struct SceneTexts {
    std::string scene, size = "640x480", frames, subset, shard, clock;
    std::string max_steps, max_memory, max_seconds;
    std::vector<std::string> include_paths, declares;
    std::string shutter, shutter_samples;
    std::string max_trace_level, adc_bailout, area_places;
    bool cyclic = false;
};

struct DeviceTexts {
    std::string device = "auto", accelerator = "auto", grid = "auto", metric = "chessboard", brick = "auto",
                precision = "auto", threads = "0";
};

void add_scene(CLI::App& command, SceneTexts& texts);
/// --subset and --shard, which choose from the frames.
void add_choice_options(CLI::App& command, SceneTexts& texts, const char* doing);
/// --shutter and --shutter-samples.
void add_shutter_options(CLI::App& command, SceneTexts& texts);
/// --max-trace-level, --adc-bailout and --area-places, in place of the scene's own numbers.
void add_override_options(CLI::App& command, SceneTexts& texts);
/// Everything but the scene itself and those.
void add_scene_options(CLI::App& command, SceneTexts& texts);
void add_device_options(CLI::App& command, DeviceTexts& texts);
void add_antialias_option(CLI::App& command, std::string& text);

/// Both throw UsageError.
SceneOptions read_scene_options(const SceneTexts& texts);
FrameSettings read_frame_settings(const SceneOptions& scene, const DeviceTexts& texts);

} // namespace proxima
