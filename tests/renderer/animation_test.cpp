// SPDX-License-Identifier: Apache-2.0
// The expected numbers were printed by POV-Ray 3.7.0.10 with #debug and str(..., 0, 17).
#include "renderer/animation.h"

#include <doctest/doctest.h>
#include <numeric>

using namespace proxima;

namespace {

Animation frames(int64_t first, int64_t last, float initial_clock = 0, float final_clock = 1, bool cyclic = false) {
    std::vector<int64_t> all(size_t(last - first + 1));
    std::iota(all.begin(), all.end(), first);
    Animation animation = Animation::sequence(all, all);
    animation.initial_clock = initial_clock;
    animation.final_clock = final_clock;
    animation.cyclic = cyclic;
    return animation;
}

} // namespace

TEST_CASE("animation: clock and clock_delta are POV-Ray's to the bit") {
    struct Row {
        Animation animation;
        int64_t frame;
        double clock, delta;
    };
    const Row rows[] = {
        {frames(1, 10), 1, 0.0, 0.111111},
        {frames(1, 10), 2, 0.11111111193895340, 0.111111},
        {frames(1, 10), 10, 1.0, 0.111111},
        {frames(1, 3, 0, 0.1234567f), 2, 0.06172835081815720, 0.0617284},
        {frames(1, 3, 0, 0.1234567f), 3, 0.12345670163631439, 0.0617284},
        {frames(1, 10, 0.1f, 0.7f), 5, 0.36666664481163025, 0.0666667},
        {frames(1, 3, 0, 1, true), 2, 0.33333334326744080, 0.333333},
        {frames(1, 3, 0, 1, true), 3, 0.66666668653488159, 0.333333},
        {frames(1234567, 1234568), 1234568, 1.0, 1.0},
        // The range is rounded to float and its division is not: these tell all other ways apart.
        {frames(1, 72, 0, 1, true), 60, 0.81944441795349121, 0.0138889},
        {frames(3, 60, 0.1f, 0.7f), 28, 0.36315786838531494, 0.0105263},
        {frames(1, 43, -3.3f, 11.7f, true), 6, -1.55581390857696533, 0.348837},
    };
    for (const Row& row : rows) {
        CAPTURE(row.frame);
        CHECK(row.animation.clock(row.frame).clock == double(float(row.clock)));
        CHECK(row.animation.clock(row.frame).clock_delta == row.delta);
        CHECK(row.animation.clock(row.frame).clock_on);
    }
}

TEST_CASE("animation: the other names went through six significant digits") {
    const SceneClock time = frames(1, 2, 0.12345678f, 0.7654321f).clock(1);
    CHECK(time.initial_clock == 0.123457);
    CHECK(time.final_clock == 0.765432);
    CHECK(time.initial_frame == 1);
    CHECK(time.final_frame == 2);
    CHECK(frames(1234567, 1234568).clock(1234567).frame_number == 1234570);
    CHECK(frames(1, 2, 0, 1, true).clock(1).final_frame == 3);
}

TEST_CASE("animation: a frame's moments are the middles of the parts of its exposure, in steps between frames") {
    Animation animation = frames(1, 11);
    CHECK(animation.moments(3).size() == 1);
    CHECK(animation.moments(3)[0].clock == animation.clock(3).clock);
    animation.shutter = {-0.5, 0.5, 4};
    const std::vector<SceneClock> moments = animation.moments(3);
    REQUIRE(moments.size() == 4);
    const double steps[] = {-0.375, -0.125, 0.125, 0.375};
    for (size_t i = 0; i < 4; ++i) {
        CHECK(moments[i].clock == double(float((2 + steps[i]) * (1.0 / 10))));
        CHECK(moments[i].frame_number == 3);
        CHECK(moments[i].clock_delta == 0.1);
    }
}

TEST_CASE("animation: in a still everything reads 0 but the clock that was asked for") {
    const SceneClock plain = Animation::still({}).clock(0);
    CHECK(plain.clock == 0);
    CHECK_FALSE(plain.clock_on);
    const SceneClock asked = Animation::still(0.1f).clock(0);
    CHECK(asked.clock == 0.10000000149011612);
    CHECK(asked.clock_on);
    CHECK(asked.clock_delta == 0);
    CHECK(asked.final_frame == 0);
    CHECK(asked.final_clock == 0);
    CHECK(Animation::still(0.0f).clock(0).clock_on);
}

TEST_CASE("animation: a single frame has the initial clock where POV-Ray has NaN") {
    const Animation single = frames(5, 5, 0.25f, 1);
    CHECK(single.has_no_step());
    CHECK(single.clock(5).clock == 0.25);
    CHECK(single.clock(5).clock_delta == 0);
    CHECK(single.clock(5).frame_number == 5);
    CHECK_FALSE(frames(5, 5, 0, 1, true).has_no_step());
    CHECK(frames(5, 5, 0, 1, true).clock(5).clock_delta == 1);
}

TEST_CASE("animation: a subset changes neither clock nor numbering") {
    const Animation whole = frames(1, 10);
    Animation part = Animation::sequence(whole.frames, {7, 3});
    CHECK(part.frames == std::vector<int64_t>{7, 3});
    for (const int64_t frame : part.frames)
        CHECK(part.clock(frame).clock == whole.clock(frame).clock);
    CHECK(part.clock(3).final_frame == 10);
}
