// SPDX-License-Identifier: Apache-2.0
// A frame's scene as the kernels see it: views of device arrays and a few numbers. Nothing here owns memory.
#pragma once
#include "kernels/camera.h"
#include "kernels/fog.h"
#include "kernels/geometry.h"
#include "kernels/grid.h"
#include "kernels/light.h"
#include "kernels/material.h"

#include <span>

namespace proxima {

inline constexpr uint32_t no_primitive = 0xffffffffu;

/// Which lengths count. The defaults accept every hit in front of the ray; povray() has POV-Ray 3.7's absolute numbers.
template <class Real> struct HitLimits {
    Real min_half_chord2 = Real(0);
    Real min_cosine = Real(0); ///< between a ray and a plane
    Real nearest = Real(0);
    Real farthest = infinity<Real>;
    Real shadow_margin = Real(0); ///< at either end of a shadow ray
    float least_fade = 0.0f;      ///< nothing fades by a fade_distance that is not longer

    HD static HitLimits povray() { return {Real(1e-10), Real(1e-10), Real(1e-4), Real(1e7), Real(1e-3), 1e-10f}; }
};

/// The shapes of all primitives. Ids count spheres, then ellipsoids, then planes.
template <class Real> struct ShapesView {
    std::span<const Sphere<Real>> spheres;
    std::span<const Ellipsoid<Real>> ellipsoids;
    std::span<const Plane<Real>> planes;

    HD uint32_t sphere_count() const { return uint32_t(spheres.size()); }
    HD uint32_t round_count() const { return uint32_t(spheres.size() + ellipsoids.size()); }
    HD bool is_sphere(uint32_t id) const { return id < sphere_count(); }
    HD bool is_plane(uint32_t id) const { return id >= round_count(); }
    HD const Ellipsoid<Real>& ellipsoid(uint32_t id) const { return ellipsoids[id - sphere_count()]; }
    HD const Plane<Real>& plane(uint32_t id) const { return planes[id - round_count()]; }
    HD bool empty() const { return spheres.empty() && ellipsoids.empty() && planes.empty(); }
    /// Whether a scene has a primitive twice: as these two.
    HD bool is_repeated(uint32_t a, uint32_t b) const {
        if (is_sphere(a))
            return is_sphere(b) && spheres[a].radius == spheres[b].radius && spheres[a].center == spheres[b].center;
        if (is_plane(a))
            return is_plane(b) && plane(a).distance == plane(b).distance && plane(a).normal == plane(b).normal;
        if (is_sphere(b) || is_plane(b))
            return false;
        const Affine<Real>&first = ellipsoid(a).world_from_object, &second = ellipsoid(b).world_from_object;
        return first.linear == second.linear && first.offset == second.offset;
    }
};

/// What rays are tested with. Spheres and ellipsoids are `bounded`: they lie in `bounds`, save those of radius above
/// `large_radius`, which are listed in `large`; every ray tests those and the planes.
template <class Real> struct GeometryView : ShapesView<Real> {
    using ShapesView<Real>::spheres;
    using ShapesView<Real>::is_sphere;
    using ShapesView<Real>::is_plane;
    using ShapesView<Real>::ellipsoid;
    using ShapesView<Real>::plane;

    std::span<const uint32_t> sphere_materials;
    std::span<const uint32_t> large;
    Real large_radius = infinity<Real>;
    /// Padded. When nothing is bounded, a ray goes through it without being moved.
    Box<Real> bounds{Vec3<Real>(infinity<Real>), Vec3<Real>(-infinity<Real>)};
    Real slack = infinity<Real>; ///< rounding_slack() within the bounds

    HD uint32_t material(uint32_t id) const {
        return is_sphere(id) ? sphere_materials[id] : is_plane(id) ? plane(id).material : ellipsoid(id).material;
    }
    /// The box of a sphere or an ellipsoid.
    HD Box<Real> box(uint32_t id) const {
        if (!is_sphere(id))
            return bounding_box(ellipsoid(id));
        const Vec3<Real> radius(spheres[id].radius);
        return {spheres[id].center - radius, spheres[id].center + radius};
    }
    /// Whether it is there and not large.
    HD bool is_bounded(uint32_t id) const {
        const Real size = radius(id);
        return size > 0 && !(size > large_radius);
    }
    HD Vec3<Real> center(uint32_t id) const {
        return is_sphere(id) ? spheres[id].center : ellipsoid(id).world_from_object.offset;
    }
    /// The radius of a sphere; of an ellipsoid, half of its box's longest side.
    HD Real radius(uint32_t id) const {
        if (is_sphere(id))
            return spheres[id].radius;
        const Box<Real> box = bounding_box(ellipsoid(id));
        return Real(0.5) * max_component(box.upper - box.lower);
    }
};

template <class Real> struct SurfacesView {
    std::span<const Material> materials;
    std::span<const Layer> layers;
    std::span<const Pigment> pigments;
    std::span<const Pattern> patterns;
    std::span<const ColorStop> color_stops;
    std::span<const Finish> finishes;
    std::span<const Interior> interiors;
    std::span<const Affine<Real>> transforms;
    bool legacy_transparency = false;
};

template <class Real> struct SceneView {
    GeometryView<Real> geometry;
    ShapesView<double> exact; ///< the same shapes, for paths that go on from them and for large ones; empty where there
                              ///< is neither
    GridView<Real> grid;      ///< without cells: every bounded primitive is tested
    GridView<Real> outskirts; ///< in use beside a grid for the core alone, and for all others
    SurfacesView<Real> surfaces;
    std::span<const Light<Real>> lights;
    std::span<const AreaLight<Real>> area_lights;
    std::span<const AreaSample> area_samples;
    std::span<const uint32_t> sky_pigments; ///< of the sky sphere, the last one in front
    std::span<const Fog<Real>> fogs;
    Camera<double> camera;
    HitLimits<Real> limits;
    glm::vec3 background{0.0f};
    glm::vec3 sky_emission{1.0f};
    glm::vec3 ambient_light{1.0f};
    float adc_bailout = 1.0f / 255.0f;
    uint32_t max_trace_level = 5;
    bool has_fading = false;    ///< some interior attenuates
    bool has_no_shadow = false; ///< some material casts no shadow
    bool has_hidden = false;    ///< some material is no_image or no_reflection

    /// Whether rays in float meet a sphere in double: float would move the surface of one that is large by more than
    /// the small things on it can bear.
    HD bool meets_exactly(uint32_t id) const {
        return !exact.spheres.empty() && geometry.is_sphere(id) && geometry.spheres[id].radius > geometry.large_radius;
    }
    /// Whether two primitives are the same shape at the same place, as exactly as it is known.
    HD_RARE bool is_repeated(uint32_t a, uint32_t b) const {
        return geometry.is_repeated(a, b) && (exact.empty() || exact.is_repeated(a, b));
    }
};

} // namespace proxima
