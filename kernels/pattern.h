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

/// Where a place stands in a map: `part` of the way from the stop `low` to `high`, which are the same where one stop
/// alone counts.
template <class Real> struct MapPlace {
    size_t low;
    size_t high;
    Real part;
};

template <class Real> HD MapPlace<Real> map_place(std::span<const ColorStop> stops, Real place) {
    const size_t last = stops.size() - 1;
    if (place >= Real(stops[last].value))
        return {last, last, Real(0)};
    size_t above = 0;
    while (place > Real(stops[above].value))
        ++above;
    if (above == 0 || place == Real(stops[above].value))
        return {above, above, Real(0)};
    const Real low = Real(stops[above - 1].value);
    return {above - 1, above, (place - low) / (Real(stops[above].value) - low)};
}

/// The colour at a place of a colour map, whose end colours go on beyond it.
template <class Real> HD MixedColor<Real> map_color(std::span<const ColorStop> stops, Real place) {
    const MapPlace<Real> at = map_place(stops, place);
    const MixedColor<Real> a = mixed_color<Real>(stops[at.low].color);
    if (at.low == at.high)
        return a;
    const MixedColor<Real> b = mixed_color<Real>(stops[at.high].color);
    const Real rest = Real(1) - at.part;
    return {rest * a.rgb + at.part * b.rgb, rest * a.filter + at.part * b.filter,
            rest * a.transmit + at.part * b.transmit};
}

/// The stops of a pigment with a pattern.
template <class Real>
HD std::span<const ColorStop> pattern_stops(const SurfacesView<Real>& surfaces, const Pattern& pattern) {
    return surfaces.color_stops.subspan(pattern.first_stop, pattern.stop_count);
}

} // namespace proxima
