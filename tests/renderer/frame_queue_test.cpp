// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_queue.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE("frame queue: workers of one device take bands of different frames, and help each other at the end") {
    const std::vector<Rows> bands{{0, 32}, {32, 32}, {64, 32}};
    FrameQueue queue(2, 4, bands, 2); // workers 0 and 2 are on one device, 1 and 3 on another
    for (size_t frame = 0; frame < 2; ++frame)
        REQUIRE(queue.push({.index = frame, .frame = int64_t(frame), .scenes = {}}));
    queue.end();
    const auto take = [&](size_t worker) {
        const std::optional<FrameTask> task = queue.take(worker);
        REQUIRE(task);
        return std::pair(task->frame, task->rows.first);
    };
    CHECK(take(2) == std::pair<int64_t, uint32_t>(1, 0));
    CHECK(take(0) == std::pair<int64_t, uint32_t>(0, 0));
    CHECK(take(1) == std::pair<int64_t, uint32_t>(0, 32));
    CHECK(take(3) == std::pair<int64_t, uint32_t>(1, 32));
    CHECK(take(1) == std::pair<int64_t, uint32_t>(0, 64));
    CHECK(take(0) == std::pair<int64_t, uint32_t>(1, 64)); // nothing is left of the others
    for (size_t band = 0; band < 6; ++band)
        queue.finish(band % 4, 1);
    CHECK_FALSE(queue.take(0));
}

TEST_CASE("frame queue: whole frames go to whoever asks, in order") {
    FrameQueue queue(4, 4, {Rows{}}, 2);
    for (size_t frame = 0; frame < 2; ++frame)
        REQUIRE(queue.push({.index = frame, .frame = int64_t(frame), .scenes = {}}));
    CHECK(queue.take(3)->frame == 0);
    CHECK(queue.take(3)->frame == 1);
}
