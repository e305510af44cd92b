// SPDX-License-Identifier: Apache-2.0
// Area lights as POV-Ray 3.7 has them: a grid of points on a parallelogram, to which shadow rays go; all else follows
// the light's centre. The share of light is a quad-tree average, in which the points on the seams between quarters
// count more than once.
#pragma once
#include "kernels/shadow.h"

namespace proxima {

/// Numbers for the jitter of area lights: a stream a camera ray, so that every processor and tile has the same.
struct NoiseStream {
    uint32_t state = 0;

    /// In [-0.5, 0.5). Jarzynski and Olano, "Hash Functions for GPU Rendering", 2020 (PCG).
    HD float next() {
        state = state * 747796405u + 2891336453u;
        const uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
        return float(((word >> 22u) ^ word) >> 8) * (1.0f / 16777216.0f) - 0.5f;
    }
};

/// The places on one area light, as seen from a point.
template <class Real> struct AreaPlaces {
    const AreaLight<Real>& area;
    Vec3<Real> axis1, axis2;

    HD AreaPlaces(const AreaLight<Real>& area, const Vec3<Real>& to_light)
        : area(area), axis1(area.axis1), axis2(area.axis2) {
        if (!area.orient)
            return;
        // The light turns to the point: a square across the way, of the first axis' length.
        const Real length = glm::length(axis1);
        const bool steep = magnitude(magnitude(to_light.z) - Real(1)) < Real(0.01);
        const Vec3<Real> reference = steep ? Vec3<Real>(0, 1, 0) : Vec3<Real>(0, 0, 1);
        const Vec3<Real> across = glm::normalize(glm::cross(to_light, reference));
        axis1 = across * length;
        axis2 = glm::normalize(glm::cross(to_light, across)) * length;
    }

    /// Where place (u, v) lies from the centre.
    HD Vec3<Real> offset(Real u, Real v) const {
        Real a = area.columns > 1 ? u / Real(area.columns - 1) - Real(0.5) : Real(0);
        Real b = area.rows > 1 ? v / Real(area.rows - 1) - Real(0.5) : Real(0);
        if (area.circular) { // squares become circles
            a += Real(0.001);
            b += Real(0.001);
            const Real scale = larger(magnitude(a), magnitude(b)) / square_root(a * a + b * b);
            a *= scale;
            b *= scale;
        }
        return a * axis1 + b * axis2;
    }
};

/// A part of the grid that the adaptive average still has to visit.
struct AreaRegion {
    uint16_t u1, v1, u2, v2;
    uint32_t level;
};

/// The share of an area light that arrives at a surface. `color` is the light's, before shadows.
template <class Real, class Path>
HD_RARE Vec3<Real> area_light_arriving(const SceneView<Real>& scene, const Light<Real>& light,
                                       const Surface<Path>& surface, const Vec3<Real>& color, InteriorList& interiors,
                                       NoiseStream& noise) {
    const AreaLight<Real>& area = scene.area_lights[light.area];
    const Vec3<Real> point(surface.point);
    const AreaPlaces<Real> places(area, light_ray(light, point).direction);
    const auto arriving = [&](uint32_t u, uint32_t v) {
        const Real du = area.jitter ? Real(noise.next()) : Real(0);
        const Real dv = area.jitter ? Real(noise.next()) : Real(0);
        const LightRay<Real> ray = light_ray(light, point, places.offset(Real(u) + du, Real(v) + dv));
        return light_arriving(scene, surface, Vec3<Path>(ray.direction), ray.distance, interiors);
    };
    Vec3<Real> sum(Real(0));
    if (area.adaptive == AreaLight<Real>::every_place) {
        for (uint32_t i = 0; i < area.sample_count; ++i) {
            const AreaSample& sample = scene.area_samples[area.first_sample + i];
            sum += Real(sample.weight) * arriving(sample.u, sample.v);
        }
        return sum;
    }
    constexpr uint32_t deepest = 8; // regions of AreaLight::most places a side are single places then
    AreaRegion waiting[3 * deepest + 1];
    uint32_t depth = 0;
    waiting[depth++] = {0, 0, uint16_t(area.columns - 1), uint16_t(area.rows - 1), 0};
    while (depth > 0) {
        const AreaRegion region = waiting[--depth];
        const auto [u1, v1, u2, v2, level] = region;
        const Vec3<Real> corners[4] = {arriving(u1, v1), arriving(u2, v1), arriving(u2, v2), arriving(u1, v2)};
        bool differ = level < area.adaptive;
        for (int i = 0; i < 4; ++i) {
            const Vec3<Real> step = glm::abs(color * (corners[i] - corners[(i + 1) % 4]));
            differ = differ || step.x + step.y + step.z > Real(0.1);
        }
        if (differ && (u2 - u1 > 1 || v2 - v1 > 1)) {
            const uint16_t left = uint16_t((u1 + u2) / 2), right = uint16_t((u1 + u2 + 1) / 2);
            const uint16_t low = uint16_t((v1 + v2) / 2), high = uint16_t((v1 + v2 + 1) / 2);
            waiting[depth++] = {u1, v1, left, low, level + 1};
            waiting[depth++] = {right, v1, u2, low, level + 1};
            waiting[depth++] = {u1, high, left, v2, level + 1};
            waiting[depth++] = {right, high, u2, v2, level + 1};
        } else {
            sum += (corners[0] + corners[1] + corners[2] + corners[3]) / Real(4u << (2 * level));
        }
    }
    return sum;
}

} // namespace proxima
