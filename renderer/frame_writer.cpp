// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_writer.h"

#include <utility>

namespace proxima {

FrameWriter::FrameWriter(std::function<void(FinishedFrame&)> write)
    : write_(std::move(write)), thread_([this] { run(); }) {}

FrameWriter::~FrameWriter() {
    if (!thread_.joinable())
        return;
    {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
        closed_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

Image FrameWriter::take_image() {
    const std::lock_guard lock(mutex_);
    if (free_images_.empty())
        return {};
    Image image = std::move(free_images_.back());
    free_images_.pop_back();
    return image;
}

void FrameWriter::push(FinishedFrame frame) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < capacity_ || error_; });
    if (error_)
        std::rethrow_exception(error_);
    waiting_.push_back(std::move(frame));
    changed_.notify_all();
}

std::vector<FrameRecord> FrameWriter::finish() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
    thread_.join();
    if (error_)
        std::rethrow_exception(error_);
    return std::move(records_);
}

void FrameWriter::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return closed_ || !waiting_.empty(); });
        if (waiting_.empty())
            return;
        FinishedFrame frame = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        lock.unlock();
        std::exception_ptr error;
        try {
            write_(frame);
        } catch (...) { // handed to the thread that renders
            error = std::current_exception();
        }
        lock.lock();
        if (error) {
            error_ = error;
            changed_.notify_all();
            return;
        }
        records_.push_back(std::move(frame.record));
        free_images_.push_back(std::move(frame.image));
    }
}

} // namespace proxima
