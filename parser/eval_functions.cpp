// SPDX-License-Identifier: Apache-2.0
// Words that stand for numbers and vectors: constants and functions.
#include "parser/evaluator.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace proxima {
namespace {

using Function = double (*)(double);

constexpr double radian = std::numbers::pi / 180;

/// The functions of one number. One whose result is not finite is a mistake of the scene.
Function function_of_one(Word word) {
    switch (word) {
    case Word::abs:
        return std::fabs;
    case Word::acos:
        return std::acos;
    case Word::acosh:
        return std::acosh;
    case Word::asin:
        return std::asin;
    case Word::asinh:
        return std::asinh;
    case Word::atan:
        return std::atan;
    case Word::atanh:
        return std::atanh;
    case Word::ceil:
        return std::ceil;
    case Word::cos:
        return std::cos;
    case Word::cosh:
        return std::cosh;
    case Word::degrees:
        return [](double x) { return x / radian; };
    case Word::exp:
        return std::exp;
    case Word::floor:
        return std::floor;
    case Word::int_:
        return std::trunc;
    case Word::ln:
        return std::log;
    case Word::log:
        return std::log10;
    case Word::radians:
        return [](double x) { return x * radian; };
    case Word::sin:
        return std::sin;
    case Word::sinh:
        return std::sinh;
    case Word::sqrt:
        return std::sqrt;
    case Word::tan:
        return std::tan;
    case Word::tanh:
        return std::tanh;
    default:
        return nullptr;
    }
}

double bitwise(Word word, double a, double b) {
    if (!fits_integer(a) || !fits_integer(b))
        return NAN;
    const int32_t i = int32_t(a), j = int32_t(b);
    return word == Word::bitwise_and ? i & j : word == Word::bitwise_or ? i | j : i ^ j;
}

/// The functions of two numbers. bitwise_* take any number of them, as min and max do.
double function_of_two(Word word, double a, double b) {
    switch (word) {
    case Word::atan2:
        return a == 0 && b == 0 ? NAN : std::atan2(a, b);
    case Word::div:
        return std::trunc(a / b);
    case Word::mod:
        return std::fmod(a, b);
    case Word::pow:
        return a == 0 && b == 0 ? NAN : std::pow(a, b);
    case Word::max:
        return std::max(a, b);
    case Word::min:
        return std::min(a, b);
    default:
        return bitwise(word, a, b);
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
        return settings_.time.clock;
    case Word::clock_on:
        depends_on_time_ = true;
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

double Evaluator::checked(const Token& at, double value) {
    if (!std::isfinite(value))
        fail(at, fmt::format("'{}' has no finite value here", spelling(at)));
    return value;
}

Terms Evaluator::call_function(const Token& token) {
    const Nesting nesting(*this);
    const Word word = Word(token.index);
    expect(TokenKind::left_paren);
    Terms result;
    if (const Function function = function_of_one(word)) {
        result = checked(token, function(argument()));
    } else if (word >= Word::asc && word <= Word::val) {
        result = string_function(token);
    } else {
        switch (word) {
        case Word::rand:
            result = random_number();
            break;
        case Word::seed: {
            const double start = argument();
            if (!fits_integer(start))
                fail(token, "a stream of random numbers starts from a number between -2147483648 and 2147483647");
            result = double(random_.seed(start));
            break;
        }
        case Word::select: {
            const double choice = argument();
            separator();
            const double negative = argument();
            separator();
            const double zero = argument();
            const double positive = accept(TokenKind::comma) ? argument() : zero;
            result = choice < 0 ? negative : choice == 0 ? zero : positive;
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
        case Word::vdot: {
            const Vec3<double> a = vector();
            separator();
            result = glm::dot(a, vector());
            break;
        }
        case Word::vlength:
            result = glm::length(vector());
            break;
        case Word::vcross: {
            const Vec3<double> a = vector();
            separator();
            result = glm::cross(a, vector());
            break;
        }
        case Word::vnormalize: {
            const Vec3<double> a = vector();
            const double length = glm::length(a);
            if (length == 0)
                fail(token, "a vector of length 0 has no direction");
            result = a / length;
            break;
        }
        case Word::vrotate: {
            const Vec3<double> a = vector();
            separator();
            result = rotation(vector()).map.point(a);
            break;
        }
        case Word::vaxis_rotate: {
            const Vec3<double> a = vector();
            separator();
            const Vec3<double> axis = vector();
            separator();
            const double angle = argument();
            if (glm::length(axis) == 0)
                fail(token, "the axis has length 0");
            result = rotation_about(axis, angle).map.point(a);
            break;
        }
        default: {
            double value = argument();
            separator();
            value = function_of_two(word, value, argument());
            while (takes_many(word) && accept(TokenKind::comma))
                value = function_of_two(word, value, argument());
            result = checked(token, value);
        }
        }
    }
    expect(TokenKind::right_paren);
    return result;
}

/// The next number of the stream that is read here.
double Evaluator::random_number() {
    const Token& at = peek();
    const double stream = argument();
    if (!random_.has(stream))
        fail(at, "this is no stream of random numbers", "a stream comes from seed: #declare R = seed(1);");
    ++changes_;
    return random_.next(uint32_t(stream));
}

double Evaluator::argument() {
    return number();
}

} // namespace proxima
