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
    const double opaque = 1 - terms.value[4];
    for (int i = 0; i < 3; ++i)
        builder_.program().background[i] = float(terms.value[i] * opaque);
}

/// `sky_sphere { ... }` after its word. A transform moves all of its pigments.
SkySphere Evaluator::sky_sphere() {
    expect(TokenKind::left_brace);
    SkySphere sky;
    const Token& start = peek();
    if (const SkyRef* declared = identifier<SkyRef>()) {
        sky = **declared;
        advance();
    }
    TransformPair transform;
    for (;;) {
        if (accept(Word::pigment))
            sky.pigments.push_back(pigment(builder_.texture(default_texture_).back().pigment).index);
        else if (accept(Word::emission))
            sky.emission = rgb_color();
        else if (!transform_item(transform))
            break;
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("pigment, emission, a transform or '}'");
    if (sky.pigments.empty())
        fail(start, "this sky_sphere has no pigment", "give it one: sky_sphere { pigment { rgb <0.4, 0.6, 1> } }");
    for (uint32_t& pigment : sky.pigments)
        pigment = builder_.transform_pigment(pigment, transform.inverse);
    return sky;
}

/// `fog { ... }` after its word.
Fog<double> Evaluator::fog() {
    const Token& start = peek();
    expect(TokenKind::left_brace);
    Fog<double> fog;
    fog.altitude = 0;
    if (const FogRef* declared = identifier<FogRef>()) {
        fog = **declared;
        advance();
    }
    for (;;) {
        const Token& token = peek();
        if (accept(Word::distance)) {
            fog.distance = number();
        } else if (accept(Word::fog_type)) {
            const double type = number();
            if (type != 1 && type != 2)
                fail(token, "fog_type must be 1 (everywhere) or 2 (near the ground)");
            fog.kind = type == 1 ? FogKind::constant : FogKind::ground;
        } else if (accept(Word::fog_offset)) {
            fog.offset = number();
        } else if (accept(Word::fog_alt)) {
            fog.altitude = number();
        } else if (accept(Word::up)) {
            fog.up = vector();
        } else if (starts_color()) {
            const PigmentColor color = surface_color(this->color());
            fog.color = color.rgb;
            fog.filter = color.filter;
            fog.transmit = color.transmit;
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("distance, a color, fog_type, fog_offset, fog_alt, up or '}'");
    if (!(std::abs(fog.distance) > epsilon))
        fail(start, "the distance of a fog must not be 0");
    if (fog.kind == FogKind::ground && !(std::abs(fog.altitude) > epsilon))
        fail(start, "a ground fog needs a fog_alt other than 0");
    if (glm::length(fog.up) == 0)
        fail(start, "up must have a length");
    fog.up = glm::normalize(fog.up);
    return fog;
}

} // namespace proxima
