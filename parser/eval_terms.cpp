// SPDX-License-Identifier: Apache-2.0
// Vectors, their terms, and what the rest of the scene asks of an expression: a number, a vector.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>

namespace proxima {

Terms Evaluator::vector_literal() {
    expect(TokenKind::left_angle);
    Terms terms;
    terms.count = 0;
    NodeId nodes[5] = {};
    NodeId any = 0;
    for (;;) {
        const Token& at = peek();
        if (terms.count >= 2 && at.kind == TokenKind::right_angle)
            break;
        if (terms.count == 5)
            fail_unexpected("'>': a vector has at most 5 terms");
        const Varying number = moving_number();
        any |= nodes[terms.count] = number.node;
        terms.value[terms.count++] = number.value;
        if (accept(TokenKind::comma) && terms.count == 5 && peek().kind == TokenKind::right_angle)
            fail_unexpected("no comma behind the fifth term");
    }
    advance();
    if (any) [[unlikely]]
        terms.nodes = graph_.terms(nodes);
    return terms;
}

void Evaluator::access(Terms& terms) {
    while (cursor_->directive == Directive::end && leave_macro()) {
    }
    if (cursor_->kind != TokenKind::dot)
        return;
    advance();
    struct Member {
        Word word;
        int index;
    };
    static constexpr Member members[] = {{Word::x, 0}, {Word::u, 0},      {Word::red, 0},     {Word::y, 1},
                                         {Word::v, 1}, {Word::green, 1},  {Word::z, 2},       {Word::blue, 2},
                                         {Word::t, 3}, {Word::filter, 3}, {Word::transmit, 4}};
    const Token& token = peek();
    if (accept(Word::gray)) {
        if (terms.count < 3)
            fail(token, "only a color has a gray");
        terms = Terms(0.297 * terms.term(0) + 0.589 * terms.term(1) + 0.114 * terms.term(2));
        return;
    }
    for (const Member& member : members) {
        if (!accept(member.word))
            continue;
        if (member.index >= terms.count)
            fail(token, fmt::format("this vector has {} terms and no .{}", terms.count, spelling(token)));
        terms = Terms(terms.term(member.index));
        return;
    }
    fail_unexpected("x, y, z, t, u, v, red, green, blue, filter, transmit or gray");
}

bool Evaluator::starts_expression() {
    const Token& token = peek();
    switch (token.kind) {
    case TokenKind::number:
    case TokenKind::left_angle:
    case TokenKind::left_paren:
    case TokenKind::plus:
    case TokenKind::minus:
    case TokenKind::bang:
        return true;
    case TokenKind::name:
        return identifier<Terms>() || is_callable(named_value(token));
    case TokenKind::word:
        return token.index >= uint32_t(Word::x) && token.index <= uint32_t(Word::val);
    default:
        return false;
    }
}

namespace {

/// Whether nothing that stands before this token goes on behind it. A '>' closes a vector: relations need parentheses.
bool ends_number(TokenKind kind) {
    return kind == TokenKind::comma || kind == TokenKind::right_angle || kind == TokenKind::right_brace ||
           kind == TokenKind::right_paren;
}

/// Whether these tokens are FUNCTION ( NAME ) before the end of a number, with no directive among them.
bool is_plain_call(const Token* token) {
    return token[1].kind == TokenKind::left_paren && token[2].kind == TokenKind::name &&
           token[2].directive == Directive::none && token[3].kind == TokenKind::right_paren &&
           ends_number(token[4].kind);
}

} // namespace

Varying Evaluator::moving_number() {
    const Token& token = peek();
    // The commonest number stands alone before a comma or a bracket.
    if (token.kind == TokenKind::number && (&token)[1].kind == TokenKind::comma) {
        advance();
        return token.number();
    }
    // The next commonest is a name there.
    if (token.kind == TokenKind::name && token.directive == Directive::none && ends_number((&token)[1].kind)) {
        const Terms* terms = identifier<Terms>();
        if (terms && terms->count == 1 && std::isfinite(terms->value[0])) {
            const Varying value(terms->value[0], terms->nodes);
            advance();
            return value;
        }
    }
    // In loops it is a random one.
    if (token.kind == TokenKind::word && token.index == uint32_t(Word::rand) && is_plain_call(&token)) {
        advance();
        advance();
        const double value = random_number();
        advance();
        return value;
    }
    const SourceSpan place = span(token);
    const Terms terms = sum();
    if (terms.count != 1)
        throw SceneError(place, "a number is needed here, not a vector or color", "take one term of it, like .x");
    if (!terms.finite())
        throw SceneError(place, "this number is not finite");
    return {terms.value[0], terms.nodes};
}

Terms Evaluator::vector_of(int count, const char* what) {
    const SourceSpan place = span(peek());
    Terms terms = sum();
    if (terms.count > count)
        throw SceneError(place, fmt::format("{} has at most {} terms, this one has {}", what, count, terms.count));
    terms.promote(count);
    if (!terms.finite())
        throw SceneError(place, fmt::format("{} is not finite", what));
    return terms;
}

Vec3<double> Evaluator::vector() {
    const Token& first = peek();
    const SourceSpan place = span(first);
    const Terms terms = vector_of(3, "a vector");
    if (terms.nodes)
        look_at(place, first, terms.nodes);
    return terms.vector();
}

bool Evaluator::optional_flag(bool value) {
    return starts_expression() ? std::abs(number()) > epsilon : value;
}

} // namespace proxima
