// SPDX-License-Identifier: Apache-2.0
// global_settings, and what POV-Ray derives from #version and assumed_gamma.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>

namespace proxima {

void Evaluator::global_settings() {
    SceneProgram& scene = builder_.program();
    expect(TokenKind::left_brace);
    for (;;) {
        const Token& token = peek();
        if (accept(Word::assumed_gamma)) {
            assumed_gamma();
        } else if (accept(Word::ambient_light)) {
            builder_.set(scene.ambient_light, rgb_color());
        } else if (accept(Word::max_trace_level)) {
            const double level = std::trunc(number());
            if (!(level >= 1 && level <= 256))
                fail(token, fmt::format("max_trace_level must lie between 1 and 256, this one is {}", level));
            scene.max_trace_level = uint32_t(level);
        } else if (accept(Word::adc_bailout)) {
            builder_.set(scene.adc_bailout, moving_number());
        } else if (accept(Word::charset)) {
            if (!accept(Word::ascii) && !accept(Word::utf8))
                fail_unexpected("ascii or utf8");
        } else if (accept(Word::max_intersections) || accept(Word::number_of_waves) || accept(Word::mm_per_unit)) {
            number(); // matters to what Proxima does not have
        } else if (accept(Word::noise_generator)) {
            const double generator = number();
            if (!(generator >= 1 && generator <= 3))
                fail(token, "noise_generator must be 1, 2 or 3");
        } else {
            break;
        }
    }
    if (!accept(TokenKind::right_brace))
        fail_unexpected("assumed_gamma, ambient_light, max_trace_level, adc_bailout or '}'");
}

void Evaluator::assumed_gamma() {
    SceneProgram& scene = builder_.program();
    const Token& token = peek();
    has_assumed_gamma_ = true;
    if (accept(Word::srgb)) {
        scene.working_curve = WorkingCurve::srgb;
        return;
    }
    const double gamma = number();
    if (!(gamma > 0))
        fail(token, "assumed_gamma must be above 0");
    scene.working_gamma = float(gamma);
    scene.working_curve = std::abs(gamma - 1) < epsilon ? WorkingCurve::linear : WorkingCurve::power;
}

/// Linear light as a number of the working space.
Varying Evaluator::encode_working(const Varying& linear) {
    const WorkingCurve curve = builder_.program().working_curve;
    if (curve == WorkingCurve::srgb) {
        const Varying curved = apply(MotionOp::max, linear, 0.0031308); // programs compute both sides
        return choose(apply(MotionOp::greater, linear, 0.0031308),
                      1.055 * apply(MotionOp::pow, curved, 1 / 2.4) - 0.055, linear * 12.92);
    }
    return curve == WorkingCurve::power ? apply(MotionOp::pow, linear, 1.0 / builder_.program().working_gamma) : linear;
}

/// POV-Ray decides by the version that holds at the end of the scene.
void Evaluator::finish_settings() {
    SceneProgram& scene = builder_.program();
    scene.legacy_transparency = before_3_7();
    if (!has_assumed_gamma_ && before_3_7())
        scene.working_curve = WorkingCurve::display;
    scene.depends_on_time = depends_on_time_;
}

} // namespace proxima
