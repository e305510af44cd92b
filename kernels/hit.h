// SPDX-License-Identifier: Apache-2.0
// A ray and one primitive after the other in, the nearest hit or the knowledge of any hit out. A ray is moved once to
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

/// What a ray looks for: hits beyond `nearest` of the based origin.
template <class Real> struct Search {
    const SceneView<Real>& scene;
    const BasedRay<Real>& ray;
    Real nearest;
    uint32_t passed = no_primitive; ///< of the primitives with a greater id, a hit at `nearest` itself counts too

    /// Distance from the based origin to a primitive, or infinity.
    HD_INNER Real distance_to(uint32_t id) const {
        const GeometryView<Real>& geometry = scene.geometry;
        const Real beyond = id > passed ? just_below(nearest) : nearest;
        if (id == ray.source.primitive)
            return ray.source.exit > larger(beyond, -ray.offset) ? ray.source.exit : infinity<Real>;
        if (geometry.is_sphere(id))
            return intersect(geometry.spheres[id], ray.ray, beyond, scene.limits.min_half_chord2);
        if (geometry.is_plane(id))
            return intersect(geometry.plane(id), ray.ray, beyond, scene.limits.min_cosine);
        return intersect(geometry.ellipsoid(id), ray.ray, beyond, scene.limits.min_half_chord2);
    }
    /// Whether a primitive's material has one of these bits of Material::flags.
    HD bool is_one_of(uint32_t flags, uint32_t id) const {
        return (scene.surfaces.materials[scene.geometry.material(id)].flags & flags) != 0;
    }
    HD bool casts_shadow(uint32_t id) const { return !scene.has_no_shadow || !is_one_of(material_no_shadow, id); }
};

/// Keeps the nearest of the hits that it is shown.
template <class Real> struct NearestHit {
    Search<Real> search;
    uint32_t hidden; ///< bits of Material::flags: leaves out materials with one of them
    Hit<Real> best;

    HD_INNER void meet(uint32_t id) {
        const Real t = search.distance_to(id);
        const bool ties = t == best.t && best.primitive != no_primitive && id < best.primitive;
        if ((t < best.t || ties) && !(hidden && search.is_one_of(hidden, id)))
            best = {t, id};
    }
    HD_INNER bool is_done(Real reached) const { return best.t <= reached; }
};

/// Stops at the first hit of a primitive that casts a shadow.
template <class Real> struct AnyHit {
    Search<Real> search;
    Real farthest;
    bool found = false;

    HD_INNER void meet(uint32_t id) {
        if (!found && search.distance_to(id) < farthest)
            found = search.casts_shadow(id);
    }
    HD_INNER bool is_done(Real reached) const { return found || farthest <= reached; }
};

} // namespace proxima
