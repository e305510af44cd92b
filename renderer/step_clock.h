// SPDX-License-Identifier: Apache-2.0
// When the steps of a frame began and ended on a device. A device is given one step after the other without waiting for
// it; what each took is known once the device has been waited for.
#pragma once
#include "renderer/frame_step.h"

#include <deque>
#include <vector>

namespace proxima {

template <class Backend> class StepClock {
public:
    explicit StepClock(Backend& backend) : backend_(backend) {}

    /// `work` gives the device what belongs to a step.
    template <class Work> void step(FrameStep step, const Work& work) {
        const size_t place = steps_.size();
        while (moments_.size() < 2 * (place + 1))
            moments_.emplace_back(backend_);
        moments_[2 * place].record();
        work();
        moments_[2 * place + 1].record();
        steps_.push_back(step);
    }

    /// After a synchronize(): calls report(step, begin, end) for each step since the last call, in order.
    template <class Report> void settle(const Report& report) {
        const auto now = std::chrono::steady_clock::now();
        for (size_t i = 0; i < steps_.size(); ++i) {
            const auto& last = moments_[2 * steps_.size() - 1];
            const auto time_of = [&](const typename Backend::Moment& moment) {
                return now - std::chrono::duration_cast<StepWatch::Time::duration>(
                                 std::chrono::duration<double, std::milli>(last.milliseconds_since(moment)));
            };
            report(steps_[i], time_of(moments_[2 * i]), time_of(moments_[2 * i + 1]));
        }
        steps_.clear();
    }
    /// Forgets steps that failed.
    void clear() { steps_.clear(); }

private:
    Backend& backend_;
    std::deque<typename Backend::Moment> moments_; ///< the beginning and the end of each step
    std::vector<FrameStep> steps_;
};

} // namespace proxima
