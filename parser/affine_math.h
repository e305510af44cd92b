// SPDX-License-Identifier: Apache-2.0
// POV-Ray's transforms as affine maps, of doubles or of numbers that follow from the time. Angles in degrees; the
// system is left-handed.
#pragma once
#include "kernels/geometry.h"

#include <cmath>
#include <numbers>

namespace proxima {

inline bool is_constant_zero(double number) {
    return number == 0;
}

inline bool is_finite(const Vec3<double>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_finite(const Affine<double>& map) {
    return is_finite(map.linear[0]) && is_finite(map.linear[1]) && is_finite(map.linear[2]) && is_finite(map.offset);
}

inline bool is_finite(const Sphere<double>& sphere) {
    return is_finite(sphere.center) && std::isfinite(sphere.radius);
}

/// A map and its inverse, made together: scaling by 1e-9 must not cost the inverse its digits.
template <class Number> struct TransformOf {
    Affine<Number> map;
    Affine<Number> inverse;
};
using TransformPair = TransformOf<double>;

template <class Number> Affine<Number> compose(const Affine<Number>& outer, const Affine<Number>& inner) {
    return {outer.linear * inner.linear, outer.point(inner.offset)};
}

template <class Number> TransformOf<Number> then(const TransformOf<Number>& first, const TransformOf<Number>& second) {
    return {compose(second.map, first.map), compose(first.inverse, second.inverse)};
}

template <class Number> TransformOf<Number> translation(const Vec3<Number>& offset) {
    return {{Mat3<Number>(Number(1)), offset}, {Mat3<Number>(Number(1)), -offset}};
}

/// No component of `factors` is 0.
template <class Number> TransformOf<Number> scaling(const Vec3<Number>& factors) {
    TransformOf<Number> pair;
    for (int i = 0; i < 3; ++i) {
        pair.map.linear[i][i] = factors[i];
        pair.inverse.linear[i][i] = Number(1) / factors[i];
    }
    return pair;
}

/// Rodrigues' rotation formula.
template <class Number> TransformOf<Number> rotation_about(const Vec3<Number>& axis, const Number& degrees) {
    using std::cos, std::sin;
    const Number angle = degrees * Number(std::numbers::pi) / Number(180);
    const Vec3<Number> a = glm::normalize(axis);
    const Number c = cos(angle), s = sin(angle);
    Mat3<Number> m;
    for (int column = 0; column < 3; ++column) {
        Vec3<Number> unit(Number(0));
        unit[column] = Number(1);
        m[column] = c * unit + s * glm::cross(a, unit) + (Number(1) - c) * glm::dot(a, unit) * a;
    }
    return {{m, Vec3<Number>(Number(0))}, {glm::transpose(m), Vec3<Number>(Number(0))}};
}

/// About the x, y or z axis (0, 1, 2).
template <class Number> TransformOf<Number> rotation_about(int axis, const Number& degrees) {
    using std::cos, std::sin;
    const Number angle = degrees * Number(std::numbers::pi) / Number(180);
    const Number c = cos(angle), s = sin(angle);
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    TransformOf<Number> pair;
    Mat3<Number>& m = pair.map.linear;
    m[next][next] = m[last][last] = c;
    m[next][last] = s;
    m[last][next] = -s;
    pair.inverse.linear = glm::transpose(m);
    return pair;
}

/// About x, then y, then z.
template <class Number> TransformOf<Number> rotation(const Vec3<Number>& degrees) {
    TransformOf<Number> result;
    bool turned = false;
    for (int axis = 0; axis < 3; ++axis) {
        if (is_constant_zero(degrees[axis]))
            continue;
        const TransformOf<Number> turn = rotation_about(axis, degrees[axis]);
        result = turned ? then(result, turn) : turn;
        turned = true;
    }
    return result;
}

/// The map must have an inverse.
template <class Number> TransformOf<Number> from_matrix(const Affine<Number>& map) {
    const Mat3<Number> inverse = glm::inverse(map.linear);
    return {map, {inverse, -(inverse * map.offset)}};
}

} // namespace proxima
