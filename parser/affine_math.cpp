// SPDX-License-Identifier: Apache-2.0
#include "parser/affine_math.h"

#include <cmath>
#include <numbers>

namespace proxima {

Affine<double> compose(const Affine<double>& outer, const Affine<double>& inner) {
    return {outer.linear * inner.linear, outer.point(inner.offset)};
}

TransformPair then(const TransformPair& first, const TransformPair& second) {
    return {compose(second.map, first.map), compose(first.inverse, second.inverse)};
}

TransformPair inverse_of(const TransformPair& pair) {
    return {pair.inverse, pair.map};
}

TransformPair translation(const Vec3<double>& offset) {
    return {{Mat3<double>(1), offset}, {Mat3<double>(1), -offset}};
}

/// Rodrigues' rotation formula.
TransformPair rotation_about(const Vec3<double>& axis, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3<double> a = glm::normalize(axis);
    const double c = std::cos(angle), s = std::sin(angle);
    Mat3<double> m;
    for (int column = 0; column < 3; ++column) {
        Vec3<double> unit(0);
        unit[column] = 1;
        m[column] = c * unit + s * glm::cross(a, unit) + (1 - c) * glm::dot(a, unit) * a;
    }
    return {{m, Vec3<double>(0)}, {glm::transpose(m), Vec3<double>(0)}};
}

TransformPair rotation(const Vec3<double>& degrees) {
    const TransformPair x = rotation_about({1, 0, 0}, degrees.x);
    const TransformPair y = rotation_about({0, 1, 0}, degrees.y);
    const TransformPair z = rotation_about({0, 0, 1}, degrees.z);
    return then(then(x, y), z);
}

TransformPair scaling(const Vec3<double>& factors) {
    TransformPair pair;
    for (int i = 0; i < 3; ++i) {
        pair.map.linear[i][i] = factors[i];
        pair.inverse.linear[i][i] = 1 / factors[i];
    }
    return pair;
}

TransformPair from_matrix(const Affine<double>& map, bool& ok) {
    const double determinant = glm::determinant(map.linear);
    ok = std::isfinite(determinant) && determinant != 0;
    const Mat3<double> inverse = ok ? glm::inverse(map.linear) : Mat3<double>(1);
    return {map, {inverse, -(inverse * map.offset)}};
}

} // namespace proxima
