// SPDX-License-Identifier: Apache-2.0
// Colours in every spelling of POV-Ray.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

/// How the terms after rgb, rgbt, ... go to the channels red, green, blue, filter, transmit.
struct Spelling {
    Word word;
    int count;
    bool transmit_is_fourth;
    bool encoded; ///< the sRGB curve
};

constexpr Spelling spellings[] = {
    {Word::rgb, 3, false, false},   {Word::rgbf, 4, false, false},  {Word::rgbt, 4, true, false},
    {Word::rgbft, 5, false, false}, {Word::srgb, 3, false, true},   {Word::srgbf, 4, false, true},
    {Word::srgbt, 4, true, true},   {Word::srgbft, 5, false, true},
};

struct Channel {
    Word word;
    int index;
};

constexpr Channel channels[] = {
    {Word::red, 0}, {Word::green, 1}, {Word::blue, 2}, {Word::filter, 3}, {Word::transmit, 4}};

/// IEC 61966-2-1: the sRGB code value as linear light.
Varying srgb_to_linear(const Varying& value) {
    if (!value.node)
        return value.value <= 0.04045 ? value.value / 12.92 : std::pow((value.value + 0.055) / 1.055, 2.4);
    const Varying curved =
        apply(MotionOp::max, value, 0.04045); // programs compute both sides, and a power of less is none
    return choose(apply(MotionOp::greater, value, 0.04045), apply(MotionOp::pow, (curved + 0.055) / 1.055, 2.4),
                  value / 12.92);
}

} // namespace

bool Evaluator::starts_color() {
    const Token& token = peek();
    if (token.kind == TokenKind::word)
        return token.index >= uint32_t(Word::color) && token.index <= uint32_t(Word::transmit);
    const Terms* terms = identifier<Terms>();
    return terms && terms->count == 5;
}

Terms Evaluator::color() {
    const Token& start = peek();
    if (!accept(Word::color))
        accept(Word::colour);
    Terms result;
    result.count = 5;
    bool any = false;
    const Token& first = peek();
    for (const Spelling& spelling : spellings) {
        if (!accept(spelling.word))
            continue;
        if (spelling.encoded && !has_assumed_gamma_)
            fail(first, "an sRGB color needs assumed_gamma in global_settings before it",
                 "write global_settings { assumed_gamma 1.0 } at the beginning");
        Terms terms = sum();
        if (terms.count == 5 && spelling.count < 5)
            warn(first, fmt::format("a whole color stands after '{}'", this->spelling(first)));
        else if (terms.count > spelling.count)
            fail(first, fmt::format("a vector of {} terms stands after '{}'", terms.count, this->spelling(first)),
                 fmt::format("expected at most {}", spelling.count));
        else {
            terms.promote(spelling.count);
            terms.promote(5);
            if (spelling.transmit_is_fourth)
                terms = Terms({terms.term(0), terms.term(1), terms.term(2), terms.term(4), terms.term(3)}, 5);
        }
        result = terms;
        if (spelling.encoded) {
            const auto decoded = [&](int i) { return encode_working(srgb_to_linear(terms.term(i))); };
            result = Terms({decoded(0), decoded(1), decoded(2), terms.term(3), terms.term(4)}, 5);
        }
        any = true;
        break;
    }
    if (!any && starts_expression()) {
        result = sum();
        result.promote(5);
        any = true;
    }
    for (bool more = true; more;) {
        more = false;
        if (next_operator() == TokenKind::directive)
            break;
        for (const Channel& channel : channels) {
            if (!accept(channel.word))
                continue;
            Varying terms[5];
            for (int i = 0; i < 5; ++i)
                terms[i] = result.term(i);
            terms[channel.index] = moving_number();
            result = Terms({terms[0], terms[1], terms[2], terms[3], terms[4]}, 5);
            any = more = true;
        }
    }
    if (!any)
        fail_unexpected("a color");
    if (!result.finite())
        fail(start, "this color is not finite");
    return result;
}

Vec3<Varying> Evaluator::rgb_color() {
    const Terms terms = color();
    return {terms.term(0), terms.term(1), terms.term(2)};
}

} // namespace proxima
