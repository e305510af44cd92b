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
    finished.index = size_t(frame);
    return finished;
}

} // namespace

TEST_CASE("frame writer: frames are written in order, and their records come back") {
    std::vector<int64_t> written;
    FrameWriter writer(50, [&](FinishedFrame& frame) {
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
    FrameWriter writer(10, [&](FinishedFrame&) {
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
    FrameWriter writer(100, [](FinishedFrame& frame) {
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
        FrameWriter writer(1, [&](FinishedFrame&) { ++written; });
        writer.push(numbered(0));
    }
    CHECK(written <= 1);
}

TEST_CASE("frame writer: of frames that were not all pushed, the records are those that were, in order") {
    std::vector<int64_t> announced;
    FrameWriter writer(
        9, [](FinishedFrame&) {}, 2, [&](const FrameRecord& record) { announced.push_back(record.frame); });
    for (const int64_t frame : {7, 2, 4})
        writer.push(numbered(frame));
    std::vector<int64_t> kept;
    for (const FrameRecord& record : writer.finish())
        kept.push_back(record.frame);
    CHECK(kept == std::vector<int64_t>{2, 4, 7});
    CHECK(announced == std::vector<int64_t>{7, 2, 4}); // as they came
}
