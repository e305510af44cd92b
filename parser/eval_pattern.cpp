// SPDX-License-Identifier: Apache-2.0
// Patterns with a colour map, as they stand in a pigment.
#include "parser/evaluator.h"

#include <fmt/format.h>
#include <iterator>

namespace proxima {
namespace {

struct NamedPattern {
    Word word;
    PigmentKind kind;
};

constexpr NamedPattern patterns[] = {
    {Word::radial, PigmentKind::radial},   {Word::spherical, PigmentKind::spherical},
    {Word::planar, PigmentKind::planar},   {Word::cylindrical, PigmentKind::cylindrical},
    {Word::boxed, PigmentKind::boxed},     {Word::onion, PigmentKind::onion},
    {Word::leopard, PigmentKind::leopard},
};

// What POV-Ray takes when no colour map is given.
constexpr ColorStop grey_map[] = {{0, {}}, {1, {glm::vec3(1)}}};
constexpr ColorStop radial_map[] = {{0, {{0, 1, 1}}}, {0.333f, {{1, 1, 0}}}, {0.666f, {{1, 0, 1}}}, {1, {{0, 1, 1}}}};

struct NamedWave {
    Word word;
    Wave wave;
};

constexpr NamedWave waves[] = {
    {Word::ramp_wave, Wave::ramp},       {Word::sine_wave, Wave::sine},   {Word::triangle_wave, Wave::triangle},
    {Word::scallop_wave, Wave::scallop}, {Word::cubic_wave, Wave::cubic}, {Word::poly_wave, Wave::poly},
};

} // namespace

/// Reads the word of a pattern that takes a colour map, if the next token is one.
bool Evaluator::pattern_kind(PigmentValue& value) {
    if (accept(Word::gradient)) {
        const Token& at = peek();
        const Vec3<Varying> axis = moving_vector();
        if (!decide(apply(MotionOp::greater, glm::length(axis), 0)))
            fail(at, "the axis of a gradient must have a length");
        value = {};
        value.pigment.record.kind = PigmentKind::gradient;
        const Vec3<Varying> unit = glm::normalize(axis);
        const bool mostly_x = decide(apply(MotionOp::greater, apply(MotionOp::abs, unit.x), 0.5));
        const Vec3<Varying> across(mostly_x ? 0.0 : 1.0, mostly_x ? 1.0 : 0.0, 0.0);
        const Vec3<Varying> side = glm::normalize(glm::cross(across, unit));
        const Vec3<Varying> other = glm::cross(unit, side);
        for (int i = 0; i < 3; ++i) // the axis becomes the x of the pattern's space
            value.pattern_from_world.linear[i] = Vec3<Varying>(unit[i], side[i], other[i]);
        return true;
    }
    for (const NamedPattern& pattern : patterns)
        if (accept(pattern.word)) {
            value = {};
            value.pigment.record.kind = pattern.kind;
            return true;
        }
    return false;
}

/// Gives a pattern that has no colour map the one that POV-Ray takes.
void Evaluator::complete_pattern(PigmentValue& value) {
    if (!has_color_map(value.pigment->kind) || value.pattern->stop_count > 0)
        return;
    std::vector<Moving<ColorStop>> stops(std::begin(grey_map), std::end(grey_map));
    if (value.pigment->kind == PigmentKind::radial)
        stops.assign(std::begin(radial_map), std::end(radial_map));
    const ColorMapRef map = builder_.add_color_map(stops);
    value.pattern.record.first_stop = map.first;
    value.pattern.record.stop_count = map.count;
}

/// Reads what may stand behind a pattern, if the next token begins such a thing.
bool Evaluator::pattern_item(PigmentValue& value) {
    Pattern& pattern = value.pattern.record;
    const Token& word = peek();
    if (accept(Word::color_map) || accept(Word::colour_map)) {
        if (builder_.has_pigment_map(pattern))
            fail(word, "this pattern has a pigment_map already");
        const ColorMapRef map = color_map();
        pattern.first_stop = map.first;
        pattern.stop_count = map.count;
        return true;
    }
    if (accept(Word::frequency)) {
        value.pattern.set(pattern.frequency, moving_number());
        return true;
    }
    if (accept(Word::phase)) {
        value.pattern.set(pattern.phase, moving_number());
        return true;
    }
    for (const NamedWave& wave : waves)
        if (accept(wave.word)) {
            pattern.wave = wave.wave;
            if (wave.wave == Wave::poly && starts_expression())
                value.pattern.set(pattern.exponent, moving_number());
            return true;
        }
    return false;
}

/// `color_map { [value color] ... }` after its word. An entry may have two values and two colours.
ColorMapRef Evaluator::color_map() {
    expect(TokenKind::left_brace);
    if (const ColorMapRef* declared = identifier<ColorMapRef>()) {
        const ColorMapRef map = *declared;
        advance();
        expect(TokenKind::right_brace);
        return map;
    }
    std::vector<Moving<ColorStop>> stops;
    while (accept(TokenKind::left_bracket)) {
        const Token& at = peek();
        Moving<ColorStop> stop;
        ColorStop& entry = stop.record;
        stop.set(entry.value, moving_number());
        accept(TokenKind::comma);
        if (!starts_color()) {
            const Varying end = moving_number();
            expect_color_word();
            set_color(stop, entry.color, color());
            stops.push_back(stop);
            stop.set(entry.value, end);
            expect_color_word();
        }
        set_color(stop, entry.color, color());
        stops.push_back(stop);
        expect(TokenKind::right_bracket);
        check_rising(at, stops);
    }
    if (stops.empty())
        fail_unexpected("an entry like [0.5 rgb <1, 0, 0>], or the name of a color map");
    if (!accept(TokenKind::right_brace))
        fail_unexpected("an entry like [0.5 rgb <1, 0, 0>] or '}'");
    return builder_.add_color_map(stops);
}

/// POV-Ray asks for it before each of two colors.
void Evaluator::expect_color_word() {
    if (!peek_is(Word::color) && !peek_is(Word::colour))
        fail_unexpected("'color', before each of an entry's two colors");
}

/// Whether the last two stops, which may come together, follow those before.
void Evaluator::check_rising(const Token& at, std::span<const Moving<ColorStop>> stops) const {
    for (size_t i = std::max<size_t>(stops.size(), 3) - 2; i < stops.size(); ++i)
        if (decide(apply(MotionOp::less, stops[i].get(stops[i]->value), stops[i - 1].get(stops[i - 1]->value))))
            fail(at, fmt::format("the values of a color map must rise, {} stands behind {}", stops[i]->value,
                                 stops[i - 1]->value));
}

} // namespace proxima
