// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/scene_text.h"
#include "parser/scene_script.h"

#include <stdexcept>

namespace proxima::testing {

SceneProgram read_scene(const std::filesystem::path& file, uint32_t width, uint32_t height, const Declares& declares) {
    Diagnostics diagnostics;
    SceneScript script(file, {}, diagnostics);
    EvaluationSettings settings;
    settings.image_width = width;
    settings.image_height = height;
    settings.declares = declares;
    settings.budget.steps = 10'000'000'000; // 50 million balls take more than what is taken for an endless loop
    settings.budget.seconds = 3600;
    SceneProgram scene = script.evaluate(settings, diagnostics);
    if (diagnostics.has_errors())
        throw std::runtime_error(diagnostics.format(script.files()));
    return scene;
}

} // namespace proxima::testing
