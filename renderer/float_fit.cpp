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

/// Rounding to float changes a number by 2^-24 of itself at most; what several roundings add up to in the worst pixel
/// was measured in random scenes (tests/extremes/float_study.cpp): in the first half of them, this is exceeded in less
/// than one of a hundred.
constexpr double unit = 1.4 * 0x1p-24;

double largest_component(const Vec3<double>& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// The lengths that a ray in float has to do with.
struct Lengths {
    double smallest = infinity<double>, largest = 0;
    double ratio = 0; ///< the largest of length / distance, and where it is
    double coordinate = 0, distance = 0;
    Box<double> bounds{Vec3<double>(infinity<double>), Vec3<double>(-infinity<double>)}; ///< of what is not large

    void add_size(double size) {
        smallest = std::min(smallest, size);
        largest = std::max(largest, size);
    }
    /// Rounding moves something at this coordinate, `way` from the eye, by as much of its length as a coordinate of
    /// at + 2 way; seen from `distance`.
    void add_seen(double at, double way, double from) {
        largest = std::max({largest, at, way});
        if (at + 2 * way > ratio * from) {
            ratio = (at + 2 * way) / from;
            coordinate = at;
            distance = from;
        }
    }
    static Lengths combine(const Lengths& a, const Lengths& b) {
        Lengths both = a.ratio < b.ratio ? b : a;
        both.smallest = std::min(a.smallest, b.smallest);
        both.largest = std::max(a.largest, b.largest);
        both.bounds = joined(a.bounds, b.bounds);
        return both;
    }
};

/// From where things are seen: the tip of a cone around all rays of the camera. Parallel rays are moved aside by as
/// much however far they go.
class Eye {
public:
    explicit Eye(const Camera<double>& camera)
        : location_(camera.location), ahead_(glm::normalize(camera.direction)),
          own_(largest_component(camera.location)), width_(glm::length(camera.right) + glm::length(camera.up)),
          parallel_(camera.kind == CameraKind::orthographic) {
        if (parallel_)
            return;
        for (const double right : {-0.5, 0.5})
            for (const double up : {-0.5, 0.5}) {
                const Vec3<double> corner = glm::normalize(camera.direction + right * camera.right + up * camera.up);
                cosine_ = std::min(cosine_, glm::dot(corner, ahead_));
            }
        sine_ = std::sqrt(1 - cosine_ * cosine_);
    }

    /// What is in the bounds. `magnified`: what rounding is, for a sphere that is none.
    void add(Lengths& lengths, const Sphere<double>& sphere, double magnified = 1) const {
        lengths.add_size(sphere.radius);
        lengths.bounds = joined(lengths.bounds, {sphere.center - sphere.radius, sphere.center + sphere.radius});
        const Vec3<double> to = sphere.center - location_;
        const double coordinate = own_ + magnified * (largest_component(sphere.center) + sphere.radius);
        lengths.largest = std::max(lengths.largest, coordinate);
        const double distance = std::abs(glm::length(to) - sphere.radius);
        if (parallel_)
            lengths.add_seen(coordinate, glm::length(to) + sphere.radius, 1);
        else if (is_seen(to, sphere.radius))
            lengths.add_seen(coordinate, distance, distance);
    }
    /// A sphere that is met in double, or what is left of its radius.
    void add_large(Lengths& lengths, const Sphere<double>& sphere) const {
        const Vec3<double> to = sphere.center - location_;
        if (parallel_)
            return add_large_in_parallel(lengths, to, sphere.radius);
        const double far = glm::length(to);
        const double angle = off_axis(to / far);
        const double beside = far * std::sin(angle);
        if (far < sphere.radius)
            add_beyond(lengths, sphere.radius - far);
        else if (angle < half_pi && beside < sphere.radius)
            add_beyond(lengths, far * std::cos(angle) - std::sqrt((sphere.radius - beside) * (sphere.radius + beside)));
    }
    void add(Lengths& lengths, const Plane<double>& plane) const {
        const double height = plane.distance - glm::dot(plane.normal, location_);
        const double angle = off_axis(height < 0 ? -plane.normal : plane.normal);
        if (angle < half_pi)
            add_beyond(lengths, (std::abs(height) + (parallel_ ? width_ : 0)) / std::cos(angle),
                       std::abs(plane.distance));
    }

private:
    static constexpr double half_pi = 1.5707963267948966;

    /// The longest way to it counts, since nothing far away is seen smaller.
    void add_large_in_parallel(Lengths& lengths, const Vec3<double>& to, double radius) const {
        const double along = glm::dot(to, ahead_), aside = std::sqrt(std::max(0.0, glm::dot(to, to) - along * along));
        const double nearest = std::max(0.0, aside - width_), farthest = std::min(radius, aside + width_);
        if (nearest > radius || along < -radius)
            return;
        const bool inside = glm::length(to) < radius + width_;
        add_beyond(lengths, inside ? along + std::sqrt(radius * radius - nearest * nearest)
                                   : along - std::sqrt(radius * radius - farthest * farthest));
    }
    /// Whether a sphere reaches into the cone.
    bool is_seen(const Vec3<double>& to, double radius) const {
        const double along = glm::dot(to, ahead_);
        const double aside = std::sqrt(std::max(0.0, glm::dot(to, to) - along * along));
        return aside * cosine_ - along * sine_ <= radius;
    }
    /// The least angle between a direction and a ray.
    double off_axis(const Vec3<double>& direction) const {
        return std::max(0.0, std::acos(std::clamp(glm::dot(direction, ahead_), -1.0, 1.0)) - std::acos(cosine_));
    }
    /// Something `distance` away that may lie before the place where rays enter the bounds, from which they are tested.
    void add_beyond(Lengths& lengths, double distance, double coordinate = 0) const {
        const Vec3<double> nearest = glm::clamp(location_, lengths.bounds.lower, lengths.bounds.upper);
        const double entry = lengths.smallest < infinity<double> ? glm::length(nearest - location_) : 0;
        lengths.add_seen(own_ + coordinate + entry, distance, parallel_ ? 1.0 : distance);
    }

    Vec3<double> location_, ahead_;
    double own_;   ///< the location's largest coordinate
    double width_; ///< of a picture of parallel rays, and its height
    bool parallel_;
    double cosine_ = 1, sine_ = 0; ///< of the cone's angle
};

/// By how much its map magnifies rounding on most of an ellipsoid: not at all on its broad sides, and by the longest of
/// its axes over the shortest one at its far ends.
double magnification(const Ellipsoid<double>& ellipsoid) {
    double product = 1;
    for (const Affine<double>& map : {ellipsoid.world_from_object, ellipsoid.object_from_world}) {
        double squares = 0;
        for (int i = 0; i < 3; ++i)
            squares += glm::dot(map.linear[i], map.linear[i]);
        product *= std::sqrt(squares / 3);
    }
    return std::sqrt(product);
}

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
        eye.add(lengths, {ellipsoid.world_from_object.offset, std::max({half.x, half.y, half.z})},
                magnification(ellipsoid));
    }
    if (large < infinity<double>)
        for (const Sphere<double>& sphere : spheres)
            if (sphere.radius > large)
                eye.add_large(lengths, sphere);
    for (const Plane<double>& plane : tables.planes)
        eye.add(lengths, plane);
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
        fit.pixels = unit * lengths.ratio / fit.pixel_angle;
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
