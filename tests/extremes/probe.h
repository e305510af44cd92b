// SPDX-License-Identifier: Apache-2.0
// What the camera's rays hit, in full precision: the numbers behind a picture.
#pragma once
#include "parser/scene_program.h"
#include "renderer/frame_renderer.h"

#include <vector>

namespace proxima::testing {

/// What the ray through a pixel's middle meets first.
struct ProbedHit {
    uint32_t id = 0;          ///< from 1: spheres in the scene's order, then ellipsoids, then planes; 0: nothing
    Vec3<double> from_eye{0}; ///< the place on the surface, seen from the camera's location
    Vec3<double> normal{0};   ///< outward
};

struct Probes {
    uint32_t width = 0, height = 0;
    std::vector<ProbedHit> hits; ///< rows from top to bottom
};

/// The hits that render() with these settings shades: size, precision, tolerances and accelerator (grid or brute)
/// count.
Probes probe(const SceneProgram& scene, const FrameSettings& settings);

/// The scene with its camera turned so that every ray goes through the picture (x, y) pixels further right and down.
SceneProgram seen_beside(const SceneProgram& scene, const FrameSettings& settings, double x, double y);

} // namespace proxima::testing
