// SPDX-License-Identifier: Apache-2.0
// The heart of a frame: a pixel in, its light out. Paths are followed in a loop, never by recursion: of several ways
// on, one is taken and the others wait in a stack that the frame sizes by the scene (pending.h).
#pragma once
#include "kernels/area_light.h"
#include "kernels/film.h"
#include "kernels/layers.h"
#include "kernels/pending.h"
#include "kernels/sky.h"

namespace proxima {

/// What a scene has; TracePixels is compiled for each. What a kernel can do it pays for, in registers at least, whether
/// it is done or not. Plain scenes have point lights, colours and checkers, no sky sphere, and nothing that is hidden
/// from some rays; none but the last has area lights, fog or anything lit from both sides.
enum class Features : uint32_t {
    opaque,    ///< plain; no reflection, no transparency
    mirrors,   ///< plain; no transparency; at most one layer of a material reflects, and without an exponent
    furnished, ///< no reflection, no transparency
    all,
};

/// The precision in which paths are followed: see surface.h. A path that ends at its first surface needs no more than
/// the tests do.
template <class Real, Features features>
using PathPrecision = std::conditional_t<features == Features::opaque, Real, double>;

/// Follows the paths of one thread. `sum` is the light found so far. `shapes`, `ways`: of the scene's grid.
template <class Real, Features features, RoundShapes shapes = RoundShapes::all, Ways ways = Ways::any> struct Tracer {
    static constexpr bool plain = features == Features::opaque || features == Features::mirrors;
    static constexpr bool transparent = features == Features::all;
    /// Every path, at its first surface.
    static constexpr bool ends = features == Features::opaque || features == Features::furnished;
    using Path = PathPrecision<Real, features>;
    using State = PathState<Real, Path>;

    const SceneView<Real>& scene;
    PendingView<Real, Path> pending{};
    InteriorList interiors{}; ///< of the current path
    NoiseStream noise{};
    Vec3<Real> sum{Real(0)};

    /// The light that comes along a ray.
    HD Vec3<Real> light_along(const Ray<Path>& ray) {
        State path;
        path.ray.ray = ray;
        sum = Vec3<Real>(Real(0));
        if constexpr (transparent)
            interiors = interiors_at(scene, ray.origin);
        while (advance(path) || resume(path)) {
        }
        if (transparent && interiors.overflow)
            atomic_add(&pending.overflows[0], 1);
        return sum;
    }

    /// Goes to the next surface, adds its light, and turns the path into what goes on from there. False when it ends.
    HD bool advance(State& path) {
        if (path.weight < Real(scene.adc_bailout))
            return false;
        const BasedRay<Real> based = rebase(path.ray, scene.geometry.bounds);
        const HitLimits<Real>& limits = scene.limits;
        const uint32_t hidden = !plain && scene.has_hidden ? path.hidden : 0u;
        const Hit<Real> hit =
            find_nearest<shapes, ways>(scene, based, path.passed, limits.nearest, limits.farthest, hidden);
        const Vec3<Real> direction(path.ray.ray.direction);
        if constexpr (transparent)
            if (!scene.fogs.empty())
                pass_fog(path, based, hit);
        if (hit.primitive == no_primitive) {
            sum += path.throughput * (plain ? Vec3<Real>(scene.background) : sky_light(scene, direction));
            return false;
        }
        const Surface<Path> surface = surface_at(scene, path.ray, based, hit);
        const Surface<Real> seen = surface.template rounded<Real>();
        Real ior = Real(1);
        if constexpr (!ends)
            ior = far_over_near_ior(scene, interiors, surface.primitive);
        const LayerStack<Real, plain> layers(scene, seen, -glm::dot(direction, seen.normal), ior);
        sum += path.throughput * layers.glow();
        for (const Light<Real>& light : scene.lights)
            sum += path.throughput * light_from(light, surface, layers, direction);
        if constexpr (ends)
            return false;
        else
            return go_on(path, surface, layers, hit, distance_passed(based, path.passed, hit));
    }

    /// Dims a path by the fog on its way to the next hit, or to where POV-Ray's rays end. There is none in objects that
    /// are not hollow.
    HD_RARE void pass_fog(State& path, const BasedRay<Real>& based, const Hit<Real>& hit) {
        for (uint32_t i = 0; i < interiors.count; ++i)
            if (!(scene.surfaces.materials[scene.geometry.material(interiors.ids[i])].flags & material_hollow))
                return;
        const Ray<Path>& ray = path.ray.ray;
        const Path start = path.passed.primitive == no_primitive ? Path(0) : Path(based.offset) + Path(path.passed.t);
        const Ray<Real> segment{Vec3<Real>(ray.origin + start * ray.direction), Vec3<Real>(ray.direction)};
        const Real length = hit.primitive == no_primitive ? Real(2e10) : distance_passed(based, path.passed, hit);
        const FogEffect<Real> fog = fog_along(scene.fogs, segment, length);
        sum += path.throughput * fog.added;
        path.throughput *= fog.left;
    }

    /// What the surface sends back of one light.
    HD Vec3<Real> light_from(const Light<Real>& light, const Surface<Path>& surface,
                             const LayerStack<Real, plain>& layers, const Vec3<Real>& eye_direction) {
        const Vec3<Real>& point = layers.surface.point;
        const LightRay<Real> ray = plain ? straight_light_ray(point, light.position) : light_ray(light, point);
        const LightGeometry<Real> geometry{layers.surface.normal, ray.direction, eye_direction};
        if (!(glm::dot(geometry.normal, geometry.to_light) >= Real(1e-10)) &&
            (!transparent || !(scene.surfaces.materials[surface.material].flags & material_double_illuminate)))
            return Vec3<Real>(Real(0));
        Vec3<Real> arriving =
            Vec3<Real>(light.color) * (plain ? light_fade(light, ray.distance, scene.limits.least_fade)
                                             : light_share(light, point, ray, scene.limits.least_fade));
        if (arriving == Vec3<Real>(Real(0)))
            return arriving;
        if (light.shadowless)
            return layers.reflected(geometry, arriving, false);
        if constexpr (!transparent) { // all of it or nothing, so that less needs to be kept while a shadow is looked
                                      // for
            const Vec3<Real> reflected = layers.reflected(geometry, arriving, true);
            return is_shadowed<shapes, ways>(scene, surface, Vec3<Path>(ray.direction), ray.distance)
                       ? Vec3<Real>(Real(0))
                       : reflected;
        } else {
            arriving *= light.area == Light<Real>::no_area
                            ? light_arriving(scene, surface, Vec3<Path>(ray.direction), ray.distance, interiors)
                            : area_light_arriving(scene, light, surface, arriving, interiors, noise);
            if (arriving == Vec3<Real>(Real(0)))
                return arriving;
            return layers.reflected(geometry, arriving, true);
        }
    }

    /// The transmitted ray waits longest, so that at most one set of a surface's rays waits for each level of a path.
    HD bool go_on(State& path, const Surface<Path>& surface, const LayerStack<Real, plain>& layers,
                  const Hit<Real>& hit, Real distance) {
        if (path.level + 1 >= scene.max_trace_level)
            return false; // even for a ray that goes straight on, which takes no level
        const bool reflects = scene.surfaces.materials[surface.material].flags & material_reflective;
        if constexpr (transparent) {
            const Vec3<Real> transmission = layers.transmission();
            if (magnitude(grey(transmission)) > Real(scene.adc_bailout)) {
                State through = path;
                if (scene.has_fading && interiors.contains(surface.primitive))
                    through.throughput *=
                        attenuation(interior_of(scene, surface.primitive), distance, scene.limits.least_fade);
                InteriorList behind;
                behind.copy_from(interiors);
                if (!transmit(through, behind, transmission, surface, hit)) {
                    path = through; // all is reflected; the finish's own reflection is left out
                    return true;
                }
                interiors.overflow |= behind.overflow;
                if (!reflects) {
                    path = through;
                    interiors.copy_from(behind);
                    return true;
                }
                pending.push(through, behind);
            }
        }
        return reflects && reflect(path, surface, layers);
    }

    /// Leads a path through a surface, or back where Snell's law has no solution (then false).
    HD bool transmit(State& path, InteriorList& behind, const Vec3<Real>& transmission, const Surface<Path>& surface,
                     const Hit<Real>& hit) const {
        const Vec3<Path> direction = path.ray.ray.direction;
        const Path ratio = crossing_ior_ratio<Path>(scene, interiors, surface.primitive);
        path.weight *= larger(magnitude(transmission.x), larger(magnitude(transmission.y), magnitude(transmission.z)));
        behind.toggle(surface.primitive);
        if (magnitude(ratio - Path(1)) < Path(1e-10)) {
            path.throughput *= transmission;
            path.passed = hit; // the same ray, so that surfaces on top of each other are passed once each
            return true;
        }
        Vec3<Path> bent = mirrored(direction, surface.normal);
        const bool bends = refracted(direction, surface.normal, ratio, bent);
        path.ray = leave(shapes_of<Path>(scene), surface, bent, surface.from_inside != bends);
        path.passed = {};
        if (!bends)
            path.hidden = material_no_reflection;
        ++path.level;
        if (bends)
            path.throughput *= transmission;
        return bends;
    }

    /// Leads a path along the mirrored ray. Of several layers that reflect, all but one leave a path pending.
    HD bool reflect(State& path, const Surface<Path>& surface, const LayerStack<Real, plain>& layers) {
        const Vec3<Path> direction = mirrored(path.ray.ray.direction, surface.normal);
        const Vec3<Real> throughput = path.throughput;
        const Real weight = path.weight;
        path.ray = leave(shapes_of<Path>(scene), surface, direction, surface.from_inside);
        path.passed = {};
        path.hidden = material_no_reflection;
        ++path.level;
        bool goes_on = false;
        layers.for_each([&](const Finish& finish, const LayerColor<Real>& color, const Vec3<Real>& above) {
            const Reflection<Real> reflection = layers.reflection(finish, color);
            if (reflection.color == Vec3<Real>(Real(0)))
                return;
            if constexpr (transparent)
                if (goes_on)
                    pending.push(path, interiors);
            path.throughput = throughput * reflection.color;
            path.weight = weight * smaller(magnitude(grey(above)), Real(1)) * reflection.weight;
            path.exponent = Real(1) / Real(finish.reflection_exponent);
            goes_on = true;
        });
        if constexpr (transparent)
            if (goes_on)
                begin(path);
        return goes_on;
    }

    /// A path whose light counts with an exponent gets a sum of its own; a mark leads back to the sum before.
    HD void begin(State& path) {
        if (path.exponent == 1)
            return;
        pending.push_mark(sum, path.throughput, path.exponent);
        sum = Vec3<Real>(Real(0));
        path.throughput = Vec3<Real>(Real(1));
        path.exponent = Real(1);
    }

    /// Takes up a path that waits; false when there is none left.
    HD bool resume(State& path) {
        if constexpr (transparent) {
            while (pending.depth > 0) {
                path = pending.pop(interiors);
                if (path.level != PendingView<Real, Path>::mark_level) {
                    begin(path);
                    return true;
                }
                for (int c = 0; c < 3; ++c)
                    sum[c] = Real(path.ray.ray.origin[c]) +
                             path.throughput[c] * power(larger(sum[c], Real(0)), path.exponent);
            }
        }
        return false;
    }
};

/// One call per pixel of a wave: traces its samples and stores their sum.
template <class Real, Features features, RoundShapes shapes = RoundShapes::all, Ways ways = Ways::any>
struct TracePixels {
    SceneView<Real> scene;
    FilmView film;
    PendingView<Real, PathPrecision<Real, features>> pending; ///< for a wave's number of threads
    uint64_t first = 0;                                       ///< of the wave, in tiled order

    HD void operator()(uint32_t index) const {
        const PixelPosition pixel = tiled_pixel(first + index, film.width);
        if (pixel.x >= film.width || pixel.y >= film.height)
            return;
        const uint64_t place = uint64_t(pixel.y) * film.width + pixel.x;
        if (!film.marks.empty()) {
            if (film.marks[place] != sample_wanted)
                return;
            film.marks[place] = sample_known;
        }
        Tracer<Real, features, shapes, ways> tracer{scene, pending};
        tracer.pending.thread = index;
        const auto camera = camera_in<PathPrecision<Real, features>>(scene.camera);
        const PixelPosition whole = film.in_whole(pixel);
        Vec3<Real> total(Real(0));
        for (uint32_t sample = 0; sample < film.samples; ++sample) {
            tracer.noise.state = (whole.y * film.width + whole.x) * film.samples + sample;
            total += tracer.light_along(pixel_ray(camera, film, whole, sample));
        }
        film.pixels[place] = glm::vec3(total);
    }
};

} // namespace proxima
