// SPDX-License-Identifier: Apache-2.0
// Scenes from files and texts, as the program reads them.
#pragma once
#include "parser/scene_program.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace proxima::testing {

using Declares = std::vector<std::pair<std::string, std::string>>;

/// Throws std::runtime_error with the mistakes of a scene that is refused.
SceneProgram read_scene(const std::filesystem::path& file, uint32_t width, uint32_t height,
                        const Declares& declares = {});

} // namespace proxima::testing
