// SPDX-License-Identifier: Apache-2.0
// Surfaces: pigment, texture, interior and material. A block starts from what is there already: a declared one, the
// object's own, or #default's.
#include "parser/evaluator.h"

#include <fmt/format.h>

namespace proxima {

/// `pigment { ... }` after its word; `base` is what the block changes.
PigmentRef Evaluator::pigment(uint32_t base) {
    expect(TokenKind::left_brace);
    return pigment_items(base, TokenKind::right_brace);
}

/// What stands in a pigment, and the bracket that closes it.
PigmentRef Evaluator::pigment_items(uint32_t base, TokenKind closing) {
    PigmentValue value = builder_.pigment(base);
    if (const PigmentRef* declared = identifier<PigmentRef>()) {
        value = builder_.pigment(declared->index);
        advance();
    }
    // A colour or a pattern comes first, and once.
    std::string expected = "a transform";
    bool own_pattern = false;
    if (accept(Word::checker)) {
        value = {};
        Pigment& pigment = value.pigment.record;
        pigment.kind = PigmentKind::checker;
        pigment.color.rgb = {0, 0, 1}; // POV-Ray's checker is blue and green unless told
        pigment.second_color.rgb = {0, 1, 0};
        if (starts_color()) {
            set_color(value.pigment, pigment.color, color());
            accept(TokenKind::comma);
            if (starts_color())
                set_color(value.pigment, pigment.second_color, color());
        }
    } else if (pattern_kind(value)) {
        own_pattern = true;
        expected = "color_map, pigment_map, frequency, phase, a wave, a transform";
    } else if (starts_color()) {
        value = {};
        set_color(value.pigment, value.pigment.record.color, color());
    } else {
        expected = "a color (like rgb <1, 0, 0>), a pattern, a transform";
    }
    Transform transform;
    for (;;) {
        if (accept(Word::quick_color) || accept(Word::quick_colour))
            color(); // used by POV-Ray's previews alone
        else if (has_color_map(value.pigment->kind) && (pattern_item(value) || pigment_map_item(value, own_pattern)))
            continue;
        else if (!transform_item(transform))
            break;
    }
    if (!accept(closing))
        fail_unexpected(expected + (closing == TokenKind::right_brace ? " or '}'" : " or ']'"));
    complete_pattern(value);
    if (value.pigment->kind != PigmentKind::solid && !transform.is_identity)
        value.pattern_from_world = compose(value.pattern_from_world, transform.with_nodes().inverse);
    return {builder_.add_pigment(value)};
}

/// `interior { ... }` after its word.
InteriorRef Evaluator::interior(uint32_t base) {
    expect(TokenKind::left_brace);
    Moving<Interior> moving = builder_.interior(base);
    Interior& value = moving.record;
    if (const InteriorRef* declared = identifier<InteriorRef>()) {
        moving = builder_.interior(declared->index);
        advance();
    }
    for (;;) {
        const Token& token = peek();
        if (accept(Word::ior)) {
            const Varying ior = moving_number();
            if (!decide(apply(MotionOp::greater, ior, 0)) || !(float(ior.value) > 0))
                fail(token, "ior must be above 0");
            moving.set(value.ior, ior);
        } else if (accept(Word::fade_distance)) {
            moving.set(value.fade_distance, moving_number());
        } else if (accept(Word::fade_power)) {
            moving.set(value.fade_power, moving_number());
        } else if (accept(Word::fade_color) || accept(Word::fade_colour)) {
            moving.set(value.fade_color, rgb_color());
        } else if (accept(Word::caustics)) {
            if (number() != 0)
                fail(token, "Proxima does not support 'caustics'", "leave it out or set it to 0");
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("ior, fade_distance, fade_power, fade_color or '}'");
    return {builder_.add_interior(moving)};
}

/// `above` laid over `below`, which may be Surface::none.
uint32_t Evaluator::layered(uint32_t below, uint32_t above) {
    if (below == Surface::none)
        return above;
    std::vector<Layer> layers = builder_.texture(below);
    const std::vector<Layer> upper = builder_.texture(above);
    layers.insert(layers.end(), upper.begin(), upper.end());
    return builder_.add_texture(layers);
}

/// The layers of a texture that a pigment or finish is to be put into.
std::vector<Layer> Evaluator::single_layer(uint32_t texture) {
    std::vector<Layer> layers = builder_.texture(texture);
    if (layers.size() > 1)
        fail(cursor_[-1], fmt::format("this texture has {} layers", layers.size()),
             "give each layer its pigment and finish where it is declared");
    return layers;
}

/// Reads a pigment block and puts it into the texture.
uint32_t Evaluator::with_pigment(uint32_t texture) {
    std::vector<Layer> layers = single_layer(texture);
    layers.back().pigment = pigment(layers.back().pigment).index;
    return builder_.add_texture(layers);
}

uint32_t Evaluator::with_finish(uint32_t texture) {
    std::vector<Layer> layers = single_layer(texture);
    layers.back().finish = finish(layers.back().finish).index;
    return builder_.add_texture(layers);
}

/// Reads a pigment, finish or transform of a texture, if the next token begins one.
bool Evaluator::texture_item(uint32_t& texture) {
    Transform transform;
    if (accept(Word::pigment))
        texture = with_pigment(texture);
    else if (accept(Word::finish))
        texture = with_finish(texture);
    else if (transform_item(transform))
        texture = builder_.transform_texture(texture, transform);
    else
        return false;
    return true;
}

/// `texture { ... }` after its word.
TextureRef Evaluator::texture() {
    expect(TokenKind::left_brace);
    uint32_t texture = default_texture_;
    if (const TextureRef* declared = identifier<TextureRef>()) {
        texture = declared->index;
        advance();
    }
    while (texture_item(texture)) {
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("pigment, finish, a transform or '}'");
    return {texture};
}

/// `material { ... }` after its word.
MaterialValue Evaluator::material() {
    expect(TokenKind::left_brace);
    MaterialValue value;
    if (const MaterialValue* declared = identifier<MaterialValue>()) {
        value = *declared;
        advance();
    }
    for (;;) {
        Transform transform;
        if (accept(Word::texture))
            value.texture = layered(value.texture, texture().index);
        else if (accept(Word::interior))
            value.interior = interior(value.interior == Surface::none ? 0 : value.interior).index;
        else if (!transform_item(transform))
            break;
        else if (value.texture != Surface::none)
            value.texture = builder_.transform_texture(value.texture, transform);
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("texture, interior, a transform or '}'");
    return value;
}

} // namespace proxima
