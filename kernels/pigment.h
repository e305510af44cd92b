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

/// The colour of a pigment that is a colour or a checker, at a point of its own space.
template <class Real> HD MixedColor<Real> plain_color(const Pigment& pigment, const Vec3<Real>& point) {
    const bool second = pigment.kind == PigmentKind::checker && is_odd_checker_cell(point);
    return mixed_color<Real>(second ? pigment.second_color : pigment.color);
}

/// A point in the pigment's own space.
template <class Real>
HD Vec3<Real> pigment_point(const SurfacesView<Real>& surfaces, const Pigment& pigment, const Vec3<Real>& point) {
    return pigment.transform == Pigment::no_transform ? point : surfaces.transforms[pigment.transform].point(point);
}

/// The colour of a pigment with a pigment map at a point of its own space. Pigments whose share is not mixed in yet
/// wait on a stack.
template <class Real>
HD_RARE MixedColor<Real> pigment_map_color(const SurfacesView<Real>& surfaces, const Pigment& pigment,
                                           const Vec3<Real>& point) {
    struct Part {
        const Pigment* pigment;
        Vec3<Real> point; ///< in its space
        Real weight;
    };
    Part parts[pigment_map_depth + 1];
    parts[0] = {&pigment, point, Real(1)};
    MixedColor<Real> sum{Vec3<Real>(0), Real(0), Real(0)};
    const auto add = [&](const MixedColor<Real>& color, Real weight) {
        sum.rgb += weight * color.rgb;
        sum.filter += weight * color.filter;
        sum.transmit += weight * color.transmit;
    };
    for (int count = 1; count > 0;) {
        const Part part = parts[--count];
        if (!has_color_map(part.pigment->kind)) {
            add(plain_color(*part.pigment, part.point), part.weight);
            continue;
        }
        const Pattern& pattern = surfaces.patterns[part.pigment->pattern];
        const std::span<const ColorStop> stops = pattern_stops(surfaces, pattern);
        const Real number = pattern_number(part.pigment->kind, part.point);
        const MapPlace<Real> at = map_place(stops, wave_number(pattern, number));
        for (size_t i = at.low; i <= at.high; ++i) {
            const Real share = i == at.low ? Real(1) - at.part : at.part;
            if (stops[i].pigment == ColorStop::no_pigment) {
                add(mixed_color<Real>(stops[i].color), part.weight * share);
                continue;
            }
            const Pigment& inner = surfaces.pigments[stops[i].pigment];
            parts[count++] = {&inner, pigment_point(surfaces, inner, part.point), part.weight * share};
        }
    }
    return sum;
}

/// The colour of a pigment with a colour map or a pigment map at a point of its own space.
template <class Real>
HD_RARE MixedColor<Real> pattern_color(const SurfacesView<Real>& surfaces, const Pigment& pigment,
                                       const Vec3<Real>& point) {
    const Pattern& pattern = surfaces.patterns[pigment.pattern];
    const std::span<const ColorStop> stops = pattern_stops(surfaces, pattern);
    if (stops[0].pigment != ColorStop::no_pigment)
        return pigment_map_color(surfaces, pigment, point);
    return map_color(stops, wave_number(pattern, pattern_number(pigment.kind, point)));
}

/// A pigment's colour at a point of the world. `plain`: it is known to be a colour or a checker.
template <bool plain = false, class Real>
HD MixedColor<Real> pigment_color(const SurfacesView<Real>& surfaces, const Pigment& pigment, const Vec3<Real>& point) {
    if (pigment.kind == PigmentKind::solid)
        return mixed_color<Real>(pigment.color);
    const Vec3<Real> seen = pigment_point(surfaces, pigment, point);
    if constexpr (!plain)
        if (pigment.kind != PigmentKind::checker)
            return pattern_color(surfaces, pigment, seen);
    return plain_color(pigment, seen);
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
