// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_queue.h"

#include <algorithm>
#include <utility>

namespace proxima {

FrameQueue::FrameQueue(size_t total, size_t workers, std::vector<Rows> bands, size_t devices)
    : bands_(std::move(bands)), devices_(devices > 0 ? devices : std::max<size_t>(workers, 1)), workers_(workers),
      not_taken_(total * bands_.size()) {}

bool FrameQueue::push(FrameTask task) {
    task.assembly = std::make_shared<FrameAssembly>(bands_.size());
    std::unique_lock lock(mutex_);
    for (const Rows& rows : bands_) {
        changed_.wait(lock, [this] { return waiting_.size() < capacity * bands_.size() || closed_; });
        if (closed_)
            return false;
        task.rows = rows;
        waiting_.push_back(task);
        if (workers_.size() == 1 && task.scenes.programs.size() == 1 && task.scenes.moments.empty())
            task.scenes.programs = {nullptr}; // nobody else needs it: see FrameSource
        changed_.notify_all();
    }
    return true;
}

void FrameQueue::end(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    error_ = std::move(error);
    if (error_)
        not_taken_ = waiting_.size();
    changed_.notify_all();
}

std::optional<FrameTask> FrameQueue::take(size_t worker) {
    std::unique_lock lock(mutex_);
    for (;;) {
        if (closed_ || is_over())
            return std::nullopt;
        std::deque<FrameTask>& queue = returned_.empty() ? waiting_ : returned_;
        if (!queue.empty() && is_worthwhile(worker)) {
            if (&queue == &waiting_)
                --not_taken_;
            std::optional<FrameTask> task(next_for(worker, queue));
            ++in_flight_;
            changed_.notify_all();
            return task;
        }
        changed_.wait(lock);
    }
}

/// Takes a band of a frame that nobody else on the worker's device works on, or else the first one.
FrameTask FrameQueue::next_for(size_t worker, std::deque<FrameTask>& queue) const {
    const size_t turns = (workers_.size() + devices_ - 1) / devices_;
    auto next = std::find_if(queue.begin(), queue.end(),
                             [&](const FrameTask& task) { return task.index % turns == worker / devices_; });
    if (next == queue.end() || bands_.size() == 1)
        next = queue.begin();
    FrameTask task = std::move(*next);
    queue.erase(next);
    return task;
}

void FrameQueue::finish(size_t worker, double milliseconds) {
    const std::lock_guard lock(mutex_);
    Worker& own = workers_[worker];
    ++own.finished;
    own.milliseconds = own.finished > warm_up + 1 ? 0.75 * own.milliseconds + 0.25 * milliseconds : milliseconds;
    --in_flight_;
    changed_.notify_all();
}

void FrameQueue::give_back(FrameTask task) {
    const std::lock_guard lock(mutex_);
    --in_flight_;
    returned_.push_back(std::move(task));
    changed_.notify_all();
}

void FrameQueue::leave(size_t worker) {
    const std::lock_guard lock(mutex_);
    workers_[worker].left = true;
    changed_.notify_all();
}

void FrameQueue::close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    waiting_.clear();
    returned_.clear();
    changed_.notify_all();
}

size_t FrameQueue::workers_left() const {
    const std::lock_guard lock(mutex_);
    return size_t(std::count_if(workers_.begin(), workers_.end(), [](const Worker& worker) { return !worker.left; }));
}

bool FrameQueue::has_unfinished() const {
    const std::lock_guard lock(mutex_);
    return not_taken_ + returned_.size() > 0;
}

std::exception_ptr FrameQueue::error() const {
    const std::lock_guard lock(mutex_);
    return error_;
}

bool FrameQueue::is_over() const {
    return ended_ && waiting_.empty() && returned_.empty() && in_flight_ == 0;
}

bool FrameQueue::is_worthwhile(size_t worker) const {
    if (!workers_[worker].is_known())
        return true;
    const double own = workers_[worker].milliseconds;
    double rate = 0, fastest = own; // of those that are faster: frames a millisecond, and milliseconds a frame
    for (size_t i = 0; i < workers_.size(); ++i) {
        if (i == worker || workers_[i].left || !workers_[i].is_known() || workers_[i].milliseconds >= own)
            continue;
        rate += 1 / std::max(workers_[i].milliseconds, 1e-3);
        fastest = std::min(fastest, workers_[i].milliseconds);
    }
    if (rate == 0)
        return true; // the fastest one always goes on
    const double by_others = std::max(double(not_taken_ + returned_.size()) / rate, fastest);
    return own <= 2 * by_others; // what is measured varies, and the others may be busy
}

} // namespace proxima
