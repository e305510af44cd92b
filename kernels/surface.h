// SPDX-License-Identifier: Apache-2.0
// A hit in, the place on the surface out; and rays that leave such a place. Real is the precision in which rays are
// tested, Path that in which a path is followed: six mirrors in a row magnify the rounding of float to whole pixels, so
// paths that go on are followed in double, on the shapes in double, and only their tests are in float.
#pragma once
#include "kernels/traverse.h"

#include <type_traits>

namespace proxima {

/// Where a ray met a primitive.
template <class Path> struct Surface {
    Vec3<Path> point;   ///< moved onto the primitive
    Vec3<Path> outward; ///< unit normal, away from the primitive's inside
    Vec3<Path> normal;  ///< the same, turned to the side that the ray came from
    uint32_t primitive;
    uint32_t material;
    bool from_inside; ///< the ray came through the primitive's inside

    /// The same place in the precision of shading.
    template <class Real> HD Surface<Real> rounded() const {
        return {Vec3<Real>(point), Vec3<Real>(outward), Vec3<Real>(normal), primitive, material, from_inside};
    }
};

/// The shapes in the precision of a path.
template <class Path, class Real> HD const ShapesView<Path>& shapes_of(const SceneView<Real>& scene) {
    if constexpr (std::is_same_v<Path, Real>)
        return scene.geometry;
    else
        return scene.exact;
}

/// The distance near `about` at which a ray meets a shape; `about` itself where the ray only just misses it.
template <class Path>
HD Path refined_distance(const ShapesView<Path>& shapes, const Ray<Path>& ray, uint32_t id, Path about) {
    if (shapes.is_plane(id)) {
        const Path t = intersect(shapes.plane(id), ray, -infinity<Path>, Path(0));
        return t < infinity<Path> ? t : about;
    }
    const Chord<Path> met =
        shapes.is_sphere(id) ? chord(shapes.spheres[id], ray, Path(0)) : chord(shapes.ellipsoid(id), ray, Path(0));
    if (met.near == infinity<Path>)
        return about;
    return magnitude(met.near - about) < magnitude(met.far - about) ? met.near : met.far;
}

/// The point of a shape, and its outward normal, at a point close to its surface. Where Real tells nothing apart, the
/// normal may be 0: no light comes from there.
template <class Path> HD void move_onto(const ShapesView<Path>& shapes, Surface<Path>& surface) {
    const uint32_t id = surface.primitive;
    if (shapes.is_sphere(id)) {
        const Sphere<Path>& sphere = shapes.spheres[id];
        surface.outward = direction_of(surface.point - sphere.center);
        surface.point = sphere.center + sphere.radius * surface.outward;
    } else if (shapes.is_plane(id)) {
        const Plane<Path>& plane = shapes.plane(id);
        surface.outward = plane.normal;
        surface.point -= (glm::dot(plane.normal, surface.point) - plane.distance) * plane.normal;
    } else {
        const Ellipsoid<Path>& ellipsoid = shapes.ellipsoid(id);
        const Vec3<Path> seen = direction_of(ellipsoid.object_from_world.point(surface.point));
        surface.point = ellipsoid.world_from_object.point(seen);
        surface.outward = direction_of(ellipsoid.object_from_world.normal_to_source(seen));
    }
}

/// The place `along` a ray in float on a sphere whose surface float does not hold.
HD_RARE inline void move_onto_exactly(const ShapesView<double>& shapes, const Ray<float>& ray, float along,
                                      Surface<float>& surface) {
    Surface<double> exact;
    exact.primitive = surface.primitive;
    exact.point = Vec3<double>(ray.origin) + double(along) * Vec3<double>(ray.direction);
    move_onto(shapes, exact);
    surface.point = Vec3<float>(exact.point);
    surface.outward = Vec3<float>(exact.outward);
}

/// The place at which `ray`, based as `based`, made a hit.
template <class Path, class Real>
HD Surface<Path> surface_at(const SceneView<Real>& scene, const SourcedRay<Path>& ray, const BasedRay<Real>& based,
                            const Hit<Real>& hit) {
    const ShapesView<Path>& shapes = shapes_of<Path>(scene);
    Surface<Path> surface;
    surface.primitive = hit.primitive;
    surface.material = scene.geometry.material(hit.primitive);
    bool is_on = false;
    if constexpr (std::is_same_v<Path, float>) {
        is_on = scene.meets_exactly(hit.primitive);
        if (is_on)
            move_onto_exactly(scene.exact, based.ray, hit.t, surface);
    }
    if constexpr (std::is_same_v<Path, Real>) {
        surface.point = is_on ? surface.point : based.ray.origin + hit.t * based.ray.direction;
    } else {
        const Path about = Path(based.offset) + Path(hit.t);
        const Path t = hit.primitive == ray.source.primitive ? ray.source.exit
                                                             : refined_distance(shapes, ray.ray, hit.primitive, about);
        surface.point = ray.ray.origin + t * ray.ray.direction;
    }
    if (!is_on)
        move_onto(shapes, surface);
    surface.from_inside = glm::dot(surface.outward, ray.ray.direction) > 0;
    surface.normal = surface.from_inside ? -surface.outward : surface.outward;
    return surface;
}

/// The way from the last hit that a ray passed, or from its origin, to the next.
template <class Real>
HD Real distance_passed(const BasedRay<Real>& based, const Hit<Real>& passed, const Hit<Real>& hit) {
    return passed.primitive != no_primitive ? hit.t - passed.t : hit.t + based.offset;
}

/// The length of the chord that starts on a primitive's surface and leads into it; not positive for planes.
template <class Path>
HD Path chord(const ShapesView<Path>& shapes, const Surface<Path>& surface, const Vec3<Path>& direction) {
    if (shapes.is_sphere(surface.primitive))
        return Path(-2) * shapes.spheres[surface.primitive].radius * glm::dot(surface.outward, direction);
    if (shapes.is_plane(surface.primitive))
        return Path(0);
    const Affine<Path>& map = shapes.ellipsoid(surface.primitive).object_from_world;
    const Vec3<Path> seen = map.direction(direction);
    return Path(-2) * glm::dot(map.point(surface.point), seen) / glm::dot(seen, seen);
}

/// A ray that starts on a surface, on the inside of its primitive or on the outside.
template <class Path>
HD SourcedRay<Path> leave(const ShapesView<Path>& shapes, const Surface<Path>& surface, const Vec3<Path>& direction,
                          bool inside) {
    return {{surface.point, direction}, {surface.primitive, inside ? chord(shapes, surface, direction) : Path(0)}};
}

/// Whether a point is inside a primitive.
template <class Path> HD bool contains(const ShapesView<Path>& shapes, uint32_t id, const Vec3<Path>& point) {
    if (shapes.is_plane(id))
        return glm::dot(shapes.plane(id).normal, point) < shapes.plane(id).distance;
    if (!shapes.is_sphere(id)) {
        const Vec3<Path> seen = shapes.ellipsoid(id).object_from_world.point(point);
        return glm::dot(seen, seen) < 1;
    }
    const Vec3<Path> offset = point - shapes.spheres[id].center;
    return glm::dot(offset, offset) < shapes.spheres[id].radius * shapes.spheres[id].radius;
}

} // namespace proxima
