// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/scene_text.h"
#include "renderer/scene_source.h"

namespace proxima::testing {

SceneProgram read_scene(const std::filesystem::path& file, uint32_t width, uint32_t height, const Declares& declares) {
    SceneOptions options;
    options.scene = file;
    options.declares = declares;
    options.width = width;
    options.height = height;
    SceneSource source(options);
    source.scenes(0);
    return source.program();
}

} // namespace proxima::testing
