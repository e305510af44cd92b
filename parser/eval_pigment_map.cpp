// SPDX-License-Identifier: Apache-2.0
// Patterns that choose between pigments instead of colours.
#include "parser/evaluator.h"

#include <fmt/format.h>

namespace proxima {

bool Evaluator::starts_pigment() {
    const Token& token = peek();
    const bool is_pattern = token.kind == TokenKind::word &&
                            (token.index == uint32_t(Word::checker) ||
                             (token.index >= uint32_t(Word::gradient) && token.index <= uint32_t(Word::leopard)));
    return is_pattern || identifier<PigmentRef>() || starts_color();
}

/// `pigment_map { [value pigment] ... }` after its word.
PigmentMapRef Evaluator::pigment_map() {
    const Nesting nesting(*this);
    expect(TokenKind::left_brace);
    if (const PigmentMapRef* declared = identifier<PigmentMapRef>()) {
        const PigmentMapRef map = *declared;
        advance();
        expect(TokenKind::right_brace);
        return map;
    }
    std::vector<Moving<ColorStop>> stops;
    while (accept(TokenKind::left_bracket)) {
        const Token& at = peek();
        ColorStop& stop = stops.emplace_back().record;
        stop.value = float(number());
        accept(TokenKind::comma);
        if (!starts_pigment())
            fail_unexpected("what stands in a pigment: a color, a pattern or a name");
        stop.pigment = pigment_items(0, TokenKind::right_bracket).index;
        if (builder_.map_depth(stop.pigment) >= pigment_map_depth)
            fail(at, fmt::format("pigment maps stand in each other more than {} deep", pigment_map_depth));
        check_rising(at, stops);
    }
    if (stops.empty())
        fail_unexpected("an entry like [0.5 rgb <1, 0, 0>], or the name of a pigment map");
    if (!accept(TokenKind::right_brace))
        fail_unexpected("an entry like [0.5 rgb <1, 0, 0>] or '}'");
    const ColorMapRef map = builder_.add_color_map(stops);
    return {map.first, map.count};
}

/// Reads a pigment map, if the next token begins one. `own_pattern`: the pattern's word stands in the same block, so
/// that its space is not moved yet.
bool Evaluator::pigment_map_item(PigmentValue& value, bool own_pattern) {
    const Token& word = peek();
    if (!accept(Word::pigment_map))
        return false;
    if (!own_pattern)
        fail(word, "the pattern of this pigment_map stands in another pigment", "write the pattern in this one");
    if (value.pattern->stop_count > 0)
        fail(word, "this pattern has a map already");
    const PigmentMapRef map = pigment_map();
    Pattern& pattern = value.pattern.record;
    pattern.first_stop = map.first;
    pattern.stop_count = map.count;
    // The map's pigments see the block's space, the kernel has points of the pattern's: a gradient's is turned.
    for (int i = 0; i < 9; ++i)
        look_at(span(word), word, value.pattern_from_world.linear[i / 3][i % 3].node);
    if (const Mat3<double> turn = value_of(value.pattern_from_world).linear; turn != Mat3<double>(1)) {
        const std::span all(builder_.program().color_stops);
        std::vector<Moving<ColorStop>> turned(all.begin() + map.first, all.begin() + map.first + map.count);
        const Vec3<double> origin(0);
        const Transform turning(TransformPair{{turn, origin}, {glm::transpose(turn), origin}});
        for (Moving<ColorStop>& stop : turned)
            stop.record.pigment = builder_.transform_pigment(stop->pigment, turning);
        pattern.first_stop = builder_.add_color_map(turned).first;
    }
    return true;
}

} // namespace proxima
