// SPDX-License-Identifier: Apache-2.0
// The shapes, in the scene's own units, and the pure functions that meet them with a ray. Distances are along the ray's
// unit direction, from its origin.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// `direction` has unit length.
template <class Real> struct Ray {
    Vec3<Real> origin;
    Vec3<Real> direction;
};

/// 16 bytes in float. Its material stands in a separate array of the same order.
template <class Real> struct alignas(4 * sizeof(Real)) Sphere {
    Vec3<Real> center{Real(0)};
    Real radius = Real(1);
};

/// The unit sphere at the origin, seen through a map that is not a similarity.
template <class Real> struct Ellipsoid {
    Affine<Real> object_from_world;
    Affine<Real> world_from_object;
    uint32_t material = 0;
};

/// The half space dot(normal, p) < distance is its inside. `normal` has unit length.
template <class Real> struct Plane {
    Vec3<Real> normal{Real(0), Real(1), Real(0)};
    Real distance = Real(0);
    uint32_t material = 0;
};

template <class Real> struct Box {
    Vec3<Real> lower{Real(0)};
    Vec3<Real> upper{Real(0)};
};

/// The box around two boxes.
template <class Real> HD Box<Real> joined(const Box<Real>& a, const Box<Real>& b) {
    Box<Real> box;
    for (int i = 0; i < 3; ++i) {
        box.lower[i] = smaller(a.lower[i], b.lower[i]);
        box.upper[i] = larger(a.upper[i], b.upper[i]);
    }
    return box;
}

/// Whether a point is in a box or on it.
template <class Real> HD bool contains(const Box<Real>& box, const Vec3<Real>& point) {
    bool inside = true;
    for (int i = 0; i < 3; ++i)
        inside = inside & (box.lower[i] <= point[i]) & (point[i] <= box.upper[i]);
    return inside;
}

/// The box that an ellipsoid just fits in.
template <class Real> HD Box<Real> bounding_box(const Ellipsoid<Real>& ellipsoid) {
    const Affine<Real>& map = ellipsoid.world_from_object;
    Vec3<Real> half;
    for (int i = 0; i < 3; ++i)
        half[i] = glm::length(Vec3<Real>(map.linear[0][i], map.linear[1][i], map.linear[2][i]));
    return {map.offset - half, map.offset + half};
}

/// Where a ray enters and leaves a shape; both infinite when it misses.
template <class Real> struct Chord {
    Real near = infinity<Real>;
    Real far = infinity<Real>;

    /// The first of the two that lies beyond `nearest`; infinity when there is none.
    HD_INNER Real beyond(Real nearest) const { return near > nearest ? near : far > nearest ? far : infinity<Real>; }
};

/// How a ray comes near a sphere.
template <class Real> struct Approach {
    Vec3<Real> from_center; ///< the ray's origin
    Real radius2;
    Real closest;     ///< distance along the ray to its closest point
    Real half_chord2; ///< negative when it misses

    /// Of the ray's origin: its squared distance from the centre less the squared radius. Rays that miss need none.
    HD_INNER Real power() const { return glm::dot(from_center, from_center) - radius2; }
};

/// Stable form: Haines, Guenther, Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", 2019.
template <class Real> HD_INNER Approach<Real> approach(const Sphere<Real>& sphere, const Ray<Real>& ray) {
    const Vec3<Real> from_center = ray.origin - sphere.center;
    const Real b = -glm::dot(from_center, ray.direction);
    const Vec3<Real> closest = from_center + b * ray.direction;
    const Real radius2 = sphere.radius * sphere.radius;
    return {from_center, radius2, b, radius2 - glm::dot(closest, closest)};
}

/// For rays whose origins are at most R from the centres. With u = 2^-24 either way of rounding puts the closest point
/// up to 3 u R aside along the ray and another 4 u R off; with what the last squares and sums lose it is less than
/// 24 u R. Where R is so small that squares vanish no slack is enough.
HD inline float rounding_slack(float r) {
    return r > 1e-12f ? r * 0x1.8p-20f : infinity<float>;
}
HD inline double rounding_slack(double r) {
    return r > 1e-145 ? r * 0x1.8p-49 : infinity<double>;
}

/// Whether a ray certainly misses a sphere, in fewer instructions than approach() takes: with fused multiplications,
/// whose rounding may differ from processor to processor, since what they leave to the exact test has no mark on the
/// picture. `slack`: what rounding may make of the distance between ray and centre; see rounding_slack().
HD_INNER bool passes_by([[maybe_unused]] const Sphere<float>& sphere, [[maybe_unused]] const Ray<float>& ray,
                        [[maybe_unused]] float slack) {
#if defined(__CUDA_ARCH__)
    const Vec3<float> o = ray.origin - sphere.center, &d = ray.direction;
    const float b = -__fmaf_rn(o.z, d.z, __fmaf_rn(o.y, d.y, o.x * d.x));
    const float x = __fmaf_rn(b, d.x, o.x), y = __fmaf_rn(b, d.y, o.y), z = __fmaf_rn(b, d.z, o.z);
    const float reach = sphere.radius + slack;
    return __fmaf_rn(z, z, __fmaf_rn(y, y, x * x)) > reach * reach;
#else
    return false;
#endif
}
HD_INNER bool passes_by(const Sphere<double>&, const Ray<double>&, double) {
    return false;
}

/// The chord of a ray that does not miss; see Approach.
template <class Real> HD_INNER Chord<Real> chord(Real closest, Real half_chord2, Real power) {
    const Real half_chord = square_root(half_chord2);
    const Real q = closest < 0 ? closest - half_chord : closest + half_chord;
    const Real other = power / q;
    return {closest < 0 ? q : other, closest < 0 ? other : q};
}
template <class Real> HD_INNER Chord<Real> chord(const Approach<Real>& met) {
    return chord(met.closest, met.half_chord2, met.power());
}

/// A sphere's chord along `ray`, which must be longer than 2 sqrt(min_half_chord2).
template <class Real>
HD_INNER Chord<Real> chord(const Sphere<Real>& sphere, const Ray<Real>& ray, Real min_half_chord2) {
    const Approach<Real> met = approach(sphere, ray);
    return met.half_chord2 > min_half_chord2 ? chord(met) : Chord<Real>{};
}

/// The smallest of a sphere's two distances along `ray` that lies beyond `nearest`; infinity when there is none.
template <class Real>
HD_INNER Real intersect(const Sphere<Real>& sphere, const Ray<Real>& ray, Real nearest, Real min_half_chord2) {
    return chord(sphere, ray, min_half_chord2).beyond(nearest);
}

/// An ellipsoid's chord; the half chord is measured in the ellipsoid's own space.
template <class Real>
HD Chord<Real> chord(const Ellipsoid<Real>& ellipsoid, const Ray<Real>& ray, Real min_half_chord2) {
    const Vec3<Real> direction = ellipsoid.object_from_world.direction(ray.direction);
    const Real length = glm::length(direction);
    const Ray<Real> seen{ellipsoid.object_from_world.point(ray.origin), direction / length};
    const Chord<Real> in_object = chord(Sphere<Real>{}, seen, min_half_chord2);
    return {in_object.near / length, in_object.far / length};
}

/// As for a sphere. `nearest` is compared with the distances that are returned, so that a ray that goes on from one of
/// them never finds it again.
template <class Real>
HD Real intersect(const Ellipsoid<Real>& ellipsoid, const Ray<Real>& ray, Real nearest, Real min_half_chord2) {
    return chord(ellipsoid, ray, min_half_chord2).beyond(nearest);
}

/// The distance to a plane if it lies beyond `nearest`, else infinity. Rays within `min_cosine` of the plane miss it.
template <class Real> HD Real intersect(const Plane<Real>& plane, const Ray<Real>& ray, Real nearest, Real min_cosine) {
    const Real cosine = glm::dot(plane.normal, ray.direction);
    if (!(magnitude(cosine) > min_cosine))
        return infinity<Real>;
    const Real t = (plane.distance - glm::dot(plane.normal, ray.origin)) / cosine;
    return t > nearest ? t : infinity<Real>;
}

/// The part of a ray inside a box; `enter` is 0 for an origin inside. A ray that misses has enter > exit.
template <class Real> struct Span {
    Real enter = Real(0);
    Real exit = infinity<Real>;
};

template <class Real> HD_INNER Span<Real> intersect(const Box<Real>& box, const Ray<Real>& ray) {
    Span<Real> span;
    bool passes_by = false;
    for (int i = 0; i < 3; ++i) {
        const Real origin = ray.origin[i];
        const bool stands = ray.direction[i] == 0; // 0 / 0 on a face would lose the ray
        const Real inverse = Real(1) / ray.direction[i];
        const Real low = stands ? -infinity<Real> : (box.lower[i] - origin) * inverse;
        const Real high = stands ? infinity<Real> : (box.upper[i] - origin) * inverse;
        span.enter = larger(span.enter, smaller(low, high));
        span.exit = smaller(span.exit, larger(low, high));
        passes_by = passes_by | (stands & ((origin < box.lower[i]) | (origin > box.upper[i])));
    }
    return {passes_by ? Real(1) : span.enter, passes_by ? Real(0) : span.exit};
}

} // namespace proxima
