// SPDX-License-Identifier: Apache-2.0
// The operations of motion programs on numbers in double: the scene language's own, with its tolerances. The parser
// computes with them as well, so that a program gives what the script gives, bit for bit on the CPU. On a GPU the
// operations of arithmetic, sqrt, floor and the like are exact too; sin, pow and their kind may differ by 2 ulp.
#pragma once
#include "kernels/vector_math.h"

#include <cstdint>

namespace proxima {

enum class MotionOp : uint8_t {
    copy,
    pick, ///< of two operands and its result: result = left != 0 ? right : result

    // of one operand
    negate,
    logical_not,
    truth, ///< 1 when the operand counts as true, else 0
    is_zero,
    is_negative,
    single, ///< rounded to float
    abs,
    acos,
    acosh,
    asin,
    asinh,
    atan,
    atanh,
    ceil,
    cos,
    cosh,
    degrees,
    exp,
    floor,
    truncate,
    ln,
    log,
    radians,
    sin,
    sinh,
    sqrt,
    tan,
    tanh,

    // of two operands
    add,
    subtract,
    multiply,
    divide,
    atan2,
    div,
    mod,
    pow,
    max,
    min,
    bitwise_and,
    bitwise_or,
    bitwise_xor,
    less,
    greater,
    less_equal,
    greater_equal,
    equal,
    not_equal,
    logical_and,
    logical_or,
    // of the place of a spline's term in a table, and the time
    linear_spline,
    quadratic_spline,
    cubic_spline,
    natural_spline,
};

HD constexpr bool is_spline(MotionOp op) {
    return op >= MotionOp::linear_spline;
}

/// POV-Ray's tolerance of comparisons, absolute.
inline constexpr double comparison_epsilon = 1e-10;
inline constexpr double degree_in_radians = 3.141592653589793238462643383279502884 / 180;

HD constexpr bool is_true(double value) {
    return value > comparison_epsilon || value < -comparison_epsilon;
}

/// Whether POV-Ray's conversion to an integer keeps the value.
HD constexpr bool fits_integer(double x) {
    return x >= -2147483648.0 && x <= 2147483647.0;
}

HD inline double apply_bitwise(MotionOp op, double a, double b) {
    if (!fits_integer(a) || !fits_integer(b))
        return NAN;
    const int32_t i = int32_t(a), j = int32_t(b);
    return op == MotionOp::bitwise_and ? i & j : op == MotionOp::bitwise_or ? i | j : i ^ j;
}

/// The result of an operation on one or two operands (`b` is not used by those of one). What has no value is NaN or
/// infinite. Not for pick and splines.
HD inline double apply(MotionOp op, double a, double b = 0) {
    switch (op) {
    case MotionOp::negate:
        return -a;
    case MotionOp::logical_not:
        return is_true(a) ? 0.0 : 1.0;
    case MotionOp::truth:
        return is_true(a) ? 1.0 : 0.0;
    case MotionOp::is_zero:
        return a == 0 ? 1.0 : 0.0;
    case MotionOp::is_negative:
        return a < 0 ? 1.0 : 0.0;
    case MotionOp::single:
        return double(float(a));
    case MotionOp::abs:
        return ::fabs(a);
    case MotionOp::acos:
        return ::acos(a);
    case MotionOp::acosh:
        return ::acosh(a);
    case MotionOp::asin:
        return ::asin(a);
    case MotionOp::asinh:
        return ::asinh(a);
    case MotionOp::atan:
        return ::atan(a);
    case MotionOp::atanh:
        return ::atanh(a);
    case MotionOp::ceil:
        return ::ceil(a);
    case MotionOp::cos:
        return ::cos(a);
    case MotionOp::cosh:
        return ::cosh(a);
    case MotionOp::degrees:
        return a / degree_in_radians;
    case MotionOp::exp:
        return ::exp(a);
    case MotionOp::floor:
        return ::floor(a);
    case MotionOp::truncate:
        return ::trunc(a);
    case MotionOp::ln:
        return ::log(a);
    case MotionOp::log:
        return ::log10(a);
    case MotionOp::radians:
        return a * degree_in_radians;
    case MotionOp::sin:
        return ::sin(a);
    case MotionOp::sinh:
        return ::sinh(a);
    case MotionOp::sqrt:
        return ::sqrt(a);
    case MotionOp::tan:
        return ::tan(a);
    case MotionOp::tanh:
        return ::tanh(a);
    case MotionOp::add:
        return a + b;
    case MotionOp::subtract:
        return a - b;
    case MotionOp::multiply:
        return a * b;
    case MotionOp::divide:
        return a / b;
    case MotionOp::atan2:
        return a == 0 && b == 0 ? NAN : ::atan2(a, b);
    case MotionOp::div:
        return ::trunc(a / b);
    case MotionOp::mod:
        return ::fmod(a, b);
    case MotionOp::pow:
        return a == 0 && b == 0 ? NAN : ::pow(a, b);
    case MotionOp::max:
        return a < b ? b : a;
    case MotionOp::min:
        return b < a ? b : a;
    case MotionOp::bitwise_and:
    case MotionOp::bitwise_or:
    case MotionOp::bitwise_xor:
        return apply_bitwise(op, a, b);
    case MotionOp::less:
        return a < b ? 1.0 : 0.0;
    case MotionOp::greater:
        return a > b ? 1.0 : 0.0;
    case MotionOp::less_equal:
        return a <= b + comparison_epsilon ? 1.0 : 0.0;
    case MotionOp::greater_equal:
        return a + comparison_epsilon >= b ? 1.0 : 0.0;
    case MotionOp::equal:
        return ::fabs(a - b) <= comparison_epsilon ? 1.0 : 0.0;
    case MotionOp::not_equal:
        return ::fabs(a - b) > comparison_epsilon ? 1.0 : 0.0;
    case MotionOp::logical_and:
        return is_true(a) && is_true(b) ? 1.0 : 0.0;
    case MotionOp::logical_or:
        return is_true(a) || is_true(b) ? 1.0 : 0.0;
    default: // copy
        break;
    }
    return a;
}

} // namespace proxima
