// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/rounding.h"
#include "renderer/large_spheres.h"

#include <algorithm>
#include <cmath>

namespace proxima::testing {
namespace {

/// The square root of the sum of all squares.
double norm(const Mat3<double>& m) {
    return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
}

/// Of what is in the bounds, how far from the origin it reaches.
double reach(const SceneProgram& scene) {
    const double large = large_sphere_radius(scene.spheres);
    double reach = 0;
    for (const Sphere<double>& sphere : scene.spheres)
        if (!(sphere.radius > large))
            reach = std::max(reach, glm::length(sphere.center) + sphere.radius);
    for (const Ellipsoid<double>& ellipsoid : scene.ellipsoids)
        reach =
            std::max(reach, glm::length(ellipsoid.world_from_object.offset) + norm(ellipsoid.world_from_object.linear));
    return reach;
}

} // namespace

double turning_bound(const SceneProgram& scene, const ProbedHit& hit) {
    const double eye = glm::length(scene.camera.location), distance = glm::length(hit.from_eye);
    const double base = eye + reach(scene);
    double center = 0, radius = 0, condition = 1;
    const size_t index = hit.id - 1, ellipsoids = scene.ellipsoids.size();
    if (index < scene.spheres.size()) {
        center = glm::length(scene.spheres[index].center);
        radius = scene.spheres[index].radius;
    } else if (index - scene.spheres.size() < ellipsoids) {
        const Ellipsoid<double>& ellipsoid = scene.ellipsoids[index - scene.spheres.size()];
        center = glm::length(ellipsoid.world_from_object.offset);
        radius = norm(ellipsoid.world_from_object.linear);
        condition = radius * norm(ellipsoid.object_from_world.linear);
    }
    return 0x1p-53 * condition * (6 * center + 18 * eye + 69 * distance + 85 * radius + 36 * base);
}

} // namespace proxima::testing
