// SPDX-License-Identifier: Apache-2.0
#include "renderer/timeline.h"

#include <algorithm>

namespace proxima {
namespace {

double milliseconds(StepWatch::Time from, StepWatch::Time to) {
    return std::chrono::duration<double, std::milli>(to - from).count();
}

using Interval = std::pair<double, double>;

/// The length of all intervals together, where they overlap once.
double length_of_union(std::vector<Interval> intervals) {
    std::sort(intervals.begin(), intervals.end());
    double length = 0, reached = 0;
    for (const auto& [begin, end] : intervals) {
        length += std::max(0.0, end - std::max(begin, reached));
        reached = std::max(reached, end);
    }
    return length;
}

} // namespace

Timeline::Timeline(size_t frames) {
    constexpr size_t spans_per_frame = 8;
    spans_.resize(frames * spans_per_frame); // written to, or the system gives it out bit by bit
    spans_.clear();
}

void Timeline::add(const std::string& device, FrameStep step, int64_t frame, StepWatch::Time begin,
                   StepWatch::Time end) {
    const std::lock_guard lock(mutex_);
    const auto [lane, is_new] = lane_of_.try_emplace({device, std::this_thread::get_id()}, uint32_t(lanes_.size()));
    if (is_new)
        lanes_.push_back(device);
    spans_.push_back({lane->second, step, frame, milliseconds(start_, begin), milliseconds(start_, end)});
}

std::map<std::string, double> Timeline::busy_shares() const {
    std::map<std::string, std::vector<Interval>> at_work;
    double first = 0, last = 0;
    for (const TimelineSpan& span : spans_) {
        if (lanes_[span.lane] == writer)
            continue;
        first = at_work.empty() ? span.begin_ms : std::min(first, span.begin_ms);
        last = std::max(last, span.end_ms);
        at_work[lanes_[span.lane]].emplace_back(span.begin_ms, span.end_ms);
    }
    std::map<std::string, double> shares;
    for (auto& [device, intervals] : at_work)
        shares[device] = last > first ? length_of_union(std::move(intervals)) / (last - first) : 0;
    return shares;
}

} // namespace proxima
