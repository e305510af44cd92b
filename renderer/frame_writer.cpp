// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_writer.h"

#include <algorithm>
#include <utility>

namespace proxima {

FrameWriter::FrameWriter(size_t frames, std::function<void(FinishedFrame&)> write, unsigned threads,
                         std::function<void(const FrameRecord&)> announce)
    : write_(std::move(write)), announce_(std::move(announce)), most_threads_(std::max(1u, threads)), records_(frames),
      states_(frames, State::absent) {}

FrameWriter::~FrameWriter() {
    close(true);
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
    states_.at(frame.index) = State::pushed;
    unannounced_.push_back(frame.index);
    waiting_.push_back(std::move(frame));
    if (idle_ < waiting_.size() && threads_.size() < most_threads_)
        threads_.emplace_back([this] { run(); });
    changed_.notify_all();
}

std::vector<FrameRecord> FrameWriter::finish() {
    close(false);
    if (error_)
        std::rethrow_exception(error_);
    size_t kept = 0; // of an interrupted run some are absent
    for (size_t i = 0; i < records_.size(); ++i)
        if (states_[i] == State::written && kept++ < i)
            records_[kept - 1] = std::move(records_[i]);
    records_.resize(kept);
    return std::move(records_);
}

void FrameWriter::close(bool drop) {
    {
        const std::lock_guard lock(mutex_);
        if (drop)
            waiting_.clear();
        closed_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
    threads_.clear();
}

void FrameWriter::run() {
    std::unique_lock lock(mutex_);
    for (;;) {
        ++idle_;
        changed_.wait(lock, [this] { return closed_ || error_ || !waiting_.empty(); });
        --idle_;
        if (waiting_.empty() || error_)
            return;
        FinishedFrame frame = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        lock.unlock();
        std::exception_ptr error;
        try {
            write_(frame);
        } catch (...) { // handed to a thread that renders
            error = std::current_exception();
        }
        lock.lock();
        if (error) {
            if (!error_)
                error_ = error;
            changed_.notify_all();
            return;
        }
        records_[frame.index] = std::move(frame.record);
        states_[frame.index] = State::written;
        free_images_.push_back(std::move(frame.image));
        for (; !unannounced_.empty() && states_[unannounced_.front()] == State::written; unannounced_.pop_front())
            announce_(records_[unannounced_.front()]);
    }
}

} // namespace proxima
