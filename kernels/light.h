// SPDX-License-Identifier: Apache-2.0
// Point lights as POV-Ray 3.7 defines them.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// Fades by distance when fade_power > 0 and fade_distance is not 0: the factor is 2 / (1 + (d / fade_distance)^fade_power).
/// A shadowless light casts no shadow and makes no highlight.
template <class Real> struct Light {
    Vec3<Real> position{Real(0)};
    glm::vec3 color{1.0f};
    float fade_distance = 0.0f;
    float fade_power = 0.0f;
    uint32_t shadowless = 0; ///< boolean
};

} // namespace proxima
