// SPDX-License-Identifier: Apache-2.0
// Expressions of numbers and vectors, with POV-Ray's precedence: ?: below & and | (one level), relations (one level),
// + and -, * and /, signs and !, then .x and the like. Relations and what is below them need parentheses or a
// directive.
#include "parser/evaluator.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

/// Applies `operation` to each pair of terms, after both sides have equally many.
template <class Operation> void combine(Terms& left, Terms right, Operation operation) {
    const int count = std::max(left.count, right.count);
    left.promote(count);
    right.promote(count);
    for (int i = 0; i < count; ++i)
        left.value[i] = operation(left.value[i], right.value[i]);
}

bool compare(TokenKind relation, double a, double b) {
    constexpr double epsilon = 1e-10;
    switch (relation) {
    case TokenKind::left_angle:
        return a < b;
    case TokenKind::right_angle:
        return a > b;
    case TokenKind::less_equal:
        return a <= b + epsilon;
    case TokenKind::greater_equal:
        return a + epsilon >= b;
    case TokenKind::equal:
        return std::abs(a - b) <= epsilon;
    default:
        return std::abs(a - b) > epsilon;
    }
}

bool is_relation(TokenKind kind) {
    return kind == TokenKind::left_angle || kind == TokenKind::right_angle || kind == TokenKind::less_equal ||
           kind == TokenKind::greater_equal || kind == TokenKind::equal || kind == TokenKind::not_equal;
}

} // namespace

Terms Evaluator::expression() {
    const Nesting nesting(*this);
    Terms condition = logical();
    const Token& question = peek();
    if (question.kind != TokenKind::question)
        return condition;
    advance();
    const Terms chosen = expression();
    expect(TokenKind::colon);
    const Terms other = expression();
    if (condition.count != 1)
        fail(question, "the condition before '?' must be a number");
    return is_true(condition.value[0]) ? chosen : other;
}

Terms Evaluator::logical() {
    Terms left = relation();
    for (;;) {
        const TokenKind kind = peek().kind;
        if (kind == TokenKind::ampersand) {
            advance();
            combine(left, relation(), [](double a, double b) { return is_true(a) && is_true(b) ? 1.0 : 0.0; });
        } else if (kind == TokenKind::bar) {
            advance();
            combine(left, relation(), [](double a, double b) { return is_true(a) || is_true(b) ? 1.0 : 0.0; });
        } else {
            return left;
        }
    }
}

Terms Evaluator::relation() {
    if (starts_string())
        return Terms(string_relation() ? 1.0 : 0.0);
    Terms left = sum();
    for (;;) {
        const Token& token = peek();
        if (!is_relation(token.kind))
            return left;
        advance();
        if (token.kind == TokenKind::equal && peek().kind == TokenKind::equal)
            fail(token, "there is no operator '=='", "'=' alone compares");
        combine(left, sum(), [&](double a, double b) { return compare(token.kind, a, b) ? 1.0 : 0.0; });
    }
}

bool Evaluator::string_relation() {
    const std::string left = string();
    const TokenKind kind = peek().kind;
    if (!is_relation(kind))
        fail_unexpected("a comparison");
    advance();
    if (!starts_string())
        fail_unexpected("a string");
    return compare(kind, left.compare(string()), 0);
}

/// What may continue an expression. The value of a #declare ends at a directive unless it stands in brackets.
TokenKind Evaluator::next_operator_behind_directive() {
    while (leave_macro()) {
    }
    return nesting_ == bare_nesting_ && cursor_->kind == TokenKind::directive ? TokenKind::directive : peek().kind;
}

Terms Evaluator::sum() {
    Terms left = product();
    for (;;) {
        const TokenKind kind = next_operator();
        if (kind == TokenKind::plus) {
            advance();
            combine(left, product(), [](double a, double b) { return a + b; });
        } else if (kind == TokenKind::minus) {
            advance();
            combine(left, product(), [](double a, double b) { return a - b; });
        } else {
            return left;
        }
    }
}

Terms Evaluator::product() {
    Terms left = factor();
    for (;;) {
        const TokenKind kind = next_operator();
        const Token& token = *cursor_;
        if (kind == TokenKind::star) {
            advance();
            combine(left, factor(), [](double a, double b) { return a * b; });
        } else if (kind == TokenKind::slash) {
            advance();
            const Terms right = factor();
            // A vector is padded with zeros where the other side is longer: POV-Ray warns and goes on with infinity.
            if (std::find(right.value, right.value + right.count, 0.0) != right.value + right.count ||
                (right.count > 1 && right.count < left.count))
                fail(token, "division by zero");
            combine(left, right, [](double a, double b) { return a / b; });
        } else {
            return left;
        }
    }
}

Terms Evaluator::factor() {
    const Token& token = peek();
    switch (token.kind) {
    case TokenKind::number:
        advance();
        return Terms(token.number());
    case TokenKind::name:
        return name_factor(token);
    case TokenKind::word: {
        Terms terms = word_factor(token);
        access(terms);
        return terms;
    }
    case TokenKind::left_angle: {
        const Nesting nesting(*this);
        Terms terms = vector_literal();
        access(terms);
        return terms;
    }
    case TokenKind::left_paren: {
        advance();
        Terms terms = expression();
        expect(TokenKind::right_paren);
        access(terms);
        return terms;
    }
    case TokenKind::plus:
    case TokenKind::minus:
    case TokenKind::bang: {
        const Nesting nesting(*this);
        advance();
        Terms terms = factor();
        if (token.kind == TokenKind::minus)
            std::for_each_n(terms.value, terms.count, [](double& value) { value = -value; });
        else if (token.kind == TokenKind::bang)
            std::for_each_n(terms.value, terms.count, [](double& value) { value = is_true(value) ? 0.0 : 1.0; });
        return terms;
    }
    default:
        fail_unexpected("a number or a vector");
    }
}

Terms Evaluator::name_factor(const Token& name) {
    const Value* named = named_value(name);
    if (is_callable(named)) {
        Terms terms = call_declared(name);
        access(terms);
        return terms;
    }
    const Terms* value = named ? std::get_if<Terms>(named) : nullptr;
    if (!value)
        fail_unexpected("a number or a vector");
    Terms terms = *value;
    advance();
    access(terms);
    return terms;
}

} // namespace proxima
