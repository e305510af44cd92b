// SPDX-License-Identifier: Apache-2.0
// What surrounds a scene: background, sky_sphere and fog.
#include "parser/evaluator.h"

#include <cmath>

namespace proxima {

void Evaluator::background() {
    expect(TokenKind::left_brace);
    const Terms terms = color();
    expect(TokenKind::right_brace);
    // Without an alpha channel, POV-Ray 3.7 mixes a transmitting background with black.
    const Varying opaque = 1 - terms.term(4);
    for (int i = 0; i < 3; ++i)
        builder_.set(builder_.program().background[i], terms.term(i) * opaque);
}

/// `sky_sphere { ... }` after its word. A transform moves all of its pigments.
Moving<SkySphere> Evaluator::sky_sphere() {
    expect(TokenKind::left_brace);
    Moving<SkySphere> sky;
    const Token& start = peek();
    if (const SkyRef* declared = identifier<SkyRef>()) {
        sky = **declared;
        advance();
    }
    Transform transform;
    for (;;) {
        if (accept(Word::pigment))
            sky.record.pigments.push_back(pigment(builder_.texture(default_texture_).back().pigment).index);
        else if (accept(Word::emission))
            sky.set(sky.record.emission, rgb_color());
        else if (!transform_item(transform))
            break;
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("pigment, emission, a transform or '}'");
    if (sky->pigments.empty())
        fail(start, "this sky_sphere has no pigment", "give it one: sky_sphere { pigment { rgb <0.4, 0.6, 1> } }");
    for (uint32_t& pigment : sky.record.pigments)
        pigment = builder_.transform_pigment(pigment, transform);
    return sky;
}

/// `fog { ... }` after its word.
Moving<Fog<double>> Evaluator::fog() {
    const Token& start = peek();
    expect(TokenKind::left_brace);
    Moving<Fog<double>> moving;
    Fog<double>& fog = moving.record;
    fog.altitude = 0;
    if (const FogRef* declared = identifier<FogRef>()) {
        moving = **declared;
        advance();
    }
    for (;;) {
        const Token& token = peek();
        if (accept(Word::distance)) {
            moving.set(fog.distance, moving_number());
        } else if (accept(Word::fog_type)) {
            const double type = number();
            if (type != 1 && type != 2)
                fail(token, "fog_type must be 1 (everywhere) or 2 (near the ground)");
            fog.kind = type == 1 ? FogKind::constant : FogKind::ground;
        } else if (accept(Word::fog_offset)) {
            moving.set(fog.offset, moving_number());
        } else if (accept(Word::fog_alt)) {
            moving.set(fog.altitude, moving_number());
        } else if (accept(Word::up)) {
            moving.set(fog.up, moving_vector());
        } else if (starts_color()) {
            const Terms color = this->color();
            moving.set(fog.color, Vec3<Varying>(color.term(0), color.term(1), color.term(2)));
            moving.set(fog.filter, color.term(3));
            moving.set(fog.transmit, color.term(4));
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("distance, a color, fog_type, fog_offset, fog_alt, up or '}'");
    const auto is_zero = [](const Varying& v) {
        return !decide(apply(MotionOp::greater, apply(MotionOp::abs, v), epsilon));
    };
    if (is_zero(moving.get(fog.distance)))
        fail(start, "the distance of a fog must not be 0");
    if (fog.kind == FogKind::ground && is_zero(moving.get(fog.altitude)))
        fail(start, "a ground fog needs a fog_alt other than 0");
    if (glm::length(fog.up) == 0)
        fail(start, "up must have a length");
    moving.set(fog.up, glm::normalize(moving.get(fog.up)));
    return moving;
}

} // namespace proxima
