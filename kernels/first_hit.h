// SPDX-License-Identifier: Apache-2.0
// Scenes whose paths all end at their first surface: opaque, without mirrors, and plain (see Features). On a GPU
// registers are what limits the rays in flight, so that a kernel knows the one way that rays go through the frame's
// grid.
#pragma once
#include "kernels/film.h"
#include "kernels/layers.h"
#include "kernels/shadow.h"

namespace proxima {

/// Blocks of threads that share a multiprocessor while rays are on their way; 40 registers a thread. 8, 10 and 16 are
/// slower or no faster on an H200: see tests/bench/NOTES.md.
inline constexpr uint32_t most_blocks = 12;

/// A pass over a wave of pixels in tiled order; one sample of each.
template <class Real> struct FirstHitPass {
    static constexpr uint32_t most_lights = 32; ///< bits of a number
    static constexpr uint64_t nowhere = ~uint64_t(0);

    SceneView<Real> scene;
    FilmView film;
    uint64_t first = 0; ///< of the wave
    uint32_t sample = 0;

    /// Where pixel `index` of the wave lies in the film; `nowhere` where nothing is to be done.
    HD uint64_t place_of(uint32_t index) const {
        const PixelPosition pixel = tiled_pixel(first + index, film.width);
        if (pixel.x >= film.width || pixel.y >= film.height)
            return nowhere;
        const uint64_t place = uint64_t(pixel.y) * film.width + pixel.x;
        return film.marks.empty() || film.marks[place] == sample_wanted ? place : nowhere;
    }
    /// Calls visit(place in the film, camera ray) unless nothing is to be done.
    template <class Visit> HD void at(uint32_t index, const Visit& visit) const {
        const uint64_t place = place_of(index);
        if (place != nowhere)
            visit(place, SourcedRay<Real>{pixel_ray(camera_in<Real>(scene.camera), film,
                                                    film.in_whole(tiled_pixel(first + index, film.width)), sample),
                                          {}});
    }
    /// The light that comes back along a ray's direction. `surface`: that it met first, or null; `shadows`: bit i says
    /// that light i does not shine there.
    HD Vec3<Real> light_of(const Vec3<Real>& direction, const Surface<Real>* surface, uint32_t shadows) const;
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
HD Vec3<Real> FirstHitPass<Real>::light_of(const Vec3<Real>& direction, const Surface<Real>* surface,
                                           uint32_t shadows) const {
    if (Real(1) < Real(scene.adc_bailout))
        return Vec3<Real>(Real(0));
    if (!surface)
        return Vec3<Real>(scene.background);
    const LayerStack<Real, true> layers{scene, *surface, -glm::dot(direction, surface->normal), Real(1)};
    Vec3<Real> sum = layers.glow();
    for (uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light<Real>& light = scene.lights[i];
        const PlainLight<Real> seen(scene, light, *surface);
        if (seen.shines() && !(shadows >> i & 1))
            sum += layers.reflected({surface->normal, seen.ray.direction, direction}, seen.arriving, !light.shadowless);
    }
    return sum;
}

/// Pixel -> its sample's light, added to the film. `ways`: those through the scene's grid.
template <class Real, RoundShapes shapes, Ways ways> struct TraceFirstHits {
    static constexpr uint32_t blocks_together = sizeof(Real) == 4 ? most_blocks : 1;

    FirstHitPass<Real> pass;

    HD void operator()(uint32_t index) const {
        pass.at(index, [&](uint64_t place, const SourcedRay<Real>& ray) {
            const SceneView<Real>& scene = pass.scene;
            const HitLimits<Real>& limits = scene.limits;
            const BasedRay<Real> based = rebase(ray, scene.geometry.bounds);
            const Hit<Real> hit = find_nearest<shapes, ways>(scene, based, {}, limits.nearest, limits.farthest, 0);
            if (hit.primitive == no_primitive)
                return pass.add(place, pass.light_of(ray.ray.direction, nullptr, 0));
            const Surface<Real> surface = surface_at(scene, ray, based, hit);
            pass.add(place, pass.light_of(ray.ray.direction, &surface, shadows_at(surface)));
        });
    }

private:
    /// Bit i says that light i does not shine there.
    HD uint32_t shadows_at(const Surface<Real>& surface) const {
        const SceneView<Real>& scene = pass.scene;
        uint32_t shadows = 0;
        for (uint32_t i = 0; i < scene.lights.size(); ++i) {
            const Light<Real>& light = scene.lights[i];
            const PlainLight<Real> seen(scene, light, surface);
            if (seen.shines() && !light.shadowless &&
                is_shadowed<shapes, ways>(scene, surface, seen.ray.direction, seen.ray.distance))
                shadows |= 1u << i;
        }
        return shadows;
    }
};

} // namespace proxima
