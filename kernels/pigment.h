// SPDX-License-Identifier: Apache-2.0
// A place in, the colour and the transparency of a layer there out. Formulas of POV-Ray 3.7.
#pragma once
#include "kernels/pattern.h"

namespace proxima {

/// A layer's colour in the arithmetic of the frame.
template <class Real> struct LayerColor {
    Vec3<Real> rgb;
    Vec3<Real> transmission; ///< what of the light behind comes through
    Real opacity;            ///< scales ambient, emission and diffuse
};

/// Whether a point lies in a cell of the second colour. The small shift keeps a surface that lies on the cells' faces
/// in one piece; POV-Ray's is 1e-10, which single precision cannot resolve.
template <class Real> HD bool is_odd_checker_cell(const Vec3<Real>& p) {
    const Real reach = larger(larger(magnitude(p.x), magnitude(p.y)), magnitude(p.z));
    const Real shift = Real(1e-10) + Real(4) * std::numeric_limits<Real>::epsilon() * reach;
    const Real cells = round_down(p.x + shift) + round_down(p.y + shift) + round_down(p.z + shift);
    return cells - Real(2) * round_down(cells / Real(2)) != 0;
}

/// A pigment's colour at a point of the world. `plain`: it is known to be a colour or a checker.
template <bool plain = false, class Real>
HD MixedColor<Real> pigment_color(const SurfacesView<Real>& surfaces, const Pigment& pigment, const Vec3<Real>& point) {
    if (pigment.kind == PigmentKind::solid)
        return mixed_color<Real>(pigment.color);
    const bool moved = pigment.transform != Pigment::no_transform;
    const Vec3<Real> seen = moved ? surfaces.transforms[pigment.transform].point(point) : point;
    if constexpr (!plain)
        if (pigment.kind != PigmentKind::checker)
            return pattern_color(surfaces, pigment, seen);
    return mixed_color<Real>(is_odd_checker_cell(seen) ? pigment.second_color : pigment.color);
}

template <bool plain = false, class Real>
HD LayerColor<Real> layer_color(const SurfacesView<Real>& surfaces, const Pigment& pigment, const Vec3<Real>& point) {
    const MixedColor<Real> color = pigment_color<plain>(surfaces, pigment, point);
    LayerColor<Real> layer;
    layer.rgb = color.rgb;
    layer.transmission = layer.rgb * color.filter + Vec3<Real>(color.transmit);
    layer.opacity = surfaces.legacy_transparency ? Real(1) - (color.filter * max_component(layer.rgb) + color.transmit)
                                                 : Real(1) - color.filter - color.transmit;
    return layer;
}

} // namespace proxima
