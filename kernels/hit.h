// SPDX-License-Identifier: Apache-2.0
// A ray and one primitive after the other in, the nearest hit or the knowledge of any hit out. A ray is moved once to
// where it enters the frame's bounds, and every primitive is met from there: the distances, and so the picture, do not
// depend on the grid's resolution or on whether there is a grid at all. Ties go to the smaller id.
#pragma once
#include "kernels/scene_view.h"

#include <type_traits>

namespace proxima {

/// The primitive that a ray starts on. A ray going outward cannot meet it again; one going inward meets it at `exit`,
/// which is exact where an intersection test would have to tell 0 from almost 0. Should a scene have it twice, the
/// other one is not there for the ray.
template <class Real> struct RaySource {
    uint32_t primitive = no_primitive;
    Real exit = Real(0); ///< not positive: never
};

template <class Real> struct SourcedRay {
    Ray<Real> ray;
    RaySource<Real> source;
};

/// A hit, at `t` from the based origin. As the place that a ray has passed: hits come in the order of (t, primitive),
/// and what a scene has once more of what was passed is not there.
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
template <class Real, class Path>
HD_INNER BasedRay<Real> rebase(const SourcedRay<Path>& from, const Box<Real>& bounds) {
    const Span<Path> span = intersect(Box<Path>{Vec3<Path>(bounds.lower), Vec3<Path>(bounds.upper)}, from.ray);
    const bool meets_bounds = span.enter <= span.exit;
    const Path offset = meets_bounds & (span.enter > 0) ? span.enter : Path(0);
    BasedRay<Real> based{{Vec3<Real>(from.ray.origin), Vec3<Real>(from.ray.direction)},
                         {from.source.primitive, Real(from.source.exit - offset)},
                         Real(offset),
                         meets_bounds};
    const Vec3<Path> entry = from.ray.origin + offset * from.ray.direction;
    for (int i = 0; i < 3; ++i) {
        const Real inside = clamped(Real(entry[i]), bounds.lower[i], bounds.upper[i]);
        based.ray.origin[i] = offset > 0 ? inside : based.ray.origin[i];
    }
    return based;
}

/// The same for rays that mostly start within the bounds, as those do that leave a primitive of the grid.
template <class Real, class Path>
HD_INNER BasedRay<Real> rebase_from_within(const SourcedRay<Path>& from, const Box<Real>& bounds) {
    const Vec3<Path>& origin = from.ray.origin;
    bool is_within = true;
    for (int i = 0; i < 3; ++i)
        is_within = is_within && origin[i] >= Path(bounds.lower[i]) && origin[i] <= Path(bounds.upper[i]);
    if (!is_within)
        return rebase(from, bounds);
    return {{Vec3<Real>(origin), Vec3<Real>(from.ray.direction)},
            {from.source.primitive, Real(from.source.exit)},
            Real(0),
            true};
}

/// The distance from a ray's origin to a sphere, by its numbers in double; else as intersect().
HD_RARE inline float exact_distance(const Sphere<double>& sphere, const Ray<float>& ray, float nearest,
                                    float min_half_chord2) {
    const Ray<double> exact{Vec3<double>(ray.origin), Vec3<double>(ray.direction)};
    return float(intersect(sphere, exact, double(nearest), double(min_half_chord2)));
}

/// What the lists of a grid hold. Kernels for scenes of spheres alone need not ask each primitive what it is.
enum class RoundShapes { spheres, all };

/// What a ray looks for: hits beyond `nearest` of the based origin. The primitive that the ray starts on is told apart
/// by those who look, and only where a test finds something.
template <class Real> struct Search {
    const SceneView<Real>& scene;
    const BasedRay<Real>& ray;
    Real nearest;
    uint32_t passed = no_primitive; ///< of the primitives with a greater id, a hit at `nearest` itself counts too

    HD_INNER Real beyond(uint32_t id) const { return id > passed ? just_below(nearest) : nearest; }

    /// Distance from the based origin to a primitive, or infinity.
    HD_INNER Real distance_to(uint32_t id) const {
        const GeometryView<Real>& geometry = scene.geometry;
        if (geometry.is_sphere(id))
            return distance_to_sphere(id);
        if (geometry.is_plane(id))
            return distance_to_plane(id);
        return intersect(geometry.ellipsoid(id), ray.ray, beyond(id), scene.limits.min_half_chord2);
    }
    /// The same for what is too large for the grid.
    template <RoundShapes shapes> HD Real distance_to_large(uint32_t id) const {
        if constexpr (std::is_same_v<Real, float>)
            if (scene.meets_exactly(id))
                return exact_distance(scene.exact.spheres[id], ray.ray, beyond(id), scene.limits.min_half_chord2);
        return shapes == RoundShapes::spheres ? distance_to_sphere(id) : distance_to(id);
    }
    HD_INNER Real distance_to_sphere(uint32_t id) const {
        const Sphere<Real> sphere = scene.geometry.spheres[id];
        return intersect(sphere, ray.ray, beyond(id), scene.limits.min_half_chord2);
    }
    /// Calls found(distance) if the ray meets a sphere of the grid beyond where it starts, other than the one that it
    /// starts on: most that it is shown it misses, and nothing more is done then.
    template <class Found> HD_INNER bool at_sphere(uint32_t id, const Found& found) const {
        const Sphere<Real> sphere = scene.geometry.spheres[id]; // in one load
        if (passes_by(sphere, ray.ray, scene.geometry.slack))
            return false;
        const Approach<Real> met = approach(sphere, ray.ray);
        if (!(met.half_chord2 > scene.limits.min_half_chord2) || id == ray.source.primitive)
            return false;
        const Real from = beyond(id), power = met.power();
        if (met.closest < 0 && power > 0 && from >= 0)
            return false; // it lies behind, without a root or a division
        return found(chord(met.closest, met.half_chord2, power).beyond(from));
    }
    HD Real distance_to_plane(uint32_t id) const {
        return intersect(scene.geometry.plane(id), ray.ray, beyond(id), scene.limits.min_cosine);
    }
    /// The distance to the far side of the primitive that the ray starts on, or infinity.
    HD Real distance_to_exit() const {
        const RaySource<Real>& source = ray.source;
        const bool counts =
            source.primitive != no_primitive && source.exit > larger(beyond(source.primitive), -ray.offset);
        return counts ? source.exit : infinity<Real>;
    }
    /// Whether a shadow ray leaves the primitive that it starts on before `farthest`, and that one casts a shadow.
    HD bool is_shadowed_by_source(Real farthest) const {
        return distance_to_exit() < farthest && casts_shadow(ray.source.primitive);
    }
    /// Whether a primitive is once more what the ray starts on or has passed. What holds for the one holds for the
    /// other, no test could tell 0 from almost 0, and a body of glass counts once however its light goes on.
    HD bool repeats_known(uint32_t id) const { return repeats(ray.source.primitive, id) || repeats(passed, id); }
    /// Whether a primitive's material has one of these bits of Material::flags.
    HD bool is_one_of(uint32_t flags, uint32_t id) const {
        return (scene.surfaces.materials[scene.geometry.material(id)].flags & flags) != 0;
    }
    HD bool casts_shadow(uint32_t id) const { return !scene.has_no_shadow || !is_one_of(material_no_shadow, id); }

private:
    HD bool repeats(uint32_t known, uint32_t id) const {
        return known != no_primitive && known != id && scene.is_repeated(known, id);
    }
};

/// Keeps the nearest of the hits that it is shown.
template <class Real> class NearestHit {
public:
    /// `hidden`: bits of Material::flags; leaves out materials with one of them.
    HD NearestHit(const Search<Real>& search, uint32_t hidden, Real farthest)
        : search_(search), hidden_(hidden), best_{farthest, no_primitive} {
        take(search.ray.source.primitive, search.distance_to_exit());
    }

    /// True when nothing more needs to be met.
    HD_INNER bool meet(uint32_t id) { return consider(id, search_.distance_to(id)); }
    HD_INNER bool meet_sphere(uint32_t id) {
        return search_.at_sphere(id, [&](Real t) { return consider(id, t); });
    }
    HD bool meet_plane(uint32_t id) { return consider(id, search_.distance_to_plane(id)); }
    template <RoundShapes shapes> HD bool meet_large(uint32_t id) {
        return consider(id, search_.template distance_to_large<shapes>(id));
    }
    HD_INNER bool is_done(Real reached) const { return best_.t <= reached; }
    HD const Hit<Real>& best() const { return best_; }

private:
    HD_INNER bool consider(uint32_t id, Real t) {
        if (t <= best_.t && id != search_.ray.source.primitive && !search_.repeats_known(id))
            take(id, t);
        return false;
    }
    HD_INNER void take(uint32_t id, Real t) {
        const bool ties = t == best_.t && best_.primitive != no_primitive && id < best_.primitive;
        if ((t < best_.t || ties) && !(hidden_ && search_.is_one_of(hidden_, id)))
            best_ = {t, id};
    }

    Search<Real> search_;
    uint32_t hidden_;
    Hit<Real> best_;
};

/// Stops at the first hit of a primitive that casts a shadow.
template <class Real> class AnyHit {
public:
    HD AnyHit(const Search<Real>& search, Real farthest)
        : search_(search), farthest_(farthest), found_(search.is_shadowed_by_source(farthest)) {}

    HD_INNER bool meet(uint32_t id) { return consider(id, search_.distance_to(id)); }
    HD_INNER bool meet_sphere(uint32_t id) {
        return search_.at_sphere(id, [&](Real t) { return consider(id, t); });
    }
    HD bool meet_plane(uint32_t id) { return consider(id, search_.distance_to_plane(id)); }
    template <RoundShapes shapes> HD bool meet_large(uint32_t id) {
        return consider(id, search_.template distance_to_large<shapes>(id));
    }
    HD_INNER bool is_done(Real reached) const { return found_ || farthest_ <= reached; }
    HD bool found() const { return found_; }

private:
    HD_INNER bool consider(uint32_t id, Real t) {
        if (t < farthest_ && id != search_.ray.source.primitive && !search_.repeats_known(id))
            found_ = search_.casts_shadow(id);
        return found_;
    }

    Search<Real> search_;
    Real farthest_;
    bool found_;
};

} // namespace proxima
