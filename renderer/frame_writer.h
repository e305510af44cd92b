// SPDX-License-Identifier: Apache-2.0
// Colour, encoding and writing of one frame on a thread of its own, while the next frame is rendered. A short queue
// stands between the two: rendering waits when writing is slower.
#pragma once
#include "renderer/image.h"
#include "renderer/statistics_json.h"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace proxima {

struct FinishedFrame {
    Image image;
    FrameRecord record;
};

class FrameWriter {
public:
    /// `write` makes the file and completes the record; it runs on the writer's thread, one frame at a time.
    explicit FrameWriter(std::function<void(FinishedFrame&)> write);
    /// Drops what still waits.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// A picture to render into: one that has been written, when there is one.
    Image take_image();
    /// Hands a frame over; waits while the queue is full. Rethrows what `write` threw for an earlier frame.
    void push(FinishedFrame frame);
    /// Waits until everything is written. Rethrows what `write` threw. Returns the records in order.
    std::vector<FrameRecord> finish();

private:
    static constexpr size_t capacity_ = 2;

    void run();

    std::function<void(FinishedFrame&)> write_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<FinishedFrame> waiting_;
    std::vector<Image> free_images_;
    std::vector<FrameRecord> records_;
    std::exception_ptr error_;
    bool closed_ = false;
    std::thread thread_; // last: it uses all of the above
};

} // namespace proxima
