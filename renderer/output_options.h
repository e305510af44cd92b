// SPDX-License-Identifier: Apache-2.0
// The options that say which files a run writes, how, and what it tells while it does.
#pragma once
#include "renderer/shared_options.h"

#include <string>

namespace proxima {

struct OutputTexts {
    std::string output, bits, compression, aov, fps, movie, progress = "auto", stats_json, timeline, report;
    bool dry_run = false, skip_existing = false;
};

/// What is in a frame's file.
void add_format_options(CLI::App& command, OutputTexts& texts);
/// The rest.
void add_output_options(CLI::App& command, OutputTexts& texts);

/// Sets the members of `options` that are about output, but not the layers; the scene's must be set. Throws UsageError.
/// `is_part`: not all frames are rendered now.
void read_output_options(const OutputTexts& texts, bool is_part, RenderOptions& options);

/// The layers of the files that `options` has. Throws UsageError when they cannot hold them.
AovLayers read_layers(const OutputTexts& texts, const RenderOptions& options);

} // namespace proxima
