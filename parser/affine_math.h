// SPDX-License-Identifier: Apache-2.0
// POV-Ray's transforms as affine maps in double. Angles in degrees; the system is left-handed.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// A map and its inverse, made together: scaling by 1e-9 must not cost the inverse its digits.
struct TransformPair {
    Affine<double> map;
    Affine<double> inverse;
};

Affine<double> compose(const Affine<double>& outer, const Affine<double>& inner);
TransformPair then(const TransformPair& first, const TransformPair& second);
TransformPair inverse_of(const TransformPair& pair);

TransformPair translation(const Vec3<double>& offset);
/// About x, then y, then z.
TransformPair rotation(const Vec3<double>& degrees);
TransformPair rotation_about(const Vec3<double>& axis, double degrees);
/// No component of `factors` is 0.
TransformPair scaling(const Vec3<double>& factors);
/// Not invertible when the determinant is 0; `ok` says so.
TransformPair from_matrix(const Affine<double>& map, bool& ok);

} // namespace proxima
