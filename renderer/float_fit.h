// SPDX-License-Identifier: Apache-2.0
// Whether float holds a scene: how far its rounding moves what is seen, estimated from bounds before anything is
// rendered.
#pragma once
#include "parser/scene_program.h"

#include <span>
#include <string>

namespace proxima {

/// In float every coordinate is rounded to 2^-24 of itself, and so is every ray's direction. Seen from near by, the
/// first moves outlines by (coordinate / distance) * 2^-24, the second by 2^-24 or two, all as angles; what they come
/// to depends on how wide a pixel is. What lies outside of the picture does not count. Large spheres are met in double
/// (SceneView::meets_exactly): of them, only the place counts from which the ray is tested. It is an estimate, not a
/// bound: how often it errs is in tests/bench/NOTES.md.
struct FloatFit {
    /// By which float may move an outline: that changes an antialiased sample by at most one of 256 levels.
    static constexpr double most_pixels = 1.0 / 256;

    double pixels = 0;      ///< by which it does, about
    double pixel_angle = 0; ///< of the narrowest pixel of the picture; of parallel rays, the pixel's width
    double coordinate = 0;  ///< where that comes from: a coordinate of this size
    double distance = 0;    ///< that is seen from so far away
    bool in_range = true;   ///< squares of all lengths are normal numbers

    bool holds() const { return in_range && pixels <= most_pixels; }
    /// A clause that says why it does not hold.
    std::string reason() const;
};

/// The one of the two that says more against float.
const FloatFit& worse(const FloatFit& a, const FloatFit& b);

/// The worst of the scene as it is and at each of `moments`. `width` is the picture's, in pixels.
FloatFit float_fit(const SceneProgram& scene, uint32_t width, std::span<const MotionTime> moments = {});

} // namespace proxima
