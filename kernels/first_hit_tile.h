// SPDX-License-Identifier: Apache-2.0
// What first_hit.h does, for processors with few cores and vector instructions: a tile of pixels,
// whose rays go through the grid as a packet, and their shadow rays as one packet for each light. The same pictures,
// bit for bit.
#pragma once
#include "kernels/first_hit.h"
#include "kernels/packet_search.h"

namespace proxima {

/// Tile -> the light of its samples, added to the film. The `first` of `pass` is a whole number of tiles.
template <class Real> struct TraceFirstHitTile {
    static constexpr uint32_t lanes = RayPacket<Real>::lanes;

    FirstHitPass<Real> pass;

    HD void operator()(uint32_t tile) const {
        Pixels pixels;
        find(tile * lanes, pixels);
        for (uint32_t i = 0; i < pass.scene.lights.size(); ++i)
            if (!pass.scene.lights[i].shadowless)
                darken(i, pixels);
        for (uint32_t lane = 0; lane < lanes; ++lane)
            if (pixels.places[lane] != pass.nowhere)
                pass.add(pixels.places[lane],
                         pass.light_of(pixels.rays.ray(lane).direction,
                                       pixels.hits(lane) ? &pixels.surfaces[lane] : nullptr,
                                       [&](uint32_t light, const auto&) { return pixels.shadows[lane] >> light & 1; }));
    }

private:
    struct Pixels {
        RayPacket<Real> rays;   ///< the camera's
        uint64_t places[lanes]; ///< in the film, or nowhere
        Surface<Real> surfaces[lanes];
        uint32_t shadows[lanes];

        HD bool hits(uint32_t lane) const { return rays.primitive[lane] != no_primitive; }
    };

    /// The camera's rays through a tile, outside of the picture too. Copies, since compilers cannot know that the rays
    /// are not where the rest is.
    HD void aim(PixelPosition corner, RayPacket<Real>& rays) const {
        const FilmView film = pass.film;
        const Camera<Real> camera = pass.camera;
        const Box<Real> bounds = pass.scene.geometry.bounds;
        const HitLimits<Real> limits = pass.scene.limits;
        const SampleOffset<Real> offset = sample_offset<Real>(film, pass.sample);
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const PixelPosition pixel{corner.x + lane % tile_width, corner.y + lane / tile_width};
            const Ray<Real> ray = pixel_ray(camera, film, film.in_whole(pixel), offset);
            rays.set(lane, rebase(SourcedRay<Real>{ray, {}}, bounds), limits.nearest, limits.farthest);
        }
    }

    /// What the camera's rays meet first.
    HD void find(uint32_t first, Pixels& pixels) const {
        const SceneView<Real>& scene = pass.scene;
        const HitLimits<Real>& limits = scene.limits;
        RayPacket<Real>& rays = pixels.rays;
        aim(pass.pixel(first), rays);
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            pixels.places[lane] = pass.place_of(pass.pixel(first + lane));
            pixels.shadows[lane] = 0;
            if (pixels.places[lane] == pass.nowhere)
                rays.set_idle(lane);
        }
        search_packet<Sought::nearest>(scene, rays, [&](uint32_t lane) {
            const Hit<Real> hit =
                find_nearest<RoundShapes::spheres>(scene, rays.based(lane), {}, limits.nearest, limits.farthest, 0);
            rays.reach[lane] = hit.t;
            rays.primitive[lane] = hit.primitive;
        });
        for (uint32_t lane = 0; lane < lanes; ++lane)
            if (pixels.hits(lane)) {
                const BasedRay<Real> ray = rays.based(lane);
                pixels.surfaces[lane] =
                    surface_at(scene, SourcedRay<Real>{ray.ray, {}}, ray, {rays.reach[lane], rays.primitive[lane]});
            }
    }

    /// Finds out on which of the surfaces a light does not shine.
    HD void darken(uint32_t index, Pixels& pixels) const {
        const SceneView<Real>& scene = pass.scene;
        const Real margin = scene.limits.shadow_margin;
        RayPacket<Real> rays;
        Real distances[lanes];
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            rays.set_idle(lane);
            if (!pixels.hits(lane))
                continue;
            const Surface<Real>& surface = pixels.surfaces[lane];
            const PlainLight<Real> seen(scene, scene.lights[index], surface);
            if (!seen.shines())
                continue;
            distances[lane] = seen.ray.distance - margin;
            const BasedRay<Real> ray = rebase(
                leave(shapes_of<Real>(scene), surface, seen.ray.direction, surface.from_inside), scene.geometry.bounds);
            if (Search<Real>{scene, ray, margin - ray.offset}.is_shadowed_by_source(distances[lane] - ray.offset))
                pixels.shadows[lane] |= 1u << index;
            else
                rays.set(lane, ray, margin, distances[lane]);
        }
        search_packet<Sought::any>(scene, rays, [&](uint32_t lane) {
            if (find_any<RoundShapes::spheres>(scene, rays.based(lane), margin, distances[lane]))
                rays.primitive[lane] = 0;
        });
        for (uint32_t lane = 0; lane < lanes; ++lane)
            if (rays.primitive[lane] != no_primitive)
                pixels.shadows[lane] |= 1u << index;
    }
};

} // namespace proxima
