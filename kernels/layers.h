// SPDX-License-Identifier: Apache-2.0
// The layers of a surface under one ray, from the top one down as far as something shows through: what they emit, send
// back of a light, reflect, and let through together.
#pragma once
#include "kernels/interiors.h"
#include "kernels/shading.h"

namespace proxima {

/// `plain`: all pigments are colours or checkers. The top layer is looked up once, since it is mostly the only one and
/// every light asks for it.
template <class Real, bool plain> class LayerStack {
public:
    const SceneView<Real>& scene;
    const Surface<Real>& surface;

    /// `cosine`: between the normal and the direction back along the ray; `ior`: of the far side over the near side.
    HD LayerStack(const SceneView<Real>& scene, const Surface<Real>& surface, Real cosine, Real ior)
        : scene(scene), surface(surface), cosine_(cosine), ior_(ior),
          material_(scene.surfaces.materials[surface.material]) {
        if (material_.layer_count > 0)
            top_ = layer(material_.layer_count - 1);
    }

    HD Reflection<Real> reflection(const Finish& finish, const LayerColor<Real>& color) const {
        return reflection_of(finish, color.rgb, cosine_, ior_);
    }

    /// Calls visit(finish, colour, the product of the transmissions above) for each layer that shows.
    template <class Visit> HD void for_each(const Visit& visit) const {
        if (material_.layer_count == 0)
            return;
        Vec3<Real> above(Real(1));
        visit(*top_.finish, top_.color, above);
        if (material_.layer_count > 1)
            for_each_below(above, visit);
    }

    /// The product of the transmissions of all layers that show.
    HD Vec3<Real> transmission() const {
        Vec3<Real> through(Real(1));
        for_each([&](const Finish& finish, const LayerColor<Real>& color, const Vec3<Real>&) {
            attenuate(through, finish, color);
        });
        return through;
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

private:
    struct LayerLook {
        const Finish* finish;
        LayerColor<Real> color;
    };

    HD LayerLook layer(uint32_t index) const {
        const SurfacesView<Real>& surfaces = scene.surfaces;
        const Layer& layer = surfaces.layers[material_.first_layer + index];
        return {&surfaces.finishes[layer.finish],
                layer_color<plain>(surfaces, surfaces.pigments[layer.pigment], surface.point)};
    }
    HD void attenuate(Vec3<Real>& above, const Finish& finish, const LayerColor<Real>& color) const {
        above *= color.transmission;
        if (finish.conserve_energy && (material_.flags & material_reflective)) {
            const Vec3<Real> reflected = reflection(finish, color).color;
            for (int c = 0; c < 3; ++c)
                above[c] *= smaller(Real(1) - reflected[c], Real(1));
        }
    }
    template <class Visit> HD void for_each_below(Vec3<Real> above, const Visit& visit) const {
        attenuate(above, *top_.finish, top_.color);
        for (uint32_t i = material_.layer_count - 1; i-- > 0 && magnitude(grey(above)) > Real(scene.adc_bailout);) {
            const LayerLook look = layer(i);
            visit(*look.finish, look.color, above);
            attenuate(above, *look.finish, look.color);
        }
    }

    Real cosine_;
    Real ior_;
    const Material& material_;
    LayerLook top_;
};

} // namespace proxima
