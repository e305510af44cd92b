// SPDX-License-Identifier: Apache-2.0
// A number that may follow from the time: its value now, and the node of a MotionGraph that says how it was computed.
// The operators compute the value as those of double do, and record what they did when an operand has a node.
#pragma once
#include "kernels/motion_ops.h"

#include <cstdint>
#include <limits>

namespace proxima {

using NodeId = uint32_t; ///< of a MotionGraph; 0 is none: a constant

struct Varying {
    double value;
    NodeId node;

    Varying() = default; // trivial: vectors of GLM hold their components in unions
    constexpr Varying(double number, NodeId node = 0) : value(number), node(node) {}

    Varying& operator+=(const Varying& other);
    Varying& operator-=(const Varying& other);
    Varying& operator*=(const Varying& other);
    Varying& operator/=(const Varying& other);
};

/// The node of an operation, one of whose operands has a node; in the graph that is recorded in this thread. 0 when
/// none is.
NodeId recorded(MotionOp op, const Varying& a);
NodeId recorded(MotionOp op, const Varying& a, const Varying& b);

inline Varying apply(MotionOp op, const Varying& a) {
    return {apply(op, a.value), a.node ? recorded(op, a) : 0};
}
inline Varying apply(MotionOp op, const Varying& a, const Varying& b) {
    return {apply(op, a.value, b.value), (a.node | b.node) ? recorded(op, a, b) : 0};
}
/// `chosen` where the condition is true, else `other`.
Varying choose(const Varying& condition, const Varying& chosen, const Varying& other);

inline Varying operator+(const Varying& a, const Varying& b) {
    return apply(MotionOp::add, a, b);
}
inline Varying operator-(const Varying& a, const Varying& b) {
    return apply(MotionOp::subtract, a, b);
}
inline Varying operator*(const Varying& a, const Varying& b) {
    return apply(MotionOp::multiply, a, b);
}
inline Varying operator/(const Varying& a, const Varying& b) {
    return apply(MotionOp::divide, a, b);
}
inline Varying operator+(const Varying& a) {
    return a;
}
inline Varying operator-(const Varying& a) {
    return apply(MotionOp::negate, a);
}
inline Varying& Varying::operator+=(const Varying& other) {
    return *this = *this + other;
}
inline Varying& Varying::operator-=(const Varying& other) {
    return *this = *this - other;
}
inline Varying& Varying::operator*=(const Varying& other) {
    return *this = *this * other;
}
inline Varying& Varying::operator/=(const Varying& other) {
    return *this = *this / other;
}

// Found by templates over double and Varying.
inline Varying sqrt(const Varying& a) {
    return apply(MotionOp::sqrt, a);
}
inline Varying sin(const Varying& a) {
    return apply(MotionOp::sin, a);
}
inline Varying cos(const Varying& a) {
    return apply(MotionOp::cos, a);
}
inline Varying tan(const Varying& a) {
    return apply(MotionOp::tan, a);
}

/// Values without their nodes.
inline double value_of(const Varying& v) {
    return v.value;
}
inline Vec3<double> value_of(const Vec3<Varying>& v) {
    return {v.x.value, v.y.value, v.z.value};
}
inline Affine<double> value_of(const Affine<Varying>& a) {
    return {Mat3<double>(value_of(a.linear[0]), value_of(a.linear[1]), value_of(a.linear[2])), value_of(a.offset)};
}
inline Affine<Varying> varying(const Affine<double>& a) {
    return {Mat3<Varying>(a.linear), Vec3<Varying>(a.offset)};
}
inline bool is_constant_zero(const Varying& v) {
    return v.node == 0 && v.value == 0;
}
inline bool moves(const Vec3<Varying>& v) {
    return (v.x.node | v.y.node | v.z.node) != 0;
}
inline bool moves(const Affine<Varying>& a) {
    return moves(a.linear[0]) || moves(a.linear[1]) || moves(a.linear[2]) || moves(a.offset);
}

} // namespace proxima

/// GLM asks whether its functions make sense for a type of numbers.
template <> class std::numeric_limits<proxima::Varying> : public std::numeric_limits<double> {};
