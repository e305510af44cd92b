// SPDX-License-Identifier: Apache-2.0
// Numbers of a scene that a command line may set in the scene's place, because they trade accuracy for speed. They
// become part of the evaluated scene, and so of a frame's hash.
#pragma once
#include "parser/scene_program.h"

#include <cstdint>
#include <optional>

namespace proxima {

struct SceneOverrides {
    std::optional<uint32_t> max_trace_level{}; ///< 1 ... 256
    std::optional<float> adc_bailout{};
    std::optional<uint32_t> area_places{}; ///< that an area light has along an axis, at most

    friend bool operator==(const SceneOverrides&, const SceneOverrides&) = default;
};

void apply(const SceneOverrides& overrides, SceneProgram& scene);

} // namespace proxima
