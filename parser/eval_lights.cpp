// SPDX-License-Identifier: Apache-2.0
// light_source: point lights.
#include "parser/evaluator.h"

namespace proxima {

/// `light_source { ... }` after its word.
Light<double> Evaluator::light_source() {
    expect(TokenKind::left_brace);
    Light<double> light;
    if (const LightRef* declared = identifier<LightRef>()) {
        light = **declared;
        advance();
    } else {
        light.position = vector();
        accept(TokenKind::comma);
        light.color = rgb_color();
    }
    for (;;) {
        TransformPair transform;
        if (accept(Word::shadowless))
            light.shadowless = 1;
        else if (accept(Word::fade_distance))
            light.fade_distance = float(number());
        else if (accept(Word::fade_power))
            light.fade_power = float(number());
        else if (transform_item(transform))
            light.position = transform.map.point(light.position);
        else
            break;
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("shadowless, fade_distance, fade_power, a transform or '}'");
    return light;
}

} // namespace proxima
