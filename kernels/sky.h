// SPDX-License-Identifier: Apache-2.0
// What a ray sees that meets nothing: the pigments of the sky sphere, the last one in front, and the background.
#pragma once
#include "kernels/pigment.h"

namespace proxima {

/// A pigment that lets light through shows those behind it, as the layers of a texture do. Before version 3.7, POV-Ray
/// multiplied the filters and the colours of all pigments apart from each other.
template <class Real> HD_RARE Vec3<Real> sky_sphere_light(const SceneView<Real>& scene, const Vec3<Real>& direction) {
    const SurfacesView<Real>& surfaces = scene.surfaces;
    Vec3<Real> sum(Real(0)), above(Real(1)), tint(Real(1));
    Real filter(1), transmit(1), passed(1);
    for (size_t i = scene.sky_pigments.size(); i-- > 0;) {
        const Pigment& pigment = surfaces.pigments[scene.sky_pigments[i]];
        const MixedColor<Real> color = pigment_color(surfaces, pigment, direction);
        const Real opacity = Real(1) - color.filter - color.transmit;
        if (surfaces.legacy_transparency) {
            sum += color.rgb * (passed * opacity);
            tint *= color.rgb;
            filter *= color.filter;
            transmit *= color.transmit;
            passed = magnitude(filter) + magnitude(transmit);
            above = tint * filter + Vec3<Real>(transmit);
        } else {
            sum += color.rgb * opacity * above;
            above *= color.rgb * color.filter + Vec3<Real>(color.transmit);
        }
    }
    return sum * Vec3<Real>(scene.sky_emission) + Vec3<Real>(scene.background) * above;
}

template <class Real> HD Vec3<Real> sky_light(const SceneView<Real>& scene, const Vec3<Real>& direction) {
    return scene.sky_pigments.empty() ? Vec3<Real>(scene.background) : sky_sphere_light(scene, direction);
}

} // namespace proxima
