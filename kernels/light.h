// SPDX-License-Identifier: Apache-2.0
// Point lights as POV-Ray 3.7 defines them.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// Fades by distance when fade_power > 0 and fade_distance is not 0: the factor is 2 / (1 + (d /
/// fade_distance)^fade_power). A shadowless light casts no shadow and makes no highlight.
template <class Real> struct Light {
    Vec3<Real> position{Real(0)};
    glm::vec3 color{1.0f};
    float fade_distance = 0.0f;
    float fade_power = 0.0f;
    uint32_t shadowless = 0; ///< boolean
};

/// What distance leaves of a light: 1 without fading, up to 2 close to it.
template <class Real> HD Real light_fade(const Light<Real>& light, Real distance) {
    if (!(light.fade_power > 0) || !(magnitude(light.fade_distance) > 1e-10f))
        return Real(1);
    return Real(2) / (Real(1) + power(distance / Real(light.fade_distance), Real(light.fade_power)));
}

} // namespace proxima
