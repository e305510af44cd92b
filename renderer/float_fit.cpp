// SPDX-License-Identifier: Apache-2.0
#include "renderer/float_fit.h"
#include "renderer/large_spheres.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

namespace proxima {
namespace {

/// What rounding to float changes a number by at most is 2^-24; several roundings seldom add up. In tests/extremes the
/// worst outline moves by 0.3 to 0.4 times what 2^-24 would make of it.
constexpr double unit = 0.4 * 0x1p-24;

double largest_component(const Vec3<double>& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The lengths that a ray in float has to do with.
struct Lengths {
    double smallest = infinity<double>, largest = 0;
    double ratio = 0; ///< the largest of coordinate / distance, and where it is
    double coordinate = 0, distance = 0;

    void add_size(double size) {
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    void add_seen(double at, double from) {
        largest = std::max(largest, at);
        if (at > ratio * from) {
            ratio = at / from;
            coordinate = at;
            distance = from;
        }
    }
    static Lengths combine(const Lengths& a, const Lengths& b) {
        Lengths both = a.ratio < b.ratio ? b : a;
        both.smallest = std::min(a.smallest, b.smallest);
        both.largest = std::max(a.largest, b.largest);
        return both;
    }
};

/// From where spheres are seen. Parallel rays are moved aside by as much however far they go.
struct Eye {
    Vec3<double> location;
    double own; ///< its largest coordinate
    bool parallel;

    explicit Eye(const Camera<double>& camera)
        : location(camera.location), own(largest_component(camera.location)),
          parallel(camera.kind == CameraKind::orthographic) {}

    void add(Lengths& lengths, const Sphere<double>& sphere) const {
        lengths.add_size(sphere.radius);
        const double coordinate = own + largest_component(sphere.center) + sphere.radius;
        const double distance = std::abs(glm::length(sphere.center - location) - sphere.radius);
        lengths.add_seen(coordinate, parallel ? 1.0 : distance);
    }
};

Lengths lengths_of(const SceneTables& tables, std::span<const Sphere<double>> spheres) {
    const Eye eye(tables.camera);
    const double large = large_sphere_radius(spheres);
    Lengths lengths = tbb::parallel_reduce(
        tbb::blocked_range<size_t>(0, spheres.size(), 4096), Lengths{},
        [&](const auto& range, Lengths sum) {
            for (size_t i = range.begin(); i != range.end(); ++i)
                if (spheres[i].radius > 0 && !(spheres[i].radius > large))
                    eye.add(sum, spheres[i]);
            return sum;
        },
        Lengths::combine);
    for (const Ellipsoid<double>& ellipsoid : tables.ellipsoids) {
        const Box<double> box = bounding_box(ellipsoid);
        const Vec3<double> half = 0.5 * (box.upper - box.lower);
        eye.add(lengths, {ellipsoid.world_from_object.offset, std::max({half.x, half.y, half.z})});
    }
    return lengths;
}

FloatFit fit_of(const SceneTables& tables, std::span<const Sphere<double>> spheres, uint32_t width) {
    const Camera<double>& camera = tables.camera;
    const Lengths lengths = lengths_of(tables, spheres);
    const double right = glm::length(camera.right), up = glm::length(camera.up), ahead = glm::length(camera.direction);
    FloatFit fit;
    fit.coordinate = lengths.coordinate;
    fit.distance = lengths.distance;
    if (camera.kind == CameraKind::orthographic) {
        fit.pixel_angle = right / width;
        fit.pixels = unit * lengths.ratio / fit.pixel_angle;
    } else {
        const double corner2 = 0.25 * (right * right + up * up) / (ahead * ahead);
        fit.pixel_angle = right / (width * ahead) / (1 + corner2);
        fit.pixels = unit * (lengths.ratio + 2) / fit.pixel_angle;
    }
    // A square must not vanish beside another one in float, nor overflow.
    constexpr double least = 1e-15, most = 1e18;
    fit.in_range = lengths.smallest > least && lengths.largest < most && std::min(right, ahead) > least &&
                   std::max({right, up, ahead}) < most;
    return fit;
}

} // namespace

const FloatFit& worse(const FloatFit& a, const FloatFit& b) {
    if (a.in_range != b.in_range)
        return a.in_range ? b : a;
    return a.pixels < b.pixels ? b : a;
}

std::string FloatFit::reason() const {
    if (!in_range)
        return "float has no room for the squares of its lengths";
    return fmt::format("float would move what is seen by up to {:.2g} pixels", pixels);
}

FloatFit float_fit(const SceneProgram& scene, uint32_t width, std::span<const MotionTime> moments) {
    FloatFit fit = fit_of(scene, scene.spheres, width);
    if (scene.motion.empty() || moments.empty())
        return fit;
    SceneTables tables = scene;
    std::vector<Sphere<double>> spheres = scene.spheres;
    for (const MotionTime& moment : moments)
        if (move_fields(tables, scene.motion, moment) && move_spheres(spheres, scene.motion, moment))
            fit = worse(fit, fit_of(tables, spheres, width));
    return fit;
}

} // namespace proxima
