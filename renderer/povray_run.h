// SPDX-License-Identifier: Apache-2.0
// One frame of a scene rendered by POV-Ray 3.7, as linear light at 16 bits.
#pragma once
#include "renderer/options.h"
#include "renderer/stored_image.h"

#include <string>
#include <vector>

namespace proxima {

/// The command that makes POV-Ray render `frame` into `folder` as picture.png: one thread (area lights repeat), no
/// jitter, no display. Throws UsageError for a path with a double quote, which POV-Ray cannot be given.
std::vector<std::string> povray_command(const SceneOptions& scene, const Antialiasing& antialiasing, int64_t frame,
                                        const std::filesystem::path& folder);

/// Runs POV-Ray, for at most `time_limit` seconds, in a temporary folder. Throws FileError when it is not installed,
/// takes too long or leaves no picture, SceneRejected with what it said when it fails.
StoredImage render_with_povray(const SceneOptions& scene, const Antialiasing& antialiasing, int64_t frame,
                               double time_limit);

} // namespace proxima
