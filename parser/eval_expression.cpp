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

/// The terms of which `term(i)` is the i-th.
template <class Term> Terms terms_of(int count, Term term) {
    Varying terms[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
    for (int i = 0; i < count; ++i)
        terms[i] = term(i);
    return Terms({terms[0], terms[1], terms[2], terms[3], terms[4]}, count);
}

void combine_moving(MotionOp op, Terms& left, const Terms& right) {
    left = terms_of(left.count, [&](int i) { return apply(op, left.term(i), right.term(i)); });
}

/// Applies an operation to each pair of terms, after both sides have equally many. Not part of its callers: most of
/// their calls find no operator, and would save registers for it.
template <MotionOp op> [[gnu::noinline]] void combine(Terms& left, Terms right) {
    const int count = std::max(left.count, right.count);
    left.promote(count);
    right.promote(count);
    if ((left.nodes | right.nodes) != 0) [[unlikely]]
        return combine_moving(op, left, right);
    for (int i = 0; i < count; ++i)
        left.value[i] = apply(op, left.value[i], right.value[i]);
}

/// Applies an operation to each term.
template <MotionOp op> void change(Terms& terms) {
    if (terms.nodes) [[unlikely]]
        terms = terms_of(terms.count, [&](int i) { return apply(op, terms.term(i)); });
    else
        std::for_each_n(terms.value, terms.count, [](double& value) { value = apply(op, value); });
}

void compare(TokenKind relation, Terms& left, const Terms& right) {
    switch (relation) {
    case TokenKind::left_angle:
        return combine<MotionOp::less>(left, right);
    case TokenKind::right_angle:
        return combine<MotionOp::greater>(left, right);
    case TokenKind::less_equal:
        return combine<MotionOp::less_equal>(left, right);
    case TokenKind::greater_equal:
        return combine<MotionOp::greater_equal>(left, right);
    case TokenKind::equal:
        return combine<MotionOp::equal>(left, right);
    default:
        return combine<MotionOp::not_equal>(left, right);
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
    if (!condition.nodes)
        return is_true(condition.value[0]) ? chosen : other;
    if (chosen.count != other.count) {
        look_at(span(question), question, condition.nodes);
        return is_true(condition.value[0]) ? chosen : other;
    }
    return terms_of(chosen.count, [&](int i) { return choose(condition.term(0), chosen.term(i), other.term(i)); });
}

Terms Evaluator::logical() {
    Terms left = relation();
    for (;;) {
        const TokenKind kind = peek().kind;
        if (kind == TokenKind::ampersand) {
            advance();
            combine<MotionOp::logical_and>(left, relation());
        } else if (kind == TokenKind::bar) {
            advance();
            combine<MotionOp::logical_or>(left, relation());
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
        compare(token.kind, left, sum());
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
    Terms order(double(left.compare(string())));
    compare(kind, order, 0.0);
    return order.value[0] != 0;
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
            combine<MotionOp::add>(left, product());
        } else if (kind == TokenKind::minus) {
            advance();
            combine<MotionOp::subtract>(left, product());
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
            combine<MotionOp::multiply>(left, factor());
        } else if (kind == TokenKind::slash) {
            advance();
            const Terms right = factor();
            // A vector is padded with zeros where the other side is longer: POV-Ray warns and goes on with infinity.
            if (std::find(right.value, right.value + right.count, 0.0) != right.value + right.count ||
                (right.count > 1 && right.count < left.count))
                fail(token, "division by zero");
            combine<MotionOp::divide>(left, right);
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
            change<MotionOp::negate>(terms);
        else if (token.kind == TokenKind::bang)
            change<MotionOp::logical_not>(terms);
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
