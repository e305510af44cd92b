// SPDX-License-Identifier: Apache-2.0
// Light sources as POV-Ray 3.7 defines them: a light and a point in, the way to the light and its share there out.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

enum class LightKind : uint32_t { point, spot, cylinder };

/// Fades by distance when fade_power > 0 and fade_distance is not 0: the factor is 2 / (1 + (d /
/// fade_distance)^fade_power). A shadowless light casts no shadow and makes no highlight.
template <class Real> struct Light {
    static constexpr uint32_t no_area = 0xffffffffu;

    Vec3<Real> position{Real(0)};
    glm::vec3 color{1.0f};
    float fade_distance = 0.0f;
    float fade_power = 0.0f;
    uint32_t shadowless = 0; ///< boolean
    LightKind kind = LightKind::point;
    uint32_t parallel = 0;   ///< boolean: its rays all run along `direction`
    uint32_t area = no_area; ///< index of its AreaLight
    Vec3<Real> point_at{Real(0), Real(0), Real(1)};
    Vec3<Real> direction{Real(0), Real(0), Real(1)}; ///< from position to point_at, unit length
    Real radius = Real(0);  ///< fully lit within: a spot's in cosines of the angle, a cylinder's in units
    Real falloff = Real(0); ///< dark beyond: as radius
    Real tightness = Real(0);

    HD bool is_plain() const { return kind == LightKind::point && !parallel; }
};

/// A grid of `columns` by `rows` places, spread by two axes around a light's position.
template <class Real> struct AreaLight {
    static constexpr uint32_t every_place = 0xffffffffu;
    static constexpr uint32_t most = 256; ///< places along an axis

    Vec3<Real> axis1{Real(0)};
    Vec3<Real> axis2{Real(0)};
    uint32_t columns = 1;
    uint32_t rows = 1;
    uint32_t circular = 0;           ///< boolean
    uint32_t orient = 0;             ///< boolean: the grid turns to the point that it lights
    uint32_t jitter = 0;             ///< boolean
    uint32_t adaptive = every_place; ///< the level from which regions are divided only where their corners differ
    uint32_t first_sample = 0;       ///< of its AreaSamples, for every_place
    uint32_t sample_count = 0;
};

/// A place of an area light and its weight in the quad-tree average.
struct AreaSample {
    uint32_t u, v;
    float weight;
};

/// The way from a point to a light.
template <class Real> struct LightRay {
    Vec3<Real> direction; ///< unit length
    Real distance;        ///< that a shadow ray goes; of a parallel light, not positive behind it
};

/// The way to a light with a direction, whose centre is moved by `offset`.
template <class Real>
HD_RARE LightRay<Real> directed_light_ray(const Light<Real>& light, const Vec3<Real>& point, const Vec3<Real>& offset) {
    const Vec3<Real> center = light.position + offset;
    LightRay<Real> ray;
    if (light.kind == LightKind::cylinder) {
        const Vec3<Real> axis = center - light.point_at;
        ray.direction = glm::normalize(axis);
        ray.distance = glm::dot(center - point, axis) / glm::length(axis);
    } else {
        const Vec3<Real> way = center - point;
        ray.distance = glm::length(way);
        ray.direction = way / ray.distance;
    }
    if (light.parallel) {
        const Vec3<Real> back =
            light.area == Light<Real>::no_area ? -light.direction : glm::normalize(center - light.point_at);
        ray.distance *= glm::dot(back, ray.direction);
        ray.direction = back;
    }
    return ray;
}

/// The way from a point to another.
template <class Real> HD LightRay<Real> straight_light_ray(const Vec3<Real>& from, const Vec3<Real>& to) {
    const Vec3<Real> way = to - from;
    const Real distance = glm::length(way);
    return {way / distance, distance};
}

/// The way from a point to a light, or to a place `offset` from its centre.
template <class Real>
HD LightRay<Real> light_ray(const Light<Real>& light, const Vec3<Real>& point,
                            const Vec3<Real>& offset = Vec3<Real>(Real(0))) {
    return light.is_plain() ? straight_light_ray(point, light.position + offset)
                            : directed_light_ray(light, point, offset);
}

/// 0 below `low`, 1 from `high` on, and a cubic without corners in between.
template <class Real> HD Real soft_step(Real low, Real high, Real v) {
    if (v < low)
        return Real(0);
    if (v >= high)
        return Real(1);
    const Real p = (v - low) / (high - low);
    return (Real(3) - Real(2) * p) * p * p;
}

/// The share of a spot or a cylinder that a point has.
template <class Real>
HD_RARE Real cone_share(const Light<Real>& light, const Vec3<Real>& point, const LightRay<Real>& ray) {
    if (light.kind == LightKind::spot) {
        const Real along = glm::dot(ray.direction, light.direction);
        const Real angle_cosine = ray.distance > 0 ? -along : along;
        if (!(angle_cosine > 0))
            return Real(0);
        const Real share = power(angle_cosine, light.tightness);
        return light.radius > 0 && angle_cosine < light.radius
                   ? share * soft_step(light.falloff, light.radius, angle_cosine)
                   : share;
    }
    const Vec3<Real> from_light = point - light.position;
    const Real along = glm::dot(from_light, light.direction);
    const Real from_axis = glm::length(from_light - along * light.direction);
    if (!(along > 0) || !(from_axis < light.falloff))
        return Real(0);
    const Real inward = Real(1) - from_axis / light.falloff;
    const Real share = power(inward, light.tightness);
    return light.radius > 0 && from_axis > light.radius
               ? share * soft_step(Real(0), Real(1) - light.radius / light.falloff, inward)
               : share;
}

/// What distance leaves of a light: 1 without fading, up to 2 close to it. `least_fade`: see HitLimits.
template <class Real> HD Real light_fade(const Light<Real>& light, Real distance, float least_fade) {
    if (!(light.fade_power > 0) || !(magnitude(light.fade_distance) > least_fade))
        return Real(1);
    return Real(2) / (Real(1) + power(distance / Real(light.fade_distance), Real(light.fade_power)));
}

/// What of a light's colour arrives at a point if nothing stands between.
template <class Real>
HD Real light_share(const Light<Real>& light, const Vec3<Real>& point, const LightRay<Real>& ray, float least_fade) {
    const Real share = light.kind == LightKind::point ? Real(1) : cone_share(light, point, ray);
    return share > 0 ? share * light_fade(light, ray.distance, least_fade) : Real(0);
}

} // namespace proxima
