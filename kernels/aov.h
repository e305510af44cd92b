// SPDX-License-Identifier: Apache-2.0
// The layers beside a picture: the ray through a pixel's middle is traced once more, to its first surface, and what is
// known there is kept. A pass of its own, so that pictures without layers cost nothing for it.
#pragma once
#include "kernels/aov_sample.h"
#include "kernels/film.h"
#include "kernels/surface.h"

namespace proxima {

/// Pixel -> its layers. `Path` is the precision in which the picture's paths are followed, so that both see the same.
template <class Real, class Path> struct TraceAovs {
    SceneView<Real> scene;
    FilmView film;                   ///< its samples begin in the middle of a pixel
    std::span<const uint32_t> order; ///< of each sphere, its place in the scene; empty where they are the same
    std::span<AovSample> aovs;       ///< of the film's pixels

    HD void operator()(uint32_t index) const {
        const PixelPosition pixel = tiled_pixel(index, film.width);
        if (pixel.x >= film.width || pixel.y >= film.height)
            return;
        const Ray<Path> ray = pixel_ray(camera_in<Path>(scene.camera), film, film.in_whole(pixel), 0);
        aovs[uint64_t(pixel.y) * film.width + pixel.x] = sample_along({ray, {}});
    }

private:
    HD AovSample sample_along(const SourcedRay<Path>& ray) const {
        const BasedRay<Real> based = rebase(ray, scene.geometry.bounds);
        const Search<Real> search{scene, based, scene.limits.nearest - based.offset};
        NearestHit<Real> visitor(search, scene.has_hidden ? uint32_t(material_no_image) : 0u,
                                 scene.limits.farthest - based.offset);
        AovSample sample;
        sample.steps = visit_counting(based, visitor);
        const Hit<Real>& hit = visitor.best();
        if (hit.primitive == no_primitive)
            return sample;
        const Surface<Path> surface = surface_at(scene, ray, based, hit);
        const Camera<double>& camera = scene.camera;
        const Vec3<double> view = glm::normalize(camera.direction);
        sample.depth = float(glm::dot(Vec3<double>(surface.point) - camera.location, view));
        sample.normal = glm::vec3(surface.normal);
        sample.id = 1 + (hit.primitive < order.size() ? order[hit.primitive] : hit.primitive);
        return sample;
    }

    /// Shows the visitor what visit_all does, and counts the way through the grid.
    HD uint32_t visit_counting(const BasedRay<Real>& based, NearestHit<Real>& visitor) const {
        const bool walks = based.meets_bounds && scene.grid.in_use();
        BasedRay<Real> beside = based;
        beside.meets_bounds = based.meets_bounds && !walks;
        visit_all<RoundShapes::all>(scene, beside, visitor);
        uint32_t steps = walks ? walk<RoundShapes::all>(scene.grid, based.ray, visitor) : 0;
        if (walks && scene.outskirts.in_use())
            steps += walk<RoundShapes::all, Ways::steps>(scene.outskirts, based.ray, visitor);
        return steps;
    }
};

} // namespace proxima
