// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_writer.h"

#include <atomic>
#include <chrono>
#include <doctest/doctest.h>
#include <stdexcept>

using namespace proxima;

namespace {

FinishedFrame numbered(int64_t frame) {
    FinishedFrame finished;
    finished.record.frame = frame;
    return finished;
}

} // namespace

TEST_CASE("frame writer: frames are written in order, and their records come back") {
    std::vector<int64_t> written;
    FrameWriter writer([&](FinishedFrame& frame) {
        written.push_back(frame.record.frame);
        frame.record.write_ms = double(frame.record.frame);
    });
    for (int64_t frame = 0; frame < 50; ++frame)
        writer.push(numbered(frame));
    const std::vector<FrameRecord> records = writer.finish();
    REQUIRE(records.size() == 50);
    for (int64_t frame = 0; frame < 50; ++frame) {
        CHECK(written[size_t(frame)] == frame);
        CHECK(records[size_t(frame)].write_ms == double(frame));
    }
}

TEST_CASE("frame writer: rendering waits when writing is slow") {
    std::atomic<int> written{0};
    FrameWriter writer([&](FinishedFrame&) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        ++written;
    });
    for (int frame = 0; frame < 10; ++frame) {
        writer.push(numbered(frame));
        CHECK(frame - written <= 3); // two wait, one is being written
    }
    writer.finish();
    CHECK(written == 10);
}

TEST_CASE("frame writer: a failure reaches the thread that renders") {
    FrameWriter writer([](FinishedFrame& frame) {
        if (frame.record.frame == 1)
            throw std::runtime_error("disk full");
    });
    const auto push_many = [&] {
        for (int64_t frame = 0; frame < 100; ++frame)
            writer.push(numbered(frame));
    };
    CHECK_THROWS_WITH(push_many(), "disk full");
    CHECK_THROWS_WITH(writer.finish(), "disk full");
}

TEST_CASE("frame writer: giving up does not wait for what has not begun") {
    std::atomic<int> written{0};
    {
        FrameWriter writer([&](FinishedFrame&) { ++written; });
        writer.push(numbered(0));
    }
    CHECK(written <= 1);
}
