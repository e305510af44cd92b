// SPDX-License-Identifier: Apache-2.0
// The layers of a surface under one ray, from the top one down as far as something shows through: what they emit, send
// back of a light, reflect, and let through together.
#pragma once
#include "kernels/interiors.h"
#include "kernels/shading.h"

namespace proxima {

/// `plain`: all pigments are colours or checkers.
template <class Real, bool plain> struct LayerStack {
    const SceneView<Real>& scene;
    const Surface<Real>& surface;
    Real cosine; ///< between the normal and the direction back along the ray
    Real ior;    ///< of the far side over the near side

    HD Reflection<Real> reflection(const Finish& finish, const LayerColor<Real>& color) const {
        return reflection_of(finish, color.rgb, cosine, ior);
    }

    /// Calls visit(finish, colour, the product of the transmissions above) for each layer; returns the product of all.
    template <class Visit> HD Vec3<Real> for_each(const Visit& visit) const {
        const SurfacesView<Real>& surfaces = scene.surfaces;
        const Material& material = surfaces.materials[surface.material];
        Vec3<Real> above(Real(1));
        for (uint32_t i = material.layer_count; i-- > 0;) {
            const Layer& layer = surfaces.layers[material.first_layer + i];
            const Finish& finish = surfaces.finishes[layer.finish];
            const LayerColor<Real> color =
                layer_color<plain>(surfaces, surfaces.pigments[layer.pigment], surface.point);
            visit(finish, color, above);
            above *= color.transmission;
            if (finish.conserve_energy && (material.flags & material_reflective)) {
                const Vec3<Real> reflected = reflection(finish, color).color;
                for (int c = 0; c < 3; ++c)
                    above[c] *= smaller(Real(1) - reflected[c], Real(1));
            }
            if (!(magnitude(grey(above)) > Real(scene.adc_bailout)))
                break;
        }
        return above;
    }

    HD Vec3<Real> transmission() const {
        return for_each([](const Finish&, const LayerColor<Real>&, const Vec3<Real>&) {});
    }

    /// What the layers send out without any light source.
    HD Vec3<Real> glow() const {
        Vec3<Real> sum(Real(0));
        for_each([&](const Finish& finish, const LayerColor<Real>& color, const Vec3<Real>& above) {
            const Vec3<Real> strength =
                Vec3<Real>(finish.ambient) * Vec3<Real>(scene.ambient_light) + Vec3<Real>(finish.emission);
            sum += above * color.rgb * strength * color.opacity;
        });
        return sum;
    }

    /// What the layers send back of a light.
    HD Vec3<Real> reflected(const LightGeometry<Real>& geometry, const Vec3<Real>& light, bool highlights) const {
        Vec3<Real> sum(Real(0));
        for_each([&](const Finish& finish, const LayerColor<Real>& color, const Vec3<Real>& above) {
            sum += above * reflected_light(finish, color, geometry, light, highlights);
        });
        return sum;
    }
};

} // namespace proxima
