// SPDX-License-Identifier: Apache-2.0
// Scenes whose paths all end at their first surface: opaque, without mirrors, and plain (see Features). On a GPU
// registers are what limits the rays in flight, so that a kernel knows the one way that rays go through the frame's
// grid.
#pragma once
#include "kernels/film.h"
#include "kernels/layers.h"
#include "kernels/shadow.h"

namespace proxima {

/// Blocks of threads that share a multiprocessor while rays are on their way; 64 registers a thread. 10 and 12 are
/// slower on an H200, but in full scenes of a million spheres and more: see tests/bench/NOTES.md.
inline constexpr uint32_t most_blocks = 8;

/// A pass over a wave of pixels in tiled order; one sample of each.
template <class Real> struct FirstHitPass {
    static constexpr uint32_t most_lights = 32; ///< bits of a number
    static constexpr uint64_t nowhere = ~uint64_t(0);

    SceneView<Real> scene;
    FilmView film;
    uint64_t first = 0; ///< of the wave
    uint32_t sample = 0;
    Camera<Real> camera; ///< the scene's

    FirstHitPass(const SceneView<Real>& scene, const FilmView& film)
        : scene(scene), film(film), camera(camera_in<Real>(scene.camera)) {}

    HD PixelPosition pixel(uint32_t index) const { return tiled_pixel(first + index, film.width); }
    /// Where a pixel lies in the film; `nowhere` where nothing is to be done.
    HD uint64_t place_of(const PixelPosition& pixel) const {
        if (pixel.x >= film.width || pixel.y >= film.height)
            return nowhere;
        const uint64_t place = uint64_t(pixel.y) * film.width + pixel.x;
        return film.marks.empty() || film.marks[place] == sample_wanted ? place : nowhere;
    }
    HD SourcedRay<Real> camera_ray(const PixelPosition& pixel) const {
        return {pixel_ray(camera, film, film.in_whole(pixel), sample), {}};
    }
    /// The light that comes back along a ray's direction. `surface`: that it met first, or null;
    /// is_shadowed(number of a light, PlainLight) is asked for lights that would shine there.
    template <class IsShadowed>
    HD Vec3<Real> light_of(const Vec3<Real>& direction, const Surface<Real>* surface,
                           const IsShadowed& is_shadowed) const;
    /// Adds a sample's light to a pixel of the film.
    HD void add(uint64_t place, const Vec3<Real>& light) const {
        film.pixels[place] = sample == 0 ? glm::vec3(light) : film.pixels[place] + glm::vec3(light);
        if (!film.marks.empty() && sample + 1 == film.samples)
            film.marks[place] = sample_known;
    }
};

/// A point light as a point of a surface sees it.
template <class Real> struct PlainLight {
    LightRay<Real> ray;
    Vec3<Real> arriving{Real(0)}; ///< if nothing stands in the way; 0 behind the surface

    HD PlainLight(const SceneView<Real>& scene, const Light<Real>& light, const Surface<Real>& surface)
        : ray(straight_light_ray(surface.point, light.position)) {
        if (glm::dot(surface.normal, ray.direction) >= Real(1e-10))
            arriving = Vec3<Real>(light.color) * light_fade(light, ray.distance, scene.limits.least_fade);
    }
    HD bool shines() const { return arriving != Vec3<Real>(Real(0)); }
};

template <class Real>
template <class IsShadowed>
HD Vec3<Real> FirstHitPass<Real>::light_of(const Vec3<Real>& direction, const Surface<Real>* surface,
                                           const IsShadowed& is_shadowed) const {
    if (Real(1) < Real(scene.adc_bailout))
        return Vec3<Real>(Real(0));
    if (!surface)
        return Vec3<Real>(scene.background);
    const LayerStack<Real, true> layers(scene, *surface, -glm::dot(direction, surface->normal), Real(1));
    Vec3<Real> sum = layers.glow();
    for (uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light<Real>& light = scene.lights[i];
        const PlainLight<Real> seen(scene, light, *surface);
        if (!seen.shines())
            continue;
        // First what it sends back, so that less needs to be kept while a shadow is looked for.
        const Vec3<Real> reflected =
            layers.reflected({surface->normal, seen.ray.direction, direction}, seen.arriving, !light.shadowless);
        if (light.shadowless || !is_shadowed(i, seen))
            sum += reflected;
    }
    return sum;
}

/// Pixel -> its sample's light, added to the film. `ways`: those through the scene's grid.
template <class Real, RoundShapes shapes, Ways ways> struct TraceFirstHits {
    static constexpr uint32_t blocks_together = sizeof(Real) == 4 ? most_blocks : 1;

    FirstHitPass<Real> pass;

    HD void operator()(uint32_t index) const {
        const PixelPosition pixel = pass.pixel(index);
        const uint64_t place = pass.place_of(pixel);
        if (place == pass.nowhere)
            return;
        const SceneView<Real>& scene = pass.scene;
        const HitLimits<Real>& limits = scene.limits;
        const SourcedRay<Real> ray = pass.camera_ray(pixel);
        const BasedRay<Real> based = rebase(ray, scene.geometry.bounds);
        const Hit<Real> hit = find_nearest<shapes, ways>(scene, based, {}, limits.nearest, limits.farthest, 0);
        Surface<Real> surface;
        if (hit.primitive != no_primitive)
            surface = surface_at(scene, ray, based, hit);
        pass.add(place, pass.light_of(ray.ray.direction, hit.primitive != no_primitive ? &surface : nullptr,
                                      [&](uint32_t, const PlainLight<Real>& seen) {
                                          return is_shadowed<shapes, ways>(scene, surface, seen.ray.direction,
                                                                           seen.ray.distance);
                                      }));
    }
};

} // namespace proxima
