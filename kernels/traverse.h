// SPDX-License-Identifier: Apache-2.0
// A ray in, the nearest hit or the knowledge of any hit out; and the primitives around a point. A ray is moved once to
// where it enters the frame's bounds, and every primitive is met from there: the distances, and so the picture, do not
// depend on the grid's resolution or on whether there is a grid at all. Ties go to the smaller id.
#pragma once
#include "kernels/scene_view.h"

namespace proxima {

/// The primitive that a ray starts on. A ray going outward cannot meet it again; one going inward meets it at `exit`,
/// which is exact where an intersection test would have to tell 0 from almost 0.
template <class Real> struct RaySource {
    uint32_t primitive = no_primitive;
    Real exit = Real(0); ///< not positive: never
};

template <class Real> struct SourcedRay {
    Ray<Real> ray;
    RaySource<Real> source;
};

/// A hit, at `t` from the based origin. As the place that a ray has passed: hits come in the order of (t, primitive).
template <class Real> struct Hit {
    Real t = infinity<Real>;
    uint32_t primitive = no_primitive;
};

/// A ray moved `offset` forward to the frame's bounds.
template <class Real> struct BasedRay {
    Ray<Real> ray;
    RaySource<Real> source;
    Real offset = Real(0);
    bool meets_bounds = false;
};

/// The way to the bounds is measured in the precision of the path; what is met from there needs only Real.
template <class Real, class Path> HD BasedRay<Real> rebase(const SourcedRay<Path>& from, const Box<Real>& bounds) {
    const Span<Path> span = intersect(Box<Path>{Vec3<Path>(bounds.lower), Vec3<Path>(bounds.upper)}, from.ray);
    const bool meets_bounds = span.enter <= span.exit;
    const Path offset = meets_bounds && span.enter > 0 ? span.enter : Path(0);
    BasedRay<Real> based{{Vec3<Real>(from.ray.origin), Vec3<Real>(from.ray.direction)},
                         {from.source.primitive, Real(from.source.exit - offset)},
                         Real(offset),
                         meets_bounds};
    if (offset > 0) {
        const Vec3<Path> entry = from.ray.origin + offset * from.ray.direction;
        for (int i = 0; i < 3; ++i)
            based.ray.origin[i] = clamped(Real(entry[i]), bounds.lower[i], bounds.upper[i]);
    }
    return based;
}

/// Distance from the based origin to a primitive beyond `nearest`, or infinity.
template <class Real>
HD_INNER Real distance_to(const SceneView<Real>& scene, const BasedRay<Real>& ray, uint32_t id, Real nearest) {
    if (id == ray.source.primitive)
        return ray.source.exit > larger(nearest, -ray.offset) ? ray.source.exit : infinity<Real>;
    const GeometryView<Real>& geometry = scene.geometry;
    if (geometry.is_sphere(id))
        return intersect(geometry.spheres[id], ray.ray, nearest, scene.limits.min_half_chord2);
    if (geometry.is_plane(id))
        return intersect(geometry.plane(id), ray.ray, nearest, scene.limits.min_cosine);
    return intersect(geometry.ellipsoid(id), ray.ray, nearest, scene.limits.min_half_chord2);
}

/// Keeps the nearest of the hits that it is shown.
template <class Real> struct NearestHit {
    const SceneView<Real>& scene;
    const BasedRay<Real>& ray;
    Real nearest;
    uint32_t passed;        ///< of the primitives with a greater id, a hit at `nearest` itself counts too
    bool casts_shadow_only; ///< leaves out materials without shadow
    Hit<Real> best;

    HD_INNER void meet(uint32_t id) {
        const Real beyond = id > passed ? just_below(nearest) : nearest;
        const Real t = distance_to(scene, ray, id, beyond);
        const bool ties = t == best.t && best.primitive != no_primitive && id < best.primitive;
        if (!(t < best.t) && !ties)
            return;
        if (casts_shadow_only && (scene.surfaces.materials[scene.geometry.material(id)].flags & material_no_shadow))
            return;
        best = {t, id};
    }
    HD_INNER bool is_done(Real reached) const { return best.t <= reached; }
};

/// Stops at the first hit of a primitive that casts a shadow.
template <class Real> struct AnyHit {
    const SceneView<Real>& scene;
    const BasedRay<Real>& ray;
    Real nearest;
    Real farthest;
    bool found = false;

    HD_INNER void meet(uint32_t id) {
        if (!found && distance_to(scene, ray, id, nearest) < farthest)
            found = !(scene.surfaces.materials[scene.geometry.material(id)].flags & material_no_shadow);
    }
    HD_INNER bool is_done(Real reached) const { return found || farthest <= reached; }
};

/// Shows a visitor the lists of the voxels along a ray, in order, until it is done. Voxel planes are recomputed from
/// integers, never accumulated, so that the error does not grow with the number of steps.
template <class Real, class Visitor> HD void walk(const GridView<Real>& grid, const Ray<Real>& ray, Visitor& visitor) {
    const Vec3<Real> origin = (ray.origin - grid.lower) * grid.inverse_voxel; // in voxels
    int32_t cell[3], step[3], last[3];
    const int32_t stride[3] = {1, grid.size.x, grid.size.x * grid.size.y};
    Real inverse[3], next[3]; // distance to the plane through which the ray leaves the voxel along an axis
    for (int i = 0; i < 3; ++i) {
        const Real speed = ray.direction[i] * grid.inverse_voxel[i];
        cell[i] = int32_t(clamped(origin[i], Real(0), Real(grid.size[i] - 1)));
        step[i] = speed < 0 ? -1 : 1;
        last[i] = speed < 0 ? 0 : grid.size[i] - 1;
        inverse[i] = Real(1) / speed;
        next[i] = speed == 0 ? infinity<Real> : (Real(cell[i] + (step[i] > 0)) - origin[i]) * inverse[i];
    }
    uint32_t voxel = grid.index(cell[0], cell[1], cell[2]);
    const auto advance = [&](int i) {
        if (cell[i] == last[i])
            return false;
        cell[i] += step[i];
        voxel += uint32_t(step[i] * stride[i]);
        next[i] = (Real(cell[i] + (step[i] > 0)) - origin[i]) * inverse[i];
        return true;
    };
    for (bool inside = true; inside;) {
        const uint32_t end = grid.starts[voxel + 1];
        for (uint32_t r = grid.starts[voxel]; r < end; ++r)
            visitor.meet(grid.references[r]);
        const Real leave = smaller(smaller(next[0], next[1]), next[2]);
        if (visitor.is_done(leave))
            return;
        inside = leave == next[0] ? advance(0) : leave == next[1] ? advance(1) : advance(2);
    }
}

/// Shows a visitor every primitive that the ray may hit.
template <class Real, class Visitor>
HD void visit_all(const SceneView<Real>& scene, const BasedRay<Real>& ray, Visitor& visitor) {
    const GeometryView<Real>& geometry = scene.geometry;
    const uint32_t round = geometry.round_count();
    for (uint32_t i = 0; i < geometry.planes.size(); ++i)
        visitor.meet(round + i);
    for (const uint32_t id : geometry.large)
        visitor.meet(id);
    if (!ray.meets_bounds)
        return;
    if (scene.grid.in_use()) {
        walk(scene.grid, ray.ray, visitor);
        return;
    }
    for (uint32_t id = 0; id < round && !visitor.is_done(-infinity<Real>); ++id)
        visitor.meet(id);
}

/// The nearest hit between `nearest` and `farthest` of the ray's origin. A ray that has `passed` a hit already goes on
/// from there: the next hit in order, at least `nearest` further on.
template <class Real>
HD Hit<Real> find_nearest(const SceneView<Real>& scene, const BasedRay<Real>& ray, const Hit<Real>& passed,
                          Real nearest, Real farthest, bool casts_shadow_only) {
    const bool goes_on = passed.primitive != no_primitive;
    NearestHit<Real> visitor{scene,
                             ray,
                             goes_on ? passed.t + nearest : nearest - ray.offset,
                             goes_on && nearest == 0 ? passed.primitive : no_primitive,
                             casts_shadow_only,
                             {farthest - ray.offset, no_primitive}};
    visit_all(scene, ray, visitor);
    return visitor.best;
}

template <class Real>
HD bool find_any(const SceneView<Real>& scene, const BasedRay<Real>& ray, Real nearest, Real farthest) {
    AnyHit<Real> visitor{scene, ray, nearest - ray.offset, farthest - ray.offset};
    visit_all(scene, ray, visitor);
    return visitor.found;
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
    const uint32_t voxel = scene.grid.index_at(point);
    for (uint32_t r = scene.grid.starts[voxel]; r < scene.grid.starts[voxel + 1]; ++r)
        visit(scene.grid.references[r]);
}

} // namespace proxima
