// SPDX-License-Identifier: Apache-2.0
// A ray in, the nearest hit or the knowledge of any hit out; and the primitives around a point.
#pragma once
#include "kernels/walk.h"

namespace proxima {

/// Shows a visitor every primitive that the ray may hit. `shapes`: those that a grid holds.
/// `ways`: those through the grid that it may need.
template <RoundShapes shapes, Ways ways = Ways::any, class Real, class Visitor>
HD void visit_all(const SceneView<Real>& scene, const BasedRay<Real>& ray, Visitor& visitor) {
    const GeometryView<Real>& geometry = scene.geometry;
    const uint32_t round = geometry.round_count();
    for (uint32_t i = 0; i < geometry.planes.size(); ++i)
        visitor.meet_plane(round + i);
    for (const uint32_t id : geometry.large)
        visitor.template meet_large<shapes>(id);
    if (!ray.meets_bounds)
        return;
    if (ways != Ways::any || scene.grid.in_use()) {
        walk<shapes, ways>(scene.grid, ray.ray, visitor);
        if (ways == Ways::any && scene.outskirts.in_use() && !visitor.is_done(-infinity<Real>))
            walk<shapes, Ways::steps>(scene.outskirts, ray.ray, visitor);
        return;
    }
    for (uint32_t id = 0; id < round && !visitor.is_done(-infinity<Real>); ++id)
        if (!scene.meets_exactly(id)) // then it is one of the large ones
            visitor.meet(id);
}

/// The nearest hit between `nearest` and `farthest` of the ray's origin. A ray that has `passed` a hit already goes on
/// from there: the next hit in order, at least `nearest` further on.
template <RoundShapes shapes = RoundShapes::all, Ways ways = Ways::any, class Real>
HD Hit<Real> find_nearest(const SceneView<Real>& scene, const BasedRay<Real>& ray, const Hit<Real>& passed,
                          Real nearest, Real farthest, uint32_t hidden) {
    const bool goes_on = passed.primitive != no_primitive;
    const Search<Real> search{scene, ray, goes_on ? passed.t + nearest : nearest - ray.offset,
                              goes_on && nearest == 0 ? passed.primitive : no_primitive};
    NearestHit<Real> visitor(search, hidden, farthest - ray.offset);
    visit_all<shapes, ways>(scene, ray, visitor);
    return visitor.best();
}

template <RoundShapes shapes = RoundShapes::all, Ways ways = Ways::any, class Real>
HD bool find_any(const SceneView<Real>& scene, const BasedRay<Real>& ray, Real nearest, Real farthest) {
    AnyHit<Real> visitor({scene, ray, nearest - ray.offset}, farthest - ray.offset);
    visit_all<shapes, ways>(scene, ray, visitor);
    return visitor.found();
}

/// Calls `visit(id)` for the primitives in the list of a point's voxel.
template <class Real, class Visit>
HD void for_each_listed(const GridView<Real>& grid, const Vec3<Real>& point, const Visit& visit) {
    const Vec3<int32_t> cell = grid.cell_at(point);
    if (grid.cloud.in_use() && grid.cloud.distances[grid.cloud.brick(cell.x, cell.y, cell.z)] != 0)
        return;
    for (uint32_t link = grid.heads[grid.slot(cell.x, cell.y, cell.z)]; link != no_link; link = grid.links[link].next)
        visit(grid.links[link].primitive);
}

/// Calls `visit(id)` for the bounded primitives that may hold a point, the large ones and the planes, each once.
template <class Real, class Visit>
HD void for_each_around(const SceneView<Real>& scene, const Vec3<Real>& point, const Visit& visit) {
    const GeometryView<Real>& geometry = scene.geometry;
    const uint32_t round = geometry.round_count();
    for (uint32_t i = 0; i < geometry.planes.size(); ++i)
        visit(round + i);
    for (const uint32_t id : geometry.large)
        visit(id);
    for (int i = 0; i < 3; ++i)
        if (point[i] < geometry.bounds.lower[i] || point[i] > geometry.bounds.upper[i])
            return;
    if (!scene.grid.in_use()) {
        for (uint32_t id = 0; id < round; ++id)
            if (!(geometry.radius(id) > geometry.large_radius))
                visit(id);
        return;
    }
    if (scene.grid.part == GridPart::all || contains(scene.grid.box(), point))
        for_each_listed(scene.grid, point, visit);
    if (scene.outskirts.in_use())
        for_each_listed(scene.outskirts, point, visit);
}

} // namespace proxima
