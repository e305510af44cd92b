// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_writer.h"

#include <algorithm>
#include <utility>

namespace proxima {

FrameWriter::FrameWriter(std::function<void(FinishedFrame&)> write, unsigned threads,
                         std::function<void(const FrameRecord&)> announce)
    : write_(std::move(write)), announce_(std::move(announce)), most_threads_(std::max(1u, threads)) {}

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
    entries_.push_back({.index = frame.index});
    waiting_.push_back(std::move(frame));
    if (idle_ < waiting_.size() && threads_.size() < most_threads_)
        threads_.emplace_back([this] { run(); });
    changed_.notify_all();
}

std::vector<FrameRecord> FrameWriter::finish() {
    close(false);
    if (error_)
        std::rethrow_exception(error_);
    std::stable_sort(entries_.begin(), entries_.end(),
                     [](const Entry& a, const Entry& b) { return a.index < b.index; });
    std::vector<FrameRecord> records;
    for (Entry& entry : entries_)
        records.push_back(std::move(entry.record));
    return records;
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
        const size_t entry = begun_++;
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
        entries_[entry].record = std::move(frame.record);
        entries_[entry].is_written = true;
        free_images_.push_back(std::move(frame.image));
        for (; announced_ < begun_ && entries_[announced_].is_written; ++announced_)
            announce_(entries_[announced_].record);
    }
}

} // namespace proxima
