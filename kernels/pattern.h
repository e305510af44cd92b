// SPDX-License-Identifier: Apache-2.0
// Patterns with a colour map: a point in, a number out; the number in, a colour out. Formulas of POV-Ray 3.7.
#pragma once
#include "kernels/scene_view.h"

namespace proxima {

/// A colour in the arithmetic of the frame.
template <class Real> struct MixedColor {
    Vec3<Real> rgb;
    Real filter;
    Real transmit;
};

template <class Real> HD MixedColor<Real> mixed_color(const PigmentColor& color) {
    return {Vec3<Real>(color.rgb), Real(color.filter), Real(color.transmit)};
}

/// The number of a pattern at a point of its own space.
template <class Real> HD Real pattern_number(PigmentKind kind, const Vec3<Real>& p) {
    const auto inward = [](Real distance) { return larger(Real(1) - distance, Real(0)); };
    switch (kind) {
    case PigmentKind::gradient:
        return p.x > 1 ? modulo(p.x, Real(1)) : p.x;
    case PigmentKind::radial:
        return magnitude(p.x) < Real(0.001) && magnitude(p.z) < Real(0.001)
                   ? Real(0.25)
                   : Real(0.75) + arc_tangent(p.x, p.z) / Real(6.28318530717958647693);
    case PigmentKind::spherical:
        return inward(glm::length(p));
    case PigmentKind::planar:
        return inward(magnitude(p.y));
    case PigmentKind::cylindrical:
        return inward(square_root(p.x * p.x + p.z * p.z));
    case PigmentKind::boxed:
        return inward(larger(magnitude(p.x), larger(magnitude(p.y), magnitude(p.z))));
    case PigmentKind::onion:
        return modulo(glm::length(p), Real(1));
    case PigmentKind::leopard: {
        const Real mean = (sine(p.x) + sine(p.y) + sine(p.z)) / Real(3);
        return mean * mean;
    }
    default: // the others have no colour map
        return Real(0);
    }
}

/// A pattern's number as a place in its colour map.
template <class Real> HD Real wave_number(const Pattern& pattern, Real number) {
    constexpr Real pi = Real(3.14159265358979323846);
    if (pattern.frequency != 0) // the odd divisor is POV-Ray's
        number = modulo(number * Real(pattern.frequency) + Real(pattern.phase), Real(1.00001));
    if (number < 0)
        number -= round_down(number);
    switch (pattern.wave) {
    case Wave::ramp:
        break;
    case Wave::sine:
        return (Real(1) + sine((number - round_down(number)) * 2 * pi)) * Real(0.5);
    case Wave::triangle: {
        const Real offset = number - round_down(number);
        return Real(2) * (offset >= Real(0.5) ? Real(1) - offset : offset);
    }
    case Wave::scallop:
        return magnitude(sine(number * pi));
    case Wave::cubic:
        return number * number * (Real(3) - Real(2) * number);
    case Wave::poly:
        return power(number, Real(pattern.exponent));
    }
    return number;
}

/// The colour at a place of a colour map, whose end colours go on beyond it.
template <class Real> HD MixedColor<Real> map_color(std::span<const ColorStop> stops, Real place) {
    const size_t last = stops.size() - 1;
    if (place >= Real(stops[last].value))
        return mixed_color<Real>(stops[last].color);
    size_t above = 0;
    while (place > Real(stops[above].value))
        ++above;
    const ColorStop& high = stops[above];
    if (above == 0 || place == Real(high.value))
        return mixed_color<Real>(high.color);
    const ColorStop& low = stops[above - 1];
    const Real part = (place - Real(low.value)) / (Real(high.value) - Real(low.value));
    const MixedColor<Real> a = mixed_color<Real>(low.color), b = mixed_color<Real>(high.color);
    const Real rest = Real(1) - part;
    return {rest * a.rgb + part * b.rgb, rest * a.filter + part * b.filter, rest * a.transmit + part * b.transmit};
}

/// The colour of a pigment with a colour map at a point of its own space.
template <class Real>
HD_RARE MixedColor<Real> pattern_color(const SurfacesView<Real>& surfaces, const Pigment& pigment,
                                       const Vec3<Real>& point) {
    const Pattern& pattern = surfaces.patterns[pigment.pattern];
    const Real place = wave_number(pattern, pattern_number(pigment.kind, point));
    return map_color(surfaces.color_stops.subspan(pattern.first_stop, pattern.stop_count), place);
}

} // namespace proxima
