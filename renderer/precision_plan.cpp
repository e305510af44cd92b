// SPDX-License-Identifier: Apache-2.0
#include "renderer/precision_plan.h"
#include "renderer/large_spheres.h"

#include <algorithm>

namespace proxima {

PlanSection precision_plan(const SceneProgram& scene, const FloatFit& fit) {
    const double large = large_sphere_radius(scene.spheres);
    const auto is_large = [&](const Sphere<double>& sphere) { return sphere.radius > large; };
    const auto count = uint64_t(std::ranges::count_if(scene.spheres, is_large));
    const std::string decision = !fit.holds() ? "double: " + fit.reason()
                                 : count > 0  ? "float, but for what is large: rays meet that in double"
                                              : "float holds the scene";
    return {.name = "precision",
            .decision = decision,
            .values = {{"moved_pixels", fit.pixels},
                       {"pixel_angle", fit.pixel_angle},
                       {"coordinate", fit.coordinate},
                       {"seen_from", fit.distance},
                       {"large_spheres", count}}};
}

} // namespace proxima
