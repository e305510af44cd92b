// SPDX-License-Identifier: Apache-2.0
// Whether a scene has spheres that are too large for a grid: rays in float meet those in double.
#pragma once
#include "kernels/grid_build.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace proxima {

/// The radius above which a sphere of the scene is large, by the rule of GridBuilder::find_bounds; infinity if none
/// is. What counts is where the spheres are now, before any motion.
inline double large_sphere_radius(std::span<const Sphere<double>> spheres) {
    double smallest = infinity<double>, largest = 0;
    for (const Sphere<double>& sphere : spheres) {
        smallest = std::min(smallest, sphere.radius > 0 ? sphere.radius : infinity<double>);
        largest = std::max(largest, sphere.radius);
    }
    if (!(largest > 16 * smallest)) // the usual case, and a quick one
        return infinity<double>;
    int64_t exponents = 0;
    uint64_t count = 0;
    for (const Sphere<double>& sphere : spheres)
        if (sphere.radius > 0) {
            exponents += exponent_of(sphere.radius);
            ++count;
        }
    const double radius = std::ldexp(1.0, large_exponent(exponents, count));
    return largest > radius ? radius : infinity<double>;
}

inline bool has_large_sphere(std::span<const Sphere<double>> spheres) {
    return large_sphere_radius(spheres) < infinity<double>;
}

} // namespace proxima
