// SPDX-License-Identifier: Apache-2.0
// How far one precision is from another: hits that differ, places that moved, levels of the picture.
#pragma once
#include "tests/extremes/probe.h"

#include <array>

namespace proxima::testing {

/// An outline may lie this far from where double has it, in pixels.
inline constexpr double outline_tolerance = 1e-3;

/// Double's hits, and those of eight pictures around it whose rays are outline_tolerance of a pixel aside: what a ray
/// may see there without being wrong.
struct Reference {
    Probes hits;
    std::array<Probes, 8> beside;
};
Reference reference_hits(const SceneProgram& scene, FrameSettings settings);

struct HitFigures {
    uint64_t rays = 0;
    uint64_t other = 0; ///< hits of something else than in double
    uint64_t wrong = 0; ///< of these, what double does not see within outline_tolerance of a pixel either
    uint64_t not_finite = 0;
    double rms_over_radius = 0; ///< distance between the two places of a hit, in radii of the sphere that it is on
    double most_pixels = 0;     ///< the largest displacement, across the ray or out of the surface, in pixels
};
HitFigures compare_hits(const Reference& reference, const Probes& hits, const SceneProgram& scene);

struct LevelFigures {
    uint64_t not_finite = 0; ///< samples of either picture
    double within_one = 1;   ///< share of 8-bit samples within a level of each other
    double equal = 1;        ///< share of equal ones
};
/// Of the levels of sRGB.
LevelFigures compare_levels(const Image& a, const Image& b);

/// Renders with the precision that the settings name.
Image render_scene(const SceneProgram& scene, const FrameSettings& settings);

/// Double's picture and eight around it, whose rays are outline_tolerance of a pixel aside.
std::vector<Image> pictures_beside(const SceneProgram& scene, FrameSettings settings);

/// The share of pixels that one of `pictures` has as well, each sample within a level.
double share_seen_beside(const std::vector<Image>& pictures, const Image& image);

} // namespace proxima::testing
