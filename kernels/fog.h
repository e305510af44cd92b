// SPDX-License-Identifier: Apache-2.0
// Fog as POV-Ray 3.7 has it: a part of a ray in, what the fog adds and what it leaves of the light behind out.
#pragma once
#include "kernels/geometry.h"

#include <span>

namespace proxima {

enum class FogKind : uint32_t { constant, ground };

template <class Real> struct Fog {
    FogKind kind = FogKind::constant;
    glm::vec3 color{0.0f};
    float filter = 0.0f;
    float transmit = 0.0f; ///< what always comes through
    Real distance = Real(0);
    Vec3<Real> up{Real(0), Real(1), Real(0)}; ///< of ground fog, as are the next two; unit length
    Real offset = Real(0);                    ///< the height up to which the fog is as thick as a constant one
    Real altitude = Real(1);                  ///< above `offset`, where its density is half of that
};

template <class Real> struct FogEffect {
    Vec3<Real> added{Real(0)};
    Vec3<Real> left{Real(1)};
};

/// The mean density between two heights: 1 below 0, 1 / (1 + h^2) above.
template <class Real> HD Real mean_fog_density(Real start, Real end) {
    if (start <= 0)
        return end <= 0 ? Real(1) : (arc_tangent(end) - start) / (end - start);
    if (end <= 0)
        return (arc_tangent(start) - end) / (start - end);
    const Real rise = start - end;
    return magnitude(rise) > Real(1e-10) ? (arc_tangent(start) - arc_tangent(end)) / rise
                                         : Real(1) / (start * start + Real(1));
}

/// Along `length` of a ray.
template <class Real>
HD_RARE FogEffect<Real> fog_along(std::span<const Fog<Real>> fogs, const Ray<Real>& ray, Real length) {
    FogEffect<Real> effect;
    for (const Fog<Real>& fog : fogs) {
        Real thickness = length / fog.distance;
        if (fog.kind == FogKind::ground) {
            const Real start = glm::dot(ray.origin, fog.up);
            const Real end = glm::dot(ray.origin + length * ray.direction, fog.up);
            thickness *= mean_fog_density((start - fog.offset) / fog.altitude, (end - fog.offset) / fog.altitude);
        }
        const Real left = larger(exponential(-thickness), Real(fog.transmit));
        const Vec3<Real> color(fog.color);
        const Real filter = Real(fog.filter);
        effect.left *= left * (Vec3<Real>(Real(1) - filter) + filter * color);
        effect.added += (Real(1) - left) * color;
    }
    return effect;
}

} // namespace proxima
