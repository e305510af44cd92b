// SPDX-License-Identifier: Apache-2.0
// A hit in, the place on the surface out; and rays that leave such a place.
#pragma once
#include "kernels/traverse.h"

namespace proxima {

/// Where a ray met a primitive.
template <class Real> struct Surface {
    Vec3<Real> point;   ///< moved onto the primitive
    Vec3<Real> outward; ///< unit normal, away from the primitive's inside
    Vec3<Real> normal;  ///< the same, turned to the side that the ray came from
    uint32_t primitive;
    uint32_t material;
    bool from_inside; ///< the ray came through the primitive's inside
};

template <class Real>
HD Surface<Real> surface_at(const GeometryView<Real>& geometry, const BasedRay<Real>& based, const Hit<Real>& hit) {
    Surface<Real> surface;
    surface.primitive = hit.primitive;
    surface.material = geometry.material(hit.primitive);
    surface.point = based.ray.origin + hit.t * based.ray.direction;
    if (geometry.is_sphere(hit.primitive)) {
        const Sphere<Real>& sphere = geometry.spheres[hit.primitive];
        surface.outward = glm::normalize(surface.point - sphere.center);
        surface.point = sphere.center + sphere.radius * surface.outward;
    } else if (geometry.is_plane(hit.primitive)) {
        const Plane<Real>& plane = geometry.plane(hit.primitive);
        surface.outward = plane.normal;
        surface.point -= (glm::dot(plane.normal, surface.point) - plane.distance) * plane.normal;
    } else {
        const Ellipsoid<Real>& ellipsoid = geometry.ellipsoid(hit.primitive);
        const Vec3<Real> seen = glm::normalize(ellipsoid.object_from_world.point(surface.point));
        surface.point = ellipsoid.world_from_object.point(seen);
        surface.outward = glm::normalize(ellipsoid.object_from_world.normal_to_source(seen));
    }
    surface.from_inside = glm::dot(surface.outward, based.ray.direction) > 0;
    surface.normal = surface.from_inside ? -surface.outward : surface.outward;
    return surface;
}

/// The way from the last hit that a ray passed, or from its origin, to the next.
template <class Real>
HD Real distance_passed(const BasedRay<Real>& based, const Hit<Real>& passed, const Hit<Real>& hit) {
    return passed.primitive != no_primitive ? hit.t - passed.t : hit.t + based.offset;
}

/// The length of the chord that starts on a primitive's surface and leads into it; not positive for planes.
template <class Real>
HD Real chord(const GeometryView<Real>& geometry, const Surface<Real>& surface, const Vec3<Real>& direction) {
    if (geometry.is_sphere(surface.primitive))
        return Real(-2) * geometry.spheres[surface.primitive].radius * glm::dot(surface.outward, direction);
    if (geometry.is_plane(surface.primitive))
        return Real(0);
    const Affine<Real>& map = geometry.ellipsoid(surface.primitive).object_from_world;
    const Vec3<Real> seen = map.direction(direction);
    return Real(-2) * glm::dot(map.point(surface.point), seen) / glm::dot(seen, seen);
}

/// A ray that starts on a surface, on the inside of its primitive or on the outside.
template <class Real>
HD SourcedRay<Real> leave(const GeometryView<Real>& geometry, const Surface<Real>& surface, const Vec3<Real>& direction,
                          bool inside) {
    return {{surface.point, direction}, {surface.primitive, inside ? chord(geometry, surface, direction) : Real(0)}};
}

/// Whether a point is inside a primitive.
template <class Real> HD bool contains(const GeometryView<Real>& geometry, uint32_t id, const Vec3<Real>& point) {
    if (geometry.is_plane(id))
        return glm::dot(geometry.plane(id).normal, point) < geometry.plane(id).distance;
    if (!geometry.is_sphere(id)) {
        const Vec3<Real> seen = geometry.ellipsoid(id).object_from_world.point(point);
        return glm::dot(seen, seen) < 1;
    }
    const Vec3<Real> offset = point - geometry.spheres[id].center;
    return glm::dot(offset, offset) < geometry.spheres[id].radius * geometry.spheres[id].radius;
}

} // namespace proxima
