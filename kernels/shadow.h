// SPDX-License-Identifier: Apache-2.0
// A surface and a light in, the part of the light that arrives out.
#pragma once
#include "kernels/interiors.h"
#include "kernels/pigment.h"

namespace proxima {

/// What a material lets through at a point of its surface.
template <class Real>
HD Vec3<Real> material_transmission(const SceneView<Real>& scene, const Material& material, const Vec3<Real>& point) {
    Vec3<Real> through(Real(1));
    for (uint32_t i = material.layer_count; i-- > 0;) {
        const Layer& layer = scene.surfaces.layers[material.first_layer + i];
        through *= layer_color(scene.surfaces, scene.surfaces.pigments[layer.pigment], point).transmission;
    }
    return through;
}

/// Whether something stands between a surface and `distance` along `to_light`, where all that casts a shadow is opaque.
template <RoundShapes shapes = RoundShapes::all, Ways ways = Ways::any, class Real, class Path>
HD bool is_shadowed(const SceneView<Real>& scene, const Surface<Path>& surface, const Vec3<Path>& to_light,
                    Real distance) {
    const Real margin = scene.limits.shadow_margin;
    const SourcedRay<Path> ray = leave(shapes_of<Path>(scene), surface, to_light, surface.from_inside);
    return find_any<shapes, ways>(scene, rebase_from_within(ray, scene.geometry.bounds), margin, distance - margin);
}

/// The light's tint after everything between the surface and `distance` along `to_light`: 0 behind an opaque primitive.
/// `interiors` are those of the ray that met the surface; only their overflow is written.
template <class Real, class Path>
HD Vec3<Real> light_arriving(const SceneView<Real>& scene, const Surface<Path>& surface, const Vec3<Path>& to_light,
                             Real distance, InteriorList& interiors) {
    const Real margin = scene.limits.shadow_margin;
    // Only an area light has places behind the horizon, and only bodies lit from both sides turn theirs to a light.
    const bool inward = glm::dot(surface.outward, to_light) < 0;
    const SourcedRay<Path> ray = leave(shapes_of<Path>(scene), surface, to_light, inward);
    // The body itself stands in the way. POV-Ray's margin is a smaller one here: its shadow cache knows the body.
    constexpr uint32_t lets_through = material_transparent | material_no_shadow;
    if (inward && ray.source.exit > Path(scene.limits.nearest) && ray.source.exit < Path(distance - margin) &&
        !(scene.surfaces.materials[surface.material].flags & lets_through))
        return Vec3<Real>(Real(0));
    const BasedRay<Real> based = rebase(ray, scene.geometry.bounds);
    Vec3<Real> light(Real(1));
    InteriorList inside;
    if (scene.has_fading)
        inside.copy_from(interiors);
    Hit<Real> passed;
    const uint32_t hidden = scene.has_no_shadow ? uint32_t(material_no_shadow) : 0u;
    for (;;) {
        const Hit<Real> hit = find_nearest(scene, based, passed, margin, distance - margin, hidden);
        if (hit.primitive == no_primitive)
            return light;
        const Surface<Path> blocker = surface_at(scene, ray, based, hit);
        const Material& material = scene.surfaces.materials[blocker.material];
        if (!(material.flags & material_transparent))
            return Vec3<Real>(Real(0));
        light *= material_transmission(scene, material, Vec3<Real>(blocker.point));
        if (scene.has_fading) {
            if (inside.contains(blocker.primitive))
                light *= attenuation(interior_of(scene, blocker.primitive), distance_passed(based, passed, hit),
                                     scene.limits.least_fade);
            inside.toggle(blocker.primitive);
            interiors.overflow |= inside.overflow;
        }
        if (max_component(light) == 0)
            return light;
        passed = hit;
    }
}

} // namespace proxima
