// SPDX-License-Identifier: Apache-2.0
// Colour, encoding and writing of frames on threads of their own, while the next frames are rendered. A short queue
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
    FrameRecord record{};
    size_t index = 0; ///< in the order in which frames were asked for
};

/// Any member may be called by any thread, finish() by one.
class FrameWriter {
public:
    /// For `frames` frames; their records get their memory here, so that a long run's does not grow. `write` makes the
    /// file and completes the record. It runs on up to `threads` threads, each with a frame of its own; a thread is
    /// started when a frame finds all others busy. `announce` is called for what is written, in the order of push().
    FrameWriter(
        size_t frames, std::function<void(FinishedFrame&)> write, unsigned threads = 1,
        std::function<void(const FrameRecord&)> announce = [](const FrameRecord&) {});
    /// Drops what still waits.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// A picture to render into: one that has been written before, when there is one, so that no memory is asked for.
    Image take_image();
    /// Hands a frame over; waits while the queue is full. Rethrows what `write` threw for an earlier frame.
    void push(FinishedFrame frame);
    /// Waits until everything is written. Rethrows what `write` threw. Returns the records of what was pushed, by
    /// index.
    std::vector<FrameRecord> finish();

private:
    static constexpr size_t capacity_ = 2;

    void run();
    void close(bool drop);

    enum class State : uint8_t { absent, pushed, written };

    std::function<void(FinishedFrame&)> write_;
    std::function<void(const FrameRecord&)> announce_;
    const size_t most_threads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<FinishedFrame> waiting_;
    std::deque<size_t> unannounced_; ///< indices of what was pushed, in that order
    std::vector<Image> free_images_;
    std::vector<FrameRecord> records_; ///< by index
    std::vector<State> states_;
    std::exception_ptr error_;
    size_t idle_ = 0; ///< threads that wait for a frame
    bool closed_ = false;
    std::vector<std::thread> threads_; // last: they use all of the above
};

} // namespace proxima
