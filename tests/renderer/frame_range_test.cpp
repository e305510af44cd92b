// SPDX-License-Identifier: Apache-2.0
#include "renderer/errors.h"
#include "renderer/frame_range.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE("frame range: every way to write a list gives its frames in order, each once") {
    struct Row {
        const char* text;
        std::vector<int64_t> frames;
    };
    const Row rows[] = {
        {"7", {7}},
        {"1-4", {1, 2, 3, 4}},
        {"1..4", {1, 2, 3, 4}},
        {"1-9x3", {1, 4, 7}},
        {"1-10x3", {1, 4, 7, 10}},
        {"1-10:4", {1, 5, 9}},
        {"1,3,5..9", {1, 3, 5, 6, 7, 8, 9}},
        {"1-3,5,7-11:2", {1, 2, 3, 5, 7, 9, 11}},
        {"10-8x-1", {10, 9, 8}},
        {"10-8", {10, 9, 8}},
        {"-3--1", {-3, -2, -1}},
        {"-1-1", {-1, 0, 1}},
        {"1-3,2-4", {1, 2, 3, 4}},
        {"5,5,5", {5}},
        {"3-3x-2", {3}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.text);
        CHECK(parse_frame_range("--frames", row.text) == row.frames);
    }
}

TEST_CASE("frame range: what is no list is refused before anything is built") {
    const char* const texts[] = {"",
                                 "a",
                                 "1-",
                                 "1-b",
                                 "1,",
                                 "1,,2",
                                 "1-5x",
                                 "1-5x0",
                                 "1-5x-1",
                                 "5-1x1",
                                 "1-5y2",
                                 "1 - 5",
                                 "1-2-3",
                                 "0x10-20",
                                 "1.5",
                                 "1e3",
                                 "99999999999999999999999"};
    for (const char* text : texts) {
        CAPTURE(text);
        CHECK_THROWS_AS(parse_frame_range("--frames", text), UsageError);
    }
    CHECK_THROWS_WITH(parse_frame_range("--frames", "1-1000001"),
                      "--frames: more than 1000000 frames; render them in several runs");
    CHECK_THROWS_AS(parse_frame_range("--frames", "-1000000000-1000000000"), UsageError);
    CHECK_THROWS_AS(parse_frame_range("--frames", "1-9223372036854775807"), UsageError);
    CHECK(parse_frame_range("--frames", "1-1000000").size() == 1'000'000);
}
