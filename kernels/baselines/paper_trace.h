// SPDX-License-Identifier: Apache-2.0
// A baseline for experiments: rays through the grid of paper_grid.h, with or without the distances of paper_cloud.h.
// Hits and shadows are those of kernels/first_hit.h, which shades them, so that the pictures have the same bits.
#pragma once
#include "kernels/baselines/paper_grid.h"
#include "kernels/first_hit.h"

namespace proxima::baselines {

/// Shows a visitor every primitive that the ray may hit, in the order of the voxels on its way.
template <class Visitor>
HD void visit_paper_grid(const SceneView<float>& scene, const PaperGridView& paper, const BasedRay<float>& ray,
                         Visitor& visitor) {
    BasedRay<float> beside = ray;
    beside.meets_bounds = false;
    visit_all<RoundShapes::spheres>(scene, beside, visitor);
    if (!ray.meets_bounds)
        return;
    const GridView<float>& grid = paper.grid;
    const bool by_length = grid.cloud.metric == Metric::city_block;
    GridWalk<float> place(grid, ray.ray, 0.0f);
    bool inside = true;
    do {
        const uint32_t voxel = grid.index(place.cell.x, place.cell.y, place.cell.z);
        if (paper.is_filled(voxel)) {
            const uint32_t* list = paper.list(voxel);
            for (uint32_t k = 0; k < paper.capacity && list[k] != PaperGridView::no_sphere; ++k)
                if (visitor.meet_sphere(list[k]))
                    return;
        }
        const int32_t distance = grid.cloud.in_use() ? grid.cloud.distances[voxel] : 0;
        inside = distance > 0 && by_length ? place.leap_by_length(grid, distance)
                                           : place.leave_block(grid, 0, larger(distance, 1));
    } while (inside && !visitor.is_done(place.now));
}

/// Pixel -> its light, added to the film.
struct TracePaperPixels {
    FirstHitPass<float> pass;
    PaperGridView paper;

    HD void operator()(uint32_t index) const {
        const PixelPosition pixel = pass.pixel(index);
        const uint64_t place = pass.place_of(pixel);
        if (place == pass.nowhere)
            return;
        const SceneView<float>& scene = pass.scene;
        const SourcedRay<float> ray = pass.camera_ray(pixel);
        const BasedRay<float> based = rebase(ray, scene.geometry.bounds);
        NearestHit<float> visitor({scene, based, scene.limits.nearest - based.offset}, 0,
                                  scene.limits.farthest - based.offset);
        visit_paper_grid(scene, paper, based, visitor);
        const bool hits = visitor.best().primitive != no_primitive;
        Surface<float> surface;
        if (hits)
            surface = surface_at(scene, ray, based, visitor.best());
        pass.add(place, pass.light_of(ray.ray.direction, hits ? &surface : nullptr,
                                      [&](uint32_t, const PlainLight<float>& seen) {
                                          return is_shadowed_from(surface, seen.ray);
                                      }));
    }

private:
    HD bool is_shadowed_from(const Surface<float>& surface, const LightRay<float>& light) const {
        const SceneView<float>& scene = pass.scene;
        const SourcedRay<float> ray = leave(shapes_of<float>(scene), surface, light.direction, surface.from_inside);
        const BasedRay<float> based = rebase(ray, scene.geometry.bounds);
        const float margin = scene.limits.shadow_margin;
        AnyHit<float> visitor({scene, based, margin - based.offset}, light.distance - margin - based.offset);
        visit_paper_grid(scene, paper, based, visitor);
        return visitor.found();
    }
};

} // namespace proxima::baselines
