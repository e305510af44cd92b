// SPDX-License-Identifier: Apache-2.0
// finish: how a surface reflects.
#include "parser/evaluator.h"

#include <cmath>

namespace proxima {
namespace {

/// POV-Ray's "albedo" amounts are the share of light that is reflected: they are turned into the plain amounts once all
/// else is known. The specular term's factor depends on n = 1 / roughness.
struct Albedos {
    bool diffuse = false;
    bool phong = false;
    bool specular = false;

    void fold_into(Finish& finish) const {
        if (diffuse)
            finish.diffuse *= (finish.brilliance + 1) / 2;
        if (phong)
            finish.phong *= (finish.phong_size + 1) / 2;
        if (specular) {
            const double n = finish.inverse_roughness;
            finish.specular = float(finish.specular * (n + 2) / (4 * (2 - std::pow(2.0, -n / 2))));
        }
    }
};

} // namespace

/// `finish { ... }` after its word; `base` is what the block changes.
FinishRef Evaluator::finish(uint32_t base) {
    expect(TokenKind::left_brace);
    Finish value = builder_.finish(base);
    if (const FinishRef* declared = identifier<FinishRef>()) {
        value = builder_.finish(declared->index);
        advance();
    }
    Albedos albedos;
    for (;;) {
        const Token& token = peek();
        if (accept(Word::ambient)) {
            value.ambient = rgb_color();
        } else if (accept(Word::emission)) {
            value.emission = rgb_color();
        } else if (accept(Word::diffuse)) {
            albedos.diffuse = accept(Word::albedo);
            value.diffuse = float(number());
        } else if (accept(Word::brilliance)) {
            value.brilliance = float(number());
        } else if (accept(Word::phong)) {
            albedos.phong = accept(Word::albedo);
            value.phong = float(number());
        } else if (accept(Word::phong_size)) {
            value.phong_size = float(number());
        } else if (accept(Word::specular)) {
            albedos.specular = accept(Word::albedo);
            value.specular = float(number());
        } else if (accept(Word::roughness)) {
            const double roughness = number();
            if (!(roughness > 0))
                fail(token, "roughness must be above 0");
            value.inverse_roughness = float(1 / roughness);
        } else if (accept(Word::metallic)) {
            value.metallic = starts_expression() ? float(number()) : 1.0f;
        } else if (accept(Word::reflection)) {
            reflection(value);
        } else if (accept(Word::reflection_exponent)) {
            value.reflection_exponent = float(number());
        } else if (accept(Word::conserve_energy)) {
            value.conserve_energy = 1;
        } else if (accept(Word::crand)) {
            if (number() != 0)
                fail(token, "Proxima does not support 'crand'", "leave it out or set it to 0");
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("a word of a finish (ambient, diffuse, phong, specular, reflection, ...) or '}'");
    albedos.fold_into(value);
    return {builder_.add_finish(value)};
}

/// `reflection COLOR` or `reflection { [COLOR,] COLOR ... }` after its word.
void Evaluator::reflection(Finish& finish) {
    if (!accept(TokenKind::left_brace)) {
        finish.reflection_min = finish.reflection_max = rgb_color();
        return;
    }
    finish.reflection_min = finish.reflection_max = rgb_color();
    accept(TokenKind::comma);
    const bool two_colors = starts_color() || starts_expression();
    if (two_colors)
        finish.reflection_max = rgb_color();
    for (;;) {
        const Token& token = peek();
        if (accept(Word::fresnel)) {
            const double flag = starts_expression() ? std::trunc(number()) : 1;
            if (flag != 0 && flag != 1)
                fail(token, "fresnel is on or off");
            finish.fresnel = uint32_t(flag);
        } else if (accept(Word::falloff)) {
            finish.reflection_falloff = float(number());
        } else if (accept(Word::exponent)) {
            const double exponent = number();
            if (!(exponent > 0))
                fail(token, "the exponent of a reflection must be above 0");
            finish.reflection_exponent = float(exponent);
        } else if (accept(Word::metallic)) {
            finish.reflection_metallic = starts_expression() ? float(number()) : 1.0f;
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("fresnel, falloff, exponent, metallic or '}'");
    if (finish.fresnel && !two_colors)
        finish.reflection_min = glm::vec3(0);
}

} // namespace proxima
