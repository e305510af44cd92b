// SPDX-License-Identifier: Apache-2.0
// The only include of GLM, with the vectors and the affine map that every kernel uses.
// Vectors are columns; a point is mapped as linear * p + offset.
#pragma once
#include "kernels/platform.h"

#if defined(__CUDACC__)
#pragma nv_diagnostic push
#pragma nv_diag_suppress 20012 // GLM 0.9.9 marks defaulted members __host__ __device__
#endif
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#if defined(__CUDACC__)
#pragma nv_diagnostic pop
#endif

namespace proxima {

template <class Real> using Vec3 = glm::vec<3, Real, glm::defaultp>;
template <class Real> using Vec4 = glm::vec<4, Real, glm::defaultp>;
template <class Real> using Mat3 = glm::mat<3, 3, Real, glm::defaultp>;

/// An affine map of points: p -> linear * p + offset.
template <class Real> struct Affine {
    Mat3<Real> linear{Real(1)};
    Vec3<Real> offset{Real(0)};

    HD Vec3<Real> point(const Vec3<Real>& p) const { return linear * p + offset; }
    HD Vec3<Real> direction(const Vec3<Real>& d) const { return linear * d; }
    /// Maps a surface normal backwards: with `this` the object <- world map, the result is the (unnormalised) world normal.
    HD Vec3<Real> normal_to_source(const Vec3<Real>& n) const { return n * linear; }
};

} // namespace proxima
