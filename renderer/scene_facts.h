// SPDX-License-Identifier: Apache-2.0
// What a frame's file tells of its scene.
#pragma once
#include "parser/scene_script.h"
#include "renderer/scene_hash.h"

namespace proxima {

struct SceneFacts {
    Hash128 hash{};
    SceneClock time{};
    Camera<double> camera{}; ///< at that time
    bool float_holds = true; ///< see FloatFit: what --precision auto goes by
};

} // namespace proxima
