// SPDX-License-Identifier: Apache-2.0
#include "renderer/errors.h"
#include "renderer/frame_rate.h"

#include <doctest/doctest.h>
#include <string>

using namespace proxima;

TEST_CASE("frame rate: whole numbers, fractions and the rates of television") {
    struct Row {
        const char* text;
        FrameRate rate;
    };
    const Row rows[] = {
        {"24", {24, 1}},
        {"25/1", {25, 1}},
        {"50/2", {25, 1}},
        {"23.976", {24000, 1001}},
        {"29.97", {30000, 1001}},
        {"59.94", {60000, 1001}},
        {"30000/1001", {30000, 1001}},
        {"12.5", {25, 2}},
        {"0.5", {1, 2}},
        {"1000", {1000, 1}},
        {"47.952", {48000, 1001}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.text);
        CHECK(parse_frame_rate(row.text) == row.rate);
    }
    for (const char* text : {"", "0", "-24", "fast", "24/0", "0/1", "24/", "nan", "inf", "1001", "1/1000", "24 "}) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_frame_rate(text), UsageError);
    }
    CHECK_THROWS_WITH(parse_frame_rate("0"),
                      "--fps 0: write frames a second from 0.01 to 1000, like 24, 29.97 or 30000/1001");
}

TEST_CASE("frame rate: a time code counts frames, seconds, minutes and hours, and a day is over after 24 hours") {
    struct Row {
        int64_t frame;
        FrameRate rate;
        TimeCode code;
    };
    const Row rows[] = {
        {0, {24, 1}, {0, 0, 0, 0}},        {23, {24, 1}, {0, 0, 0, 23}},
        {24, {24, 1}, {0, 0, 1, 0}},       {24 * 3600 + 61 * 24 + 5, {24, 1}, {1, 1, 1, 5}},
        {30, {30000, 1001}, {0, 0, 1, 0}}, {24 * 86400, {24, 1}, {0, 0, 0, 0}},
        {-1, {24, 1}, {23, 59, 59, 23}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.frame);
        const TimeCode code = time_code(row.frame, row.rate);
        CHECK(code.hours == row.code.hours);
        CHECK(code.minutes == row.code.minutes);
        CHECK(code.seconds == row.code.seconds);
        CHECK(code.frames == row.code.frames);
    }
}
