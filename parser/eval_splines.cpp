// SPDX-License-Identifier: Apache-2.0
// Splines: how they are made, and what they give.
#include "parser/evaluator.h"
#include "parser/spline.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace proxima {
namespace {

struct NamedSpline {
    Word word;
    SplineKind kind;
};

constexpr NamedSpline kinds[] = {{Word::linear_spline, SplineKind::linear},
                                 {Word::quadratic_spline, SplineKind::quadratic},
                                 {Word::cubic_spline, SplineKind::cubic},
                                 {Word::natural_spline, SplineKind::natural}};

std::optional<SplineKind> kind_named(const Token& token) {
    const auto found = std::ranges::find(kinds, token.index, [](const NamedSpline& k) { return uint32_t(k.word); });
    return token.kind == TokenKind::word && found != std::end(kinds) ? std::optional(found->kind) : std::nullopt;
}

} // namespace

/// `spline { [Name] [kind] time, point ... }` after its word.
Value Evaluator::spline() {
    expect(TokenKind::left_brace);
    auto result = std::make_shared<Spline>();
    if (const SplineRef* declared = identifier<SplineRef>()) {
        charge((*declared)->size() * sizeof(Spline::Point));
        *result = **declared;
        advance();
    }
    for (std::optional<SplineKind> kind; (kind = kind_named(peek())); advance())
        result->kind = *kind;
    while (starts_time())
        spline_point(*result);
    const Token& at = peek();
    if (!accept(TokenKind::right_brace))
        fail_unexpected("a time, which is a number, or '}'");
    check_spline(at, *result, result->kind);
    result->complete();
    return result;
}

/// Whether POV-Ray takes the next token for the beginning of a time: `x.x` is none.
bool Evaluator::starts_time() {
    const Token& token = peek();
    if (token.kind == TokenKind::left_angle)
        return false;
    if (token.kind == TokenKind::word && ((token.index >= uint32_t(Word::x) && token.index <= uint32_t(Word::v)) ||
                                          (token.index >= uint32_t(Word::vcross) && token.index < uint32_t(Word::asc))))
        return false;
    if (const Terms* terms = identifier<Terms>())
        return terms->count == 1;
    return starts_expression() && !identifier<SplineRef>();
}

void Evaluator::spline_point(Spline& spline) {
    const Token& at = peek();
    const double time = number();
    accept(TokenKind::comma);
    const Token& point_at = peek();
    Terms terms = sum();
    terms.promote(std::max(terms.count, 2));
    if (!terms.finite())
        fail(point_at, "this point is not finite");
    if (terms.nodes)
        look_at(span(at), at, terms.nodes);
    if (spline.terms == 0)
        spline.terms = terms.count;
    if (terms.count != spline.terms)
        fail(point_at, fmt::format("this point has {} terms, the one before has {}", terms.count, spline.terms),
             "all points of a spline need equally many");
    accept(TokenKind::comma);
    charge(3 * sizeof(Spline::Point));
    Spline::Point point;
    std::copy_n(terms.value, point.size(), point.begin());
    if (!spline.add(time, point))
        fail(at, fmt::format("this spline has a point at {} already", time));
}

void Evaluator::check_spline(const Token& at, const Spline& spline, SplineKind kind) const {
    if (!spline.suits(kind))
        fail(at, spline.size() == 0 ? "a spline needs a point" : "a cubic_spline of two points has no slope",
             spline.size() == 0 ? "write time, vector" : "it needs four; use linear_spline");
}

/// `time [, kind])` behind the parenthesis.
Terms Evaluator::call_spline(const Spline& spline) {
    const Varying time = moving_number();
    SplineKind kind = spline.kind;
    if (accept(TokenKind::comma)) {
        const Token& at = peek();
        const std::optional<SplineKind> named = kind_named(at);
        if (!named)
            fail_unexpected("linear_spline, quadratic_spline, cubic_spline or natural_spline");
        check_spline(at, spline, kind = *named);
        advance();
    }
    expect(TokenKind::right_paren);
    const Spline::Point point = spline.at(time.value, kind);
    Terms terms;
    terms.count = spline.terms;
    std::copy_n(point.begin(), terms.count, terms.value);
    if (time.node)
        terms.nodes = spline_nodes(spline, kind, time);
    return terms;
}

/// What a spline gives at a time that has a node.
NodeId Evaluator::spline_nodes(const Spline& spline, SplineKind kind, const Varying& time) {
    if (!graph_.records())
        return 0;
    if (!spline.kept_at) {
        charge(spline.table().size_bytes());
        spline.kept_at = graph_.keep(spline.table());
    }
    NodeId nodes[5] = {};
    for (int term = 0; term < spline.terms; ++term) {
        const double place = double(*spline.kept_at + spline.place_of(term));
        nodes[term] = graph_.operation(spline_op(kind), place, time);
    }
    return graph_.terms(nodes);
}

} // namespace proxima
