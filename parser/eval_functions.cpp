// SPDX-License-Identifier: Apache-2.0
// Words that stand for numbers and vectors: constants and functions.
#include "parser/evaluator.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace proxima {
namespace {

/// The functions of one number. One whose result is not finite is a mistake of the scene.
std::optional<MotionOp> function_of_one(Word word) {
    switch (word) {
    case Word::abs:
        return MotionOp::abs;
    case Word::acos:
        return MotionOp::acos;
    case Word::acosh:
        return MotionOp::acosh;
    case Word::asin:
        return MotionOp::asin;
    case Word::asinh:
        return MotionOp::asinh;
    case Word::atan:
        return MotionOp::atan;
    case Word::atanh:
        return MotionOp::atanh;
    case Word::ceil:
        return MotionOp::ceil;
    case Word::cos:
        return MotionOp::cos;
    case Word::cosh:
        return MotionOp::cosh;
    case Word::degrees:
        return MotionOp::degrees;
    case Word::exp:
        return MotionOp::exp;
    case Word::floor:
        return MotionOp::floor;
    case Word::int_:
        return MotionOp::truncate;
    case Word::ln:
        return MotionOp::ln;
    case Word::log:
        return MotionOp::log;
    case Word::radians:
        return MotionOp::radians;
    case Word::sin:
        return MotionOp::sin;
    case Word::sinh:
        return MotionOp::sinh;
    case Word::sqrt:
        return MotionOp::sqrt;
    case Word::tan:
        return MotionOp::tan;
    case Word::tanh:
        return MotionOp::tanh;
    default:
        return std::nullopt;
    }
}

/// The functions of two numbers. bitwise_* take any number of them, as min and max do.
MotionOp function_of_two(Word word) {
    switch (word) {
    case Word::atan2:
        return MotionOp::atan2;
    case Word::div:
        return MotionOp::div;
    case Word::mod:
        return MotionOp::mod;
    case Word::pow:
        return MotionOp::pow;
    case Word::max:
        return MotionOp::max;
    case Word::min:
        return MotionOp::min;
    case Word::bitwise_and:
        return MotionOp::bitwise_and;
    case Word::bitwise_or:
        return MotionOp::bitwise_or;
    default:
        return MotionOp::bitwise_xor;
    }
}

bool takes_many(Word word) {
    return word == Word::max || word == Word::min || word == Word::bitwise_and || word == Word::bitwise_or ||
           word == Word::bitwise_xor;
}

Terms unit(int index, int count) {
    Terms terms;
    terms.value[index] = 1;
    terms.count = count;
    return terms;
}

} // namespace

Terms Evaluator::word_factor(const Token& token) {
    if (token.index < uint32_t(Word::x) || token.index > uint32_t(Word::val))
        fail_unexpected("a number or a vector");
    const Word word = Word(token.index);
    advance();
    switch (word) {
    case Word::x:
        return Vec3<double>(1, 0, 0);
    case Word::y:
        return Vec3<double>(0, 1, 0);
    case Word::z:
        return Vec3<double>(0, 0, 1);
    case Word::t:
        return unit(3, 4);
    case Word::u:
        return unit(0, 2);
    case Word::v:
        return unit(1, 2);
    case Word::pi:
        return std::numbers::pi;
    case Word::clock:
        depends_on_time_ = true;
        return Varying(settings_.time.clock, graph_.time(MotionNode::Kind::clock));
    case Word::clock_on:
        return settings_.time.clock_on ? 1.0 : 0.0;
    case Word::now:
        fail(token, "Proxima does not support 'now'", "a scene must give the same picture at any time");
    case Word::version:
        return version_;
    case Word::true_:
    case Word::yes:
    case Word::on:
        return 1.0;
    case Word::false_:
    case Word::no:
    case Word::off:
        return 0.0;
    default:
        return call_function(token);
    }
}

/// The comma between two arguments.
void Evaluator::separator() {
    expect(TokenKind::comma);
}

Varying Evaluator::checked(const Token& at, const Varying& value) {
    if (!std::isfinite(value.value))
        fail(at, fmt::format("'{}' has no finite value here", spelling(at)));
    return value;
}

Terms Evaluator::call_function(const Token& token) {
    const Nesting nesting(*this);
    const Word word = Word(token.index);
    expect(TokenKind::left_paren);
    Terms result;
    if (const std::optional<MotionOp> function = function_of_one(word)) {
        result = checked(token, apply(*function, moving_number()));
    } else if (word >= Word::asc && word <= Word::val) {
        result = string_function(token);
    } else {
        switch (word) {
        case Word::rand:
            result = random_number();
            break;
        case Word::seed: {
            const double start = number();
            if (!fits_integer(start))
                fail(token, "a stream of random numbers starts from a number between -2147483648 and 2147483647");
            result = double(random_.seed(start));
            break;
        }
        case Word::select: {
            const Varying choice = moving_number();
            separator();
            const Varying negative = moving_number();
            separator();
            const Varying zero = moving_number();
            const Varying positive = accept(TokenKind::comma) ? moving_number() : zero;
            result = choose(apply(MotionOp::is_negative, choice), negative,
                            choose(apply(MotionOp::is_zero, choice), zero, positive));
            break;
        }
        case Word::defined: {
            if (peek().kind != TokenKind::name)
                fail_unexpected("a name");
            result = name_is_defined() ? 1.0 : 0.0;
            break;
        }
        case Word::dimensions:
        case Word::dimension_size:
            result = array_function(token);
            break;
        case Word::vdot:
        case Word::vlength:
        case Word::vcross:
        case Word::vnormalize:
        case Word::vrotate:
        case Word::vaxis_rotate:
            result = vector_function(token);
            break;
        default: {
            const MotionOp function = function_of_two(word);
            Varying value = moving_number();
            separator();
            value = apply(function, value, moving_number());
            while (takes_many(word) && accept(TokenKind::comma))
                value = apply(function, value, moving_number());
            result = checked(token, value);
        }
        }
    }
    expect(TokenKind::right_paren);
    return result;
}

/// A function of vectors, behind its parenthesis. Its numbers are doubles unless some follow from the time.
Terms Evaluator::vector_function(const Token& token) {
    const Word word = Word(token.index);
    const Terms first = vector_of(3, "a vector");
    Terms second;
    if (word != Word::vlength && word != Word::vnormalize) {
        separator();
        second = vector_of(3, "a vector");
    }
    const Vec3<Varying> a = first.varying_vector(), b = second.varying_vector();
    switch (word) {
    case Word::vdot:
        return glm::dot(a, b);
    case Word::vlength:
        return glm::length(a);
    case Word::vcross:
        return glm::cross(a, b);
    case Word::vnormalize: {
        const Varying length = glm::length(a);
        if (length.value == 0)
            fail(token, "a vector of length 0 has no direction");
        return a / length;
    }
    case Word::vrotate:
        return rotation(b).map.point(a);
    default: {
        separator();
        const Varying angle = moving_number();
        if (glm::length(value_of(b)) == 0)
            fail(token, "the axis has length 0");
        return rotation_about(b, angle).map.point(a);
    }
    }
}

/// The next number of the stream that is read here.
double Evaluator::random_number() {
    const Token& at = peek();
    const double stream = number();
    if (!random_.has(stream))
        fail(at, "this is no stream of random numbers", "a stream comes from seed: #declare R = seed(1);");
    ++changes_;
    return random_.next(uint32_t(stream));
}

} // namespace proxima
