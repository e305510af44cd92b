// SPDX-License-Identifier: Apache-2.0
// Scenes whose paths all end at their first surface: opaque, without mirrors, and plain (see Features). Their pixels
// are made in three passes, each of which remembers little while it looks for hits: what a ray meets first, which
// lights shine there, and what the eye sees of that. On a GPU registers are what limits the rays in flight.
#pragma once
#include "kernels/film.h"
#include "kernels/layers.h"
#include "kernels/shadow.h"

namespace proxima {

/// Blocks of threads that share a multiprocessor while rays are on their way; 40 registers each. 10, 12 and 16 are
/// equally fast on an H100: see tests/bench/NOTES.md.
inline constexpr uint32_t most_blocks = 12;

/// A pass over a wave of pixels in tiled order; one sample of each.
template <class Real> struct FirstHitPass {
    static constexpr uint32_t most_lights = 32; ///< bits of a number

    SceneView<Real> scene;
    FilmView film;
    std::span<Hit<Real>> hits;   ///< of the wave
    std::span<uint32_t> shadows; ///< of the wave: bit i says that light i does not shine there
    uint64_t first = 0;          ///< of the wave
    uint32_t sample = 0;

    /// Calls visit(place in the film, camera ray) unless nothing is to be done.
    template <class Visit> HD void at(uint32_t index, const Visit& visit) const {
        const PixelPosition pixel = tiled_pixel(first + index, film.width);
        if (pixel.x >= film.width || pixel.y >= film.height)
            return;
        const uint64_t place = uint64_t(pixel.y) * film.width + pixel.x;
        if (!film.marks.empty() && film.marks[place] != sample_wanted)
            return;
        const SourcedRay<Real> ray{pixel_ray(camera_in<Real>(scene.camera), film, film.in_whole(pixel), sample), {}};
        visit(place, ray);
    }
    HD Surface<Real> surface_of(const SourcedRay<Real>& ray, const Hit<Real>& hit) const {
        return surface_at(scene, ray, rebase(ray, scene.geometry.bounds), hit);
    }
};

/// A point light as a point of a surface sees it.
template <class Real> struct PlainLight {
    LightRay<Real> ray;
    Vec3<Real> arriving{Real(0)}; ///< if nothing stands in the way; 0 behind the surface

    HD PlainLight(const Light<Real>& light, const Surface<Real>& surface)
        : ray(straight_light_ray(surface.point, light.position)) {
        if (glm::dot(surface.normal, ray.direction) >= Real(1e-10))
            arriving = Vec3<Real>(light.color) * light_fade(light, ray.distance);
    }
    HD bool shines() const { return arriving != Vec3<Real>(Real(0)); }
};

/// Pixel -> what its ray meets first.
template <class Real, RoundShapes shapes> struct FindFirstHits {
    static constexpr uint32_t blocks_together = sizeof(Real) == 4 ? most_blocks : 1;

    FirstHitPass<Real> pass;

    HD void operator()(uint32_t index) const {
        pass.at(index, [&](uint64_t, const SourcedRay<Real>& ray) {
            const SceneView<Real>& scene = pass.scene;
            const HitLimits<Real>& limits = scene.limits;
            pass.hits[index] =
                find_nearest<shapes>(scene, rebase(ray, scene.geometry.bounds), {}, limits.nearest, limits.farthest, 0);
        });
    }
};

/// Pixel -> which lights do not shine on what it shows.
template <class Real, RoundShapes shapes> struct FindShadows {
    static constexpr uint32_t blocks_together = sizeof(Real) == 4 ? most_blocks : 1;

    FirstHitPass<Real> pass;

    HD void operator()(uint32_t index) const {
        pass.at(index, [&](uint64_t, const SourcedRay<Real>& ray) {
            const SceneView<Real>& scene = pass.scene;
            const Hit<Real> hit = pass.hits[index];
            if (hit.primitive == no_primitive)
                return;
            const Surface<Real> surface = pass.surface_of(ray, hit);
            uint32_t shadows = 0;
            for (uint32_t i = 0; i < scene.lights.size(); ++i) {
                const Light<Real>& light = scene.lights[i];
                const PlainLight<Real> seen(light, surface);
                if (seen.shines() && !light.shadowless &&
                    is_shadowed<shapes>(scene, surface, seen.ray.direction, seen.ray.distance))
                    shadows |= 1u << i;
            }
            pass.shadows[index] = shadows;
        });
    }
};

/// Pixel -> its sample's light, added to the film.
template <class Real> struct ShadeFirstHits {
    static constexpr uint32_t blocks_together = sizeof(Real) == 4 ? 8 : 1;

    FirstHitPass<Real> pass;

    HD void operator()(uint32_t index) const {
        pass.at(index, [&](uint64_t place, const SourcedRay<Real>& ray) {
            const FilmView& film = pass.film;
            const Hit<Real> hit = pass.hits[index];
            Vec3<Real> light(Real(0));
            if (!(Real(1) < Real(pass.scene.adc_bailout)))
                light = hit.primitive == no_primitive ? Vec3<Real>(pass.scene.background)
                                                      : light_of(ray, pass.surface_of(ray, hit), pass.shadows[index]);
            film.pixels[place] = pass.sample == 0 ? glm::vec3(light) : film.pixels[place] + glm::vec3(light);
            if (!film.marks.empty() && pass.sample + 1 == film.samples)
                film.marks[place] = sample_known;
        });
    }

private:
    HD Vec3<Real> light_of(const SourcedRay<Real>& ray, const Surface<Real>& surface, uint32_t shadows) const {
        const SceneView<Real>& scene = pass.scene;
        const Vec3<Real>& direction = ray.ray.direction;
        const LayerStack<Real, true> layers{scene, surface, -glm::dot(direction, surface.normal), Real(1)};
        Vec3<Real> sum = layers.glow();
        for (uint32_t i = 0; i < scene.lights.size(); ++i) {
            const Light<Real>& light = scene.lights[i];
            const PlainLight<Real> seen(light, surface);
            if (seen.shines() && !(shadows >> i & 1))
                sum +=
                    layers.reflected({surface.normal, seen.ray.direction, direction}, seen.arriving, !light.shadowless);
        }
        return sum;
    }
};

} // namespace proxima
