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

#include <cmath>
#include <limits>

namespace proxima {

template <class Real> using Vec3 = glm::vec<3, Real, glm::defaultp>;
template <class Real> using Vec4 = glm::vec<4, Real, glm::defaultp>;
template <class Real> using Mat3 = glm::mat<3, 3, Real, glm::defaultp>;

template <class Real> inline constexpr Real infinity = std::numeric_limits<Real>::infinity();

// The scalar functions that kernels use, under one name for either precision and either compiler.
template <class Real> HD Real smaller(Real a, Real b) {
    return b < a ? b : a;
}
template <class Real> HD Real larger(Real a, Real b) {
    return a < b ? b : a;
}
/// The same for what is never NaN: one instruction on a device.
template <class Real> HD_INNER Real lesser(Real a, Real b) {
#if defined(__CUDA_ARCH__)
    return ::fmin(a, b);
#else
    return b < a ? b : a;
#endif
}
/// `low` for a NaN, so that what indexes arrays stays in them.
template <class Real> HD Real clamped(Real v, Real low, Real high) {
    return smaller(larger(low, v), high);
}
HD inline float power(float base, float exponent) {
    return ::powf(base, exponent);
}
HD inline double power(double base, double exponent) {
    return ::pow(base, exponent);
}
HD inline float exponential(float v) {
    return ::expf(v);
}
HD inline double exponential(double v) {
    return ::exp(v);
}
HD inline float arc_cosine(float v) {
    return ::acosf(v);
}
HD inline double arc_cosine(double v) {
    return ::acos(v);
}
HD inline float arc_tangent(float v) {
    return ::atanf(v);
}
HD inline double arc_tangent(double v) {
    return ::atan(v);
}
HD inline float arc_tangent(float y, float x) {
    return ::atan2f(y, x);
}
HD inline double arc_tangent(double y, double x) {
    return ::atan2(y, x);
}
HD inline float sine(float v) {
    return ::sinf(v);
}
HD inline double sine(double v) {
    return ::sin(v);
}
HD inline float cosine(float v) {
    return ::cosf(v);
}
HD inline double cosine(double v) {
    return ::cos(v);
}
/// What is left of `v` after whole multiples of `divisor`, with the sign of `v`.
HD inline float modulo(float v, float divisor) {
    return ::fmodf(v, divisor);
}
HD inline double modulo(double v, double divisor) {
    return ::fmod(v, divisor);
}
HD inline float square_root(float v) {
    return ::sqrtf(v);
}
HD inline double square_root(double v) {
    return ::sqrt(v);
}
HD inline float round_down(float v) {
    return ::floorf(v);
}
HD inline double round_down(double v) {
    return ::floor(v);
}
HD inline float magnitude(float v) {
    return ::fabsf(v);
}
HD inline double magnitude(double v) {
    return ::fabs(v);
}
HD inline float just_below(float v) {
    return ::nextafterf(v, -infinity<float>);
}
HD inline double just_below(double v) {
    return ::nextafter(v, -infinity<double>);
}

template <class Real> HD Real max_component(const Vec3<Real>& v) {
    return larger(larger(v.x, v.y), v.z);
}

/// A vector's direction; 0 where its square vanishes or is too large for Real, and never a NaN.
template <class Real> HD Vec3<Real> direction_of(const Vec3<Real>& v) {
    return glm::dot(v, v) > 0 ? glm::normalize(v) : Vec3<Real>(Real(0));
}

/// POV-Ray's weights of a colour's channels.
template <class Real> HD Real grey(const Vec3<Real>& c) {
    return Real(0.297) * c.x + Real(0.589) * c.y + Real(0.114) * c.z;
}

/// An affine map of points: p -> linear * p + offset.
template <class Real> struct Affine {
    Mat3<Real> linear{Real(1)};
    Vec3<Real> offset{Real(0)};

    HD Vec3<Real> point(const Vec3<Real>& p) const { return linear * p + offset; }
    HD Vec3<Real> direction(const Vec3<Real>& d) const { return linear * d; }
    /// Maps a surface normal backwards: with `this` the object <- world map, the result is the (unnormalised) world
    /// normal.
    HD Vec3<Real> normal_to_source(const Vec3<Real>& n) const { return n * linear; }
};

} // namespace proxima
