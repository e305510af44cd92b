// SPDX-License-Identifier: Apache-2.0
// What a pixel shows, in numbers other than light: the layers that a file may hold beside its picture.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// Of the first surface on the ray through a pixel's middle, glass or not; never a mean over several rays. The defaults
/// are those of a ray that meets nothing.
struct AovSample {
    float depth = 1e10f;    ///< along the direction of view, in the scene's units
    glm::vec3 normal{0.0f}; ///< of unit length, in the scene's axes, on the side that is seen
    uint32_t id = 0;        ///< from 1: spheres in the scene's order, then ellipsoids, then planes
    uint32_t steps = 0;     ///< voxels or bricks that were looked up until the surface was found; 0 without a grid
};

/// The layers that are asked for.
struct AovLayers {
    bool depth = false, normal = false, id = false, steps = false;

    bool any() const { return depth || normal || id || steps; }
    friend bool operator==(const AovLayers&, const AovLayers&) = default;
};

} // namespace proxima
