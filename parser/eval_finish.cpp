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

    void fold_into(Moving<Finish>& moving) const {
        Finish& finish = moving.record;
        if (diffuse)
            moving.set(finish.diffuse, moving.get(finish.diffuse) * (moving.get(finish.brilliance) + 1) / 2);
        if (phong)
            moving.set(finish.phong, moving.get(finish.phong) * (moving.get(finish.phong_size) + 1) / 2);
        if (specular) {
            const Varying n = moving.get(finish.inverse_roughness);
            const Varying part = 4 * (2 - apply(MotionOp::pow, 2, -n / 2));
            moving.set(finish.specular, moving.get(finish.specular) * (n + 2) / part);
        }
    }
};

} // namespace

/// `finish { ... }` after its word; `base` is what the block changes.
FinishRef Evaluator::finish(uint32_t base) {
    expect(TokenKind::left_brace);
    Moving<Finish> moving = builder_.finish(base);
    Finish& value = moving.record;
    if (const FinishRef* declared = identifier<FinishRef>()) {
        moving = builder_.finish(declared->index);
        advance();
    }
    Albedos albedos;
    for (;;) {
        const Token& token = peek();
        if (accept(Word::ambient)) {
            moving.set(value.ambient, rgb_color());
        } else if (accept(Word::emission)) {
            moving.set(value.emission, rgb_color());
        } else if (accept(Word::diffuse)) {
            albedos.diffuse = accept(Word::albedo);
            moving.set(value.diffuse, moving_number());
        } else if (accept(Word::brilliance)) {
            moving.set(value.brilliance, moving_number());
        } else if (accept(Word::phong)) {
            albedos.phong = accept(Word::albedo);
            moving.set(value.phong, moving_number());
        } else if (accept(Word::phong_size)) {
            moving.set(value.phong_size, moving_number());
        } else if (accept(Word::specular)) {
            albedos.specular = accept(Word::albedo);
            moving.set(value.specular, moving_number());
        } else if (accept(Word::roughness)) {
            const Varying roughness = moving_number();
            if (!decide(apply(MotionOp::greater, roughness, 0)))
                fail(token, "roughness must be above 0");
            moving.set(value.inverse_roughness, 1 / roughness);
        } else if (accept(Word::metallic)) {
            moving.set(value.metallic, starts_expression() ? moving_number() : 1.0);
        } else if (accept(Word::reflection)) {
            reflection(moving);
        } else if (accept(Word::reflection_exponent)) {
            moving.set(value.reflection_exponent, moving_number());
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
    albedos.fold_into(moving);
    return {builder_.add_finish(moving)};
}

/// `reflection COLOR` or `reflection { [COLOR,] COLOR ... }` after its word.
void Evaluator::reflection(Moving<Finish>& moving) {
    Finish& finish = moving.record;
    const auto set_both = [&] {
        const Vec3<Varying> color = rgb_color();
        moving.set(finish.reflection_min, color);
        moving.set(finish.reflection_max, color);
    };
    if (!accept(TokenKind::left_brace)) {
        set_both();
        return;
    }
    set_both();
    accept(TokenKind::comma);
    const bool two_colors = starts_color() || starts_expression();
    if (two_colors)
        moving.set(finish.reflection_max, rgb_color());
    for (;;) {
        const Token& token = peek();
        if (accept(Word::fresnel)) {
            const double flag = starts_expression() ? std::trunc(number()) : 1;
            if (flag != 0 && flag != 1)
                fail(token, "fresnel is on or off");
            finish.fresnel = uint32_t(flag);
        } else if (accept(Word::falloff)) {
            moving.set(finish.reflection_falloff, moving_number());
        } else if (accept(Word::exponent)) {
            const Varying exponent = moving_number();
            if (!decide(apply(MotionOp::greater, exponent, 0)))
                fail(token, "the exponent of a reflection must be above 0");
            moving.set(finish.reflection_exponent, exponent);
        } else if (accept(Word::metallic)) {
            moving.set(finish.reflection_metallic, starts_expression() ? moving_number() : 1.0);
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("fresnel, falloff, exponent, metallic or '}'");
    if (finish.fresnel && !two_colors)
        moving.set(finish.reflection_min, Vec3<Varying>(0.0));
}

} // namespace proxima
