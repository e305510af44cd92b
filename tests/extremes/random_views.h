// SPDX-License-Identifier: Apache-2.0
// Random scenes of opaque spheres, over the whole range from what float holds with ease to what it does not hold.
#pragma once
#include "parser/scene_program.h"
#include "renderer/float_fit.h"

#include <random>

namespace proxima::testing {

struct RandomView {
    SceneProgram scene;
    uint32_t width = 0; ///< of a picture of it, 64 to 4096 pixels; it is three quarters as high
};

/// The same for the same state of `engine` with every standard library.
RandomView random_view(std::mt19937_64& engine);

/// What float does to such a picture.
struct FloatTrial {
    FloatFit fit;
    double measured = 0; ///< the largest displacement, in pixels; 0 where nothing is hit
    uint64_t wrong = 0;  ///< hits: see HitFigures
};
/// By 64 x 48 of the picture's rays.
FloatTrial try_float(const RandomView& view);

} // namespace proxima::testing
