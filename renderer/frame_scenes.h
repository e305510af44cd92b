// SPDX-License-Identifier: Apache-2.0
// The scenes that one picture is the mean of.
#pragma once
#include "renderer/float_fit.h"

#include <memory>
#include <vector>

namespace proxima {

struct FrameScenes {
    /// Frames whose scene is the same share one.
    std::vector<std::shared_ptr<const SceneProgram>> programs;
    /// With one program: the moments to move it to. Empty: it is as it was evaluated.
    std::vector<MotionTime> moments{};
    FloatFit fit{}; ///< of all of them
};

} // namespace proxima
