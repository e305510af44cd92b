// SPDX-License-Identifier: Apache-2.0
// What ran when: the steps of all frames on all devices and writers, on one clock.
#pragma once
#include "renderer/frame_step.h"

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace proxima {

struct TimelineSpan {
    uint32_t lane = 0;
    FrameStep step = FrameStep::trace;
    int64_t frame = 0;
    double begin_ms = 0, end_ms = 0; ///< from the beginning of the run
};

/// add() may be called by any thread; the rest when nobody adds any more.
class Timeline {
public:
    /// Gets the memory that a run of so many frames is likely to need, so that it does not grow.
    explicit Timeline(size_t frames);
    Timeline() : Timeline(0) {}

    /// A step that a device, or "writer", took on the calling thread. Each such pair has a lane of its own.
    void add(const std::string& device, FrameStep step, int64_t frame, StepWatch::Time begin, StepWatch::Time end);

    /// The device of each lane; in the order in which they came.
    const std::vector<std::string>& lanes() const { return lanes_; }
    /// In the order in which they ended.
    const std::vector<TimelineSpan>& spans() const { return spans_; }

    /// Device -> the share of the time from the first step of any device to the last one's end in which it was at
    /// work on a frame at least. Writers are not in it.
    std::map<std::string, double> busy_shares() const;

    static constexpr const char* writer = "writer";

private:
    const StepWatch::Time start_ = std::chrono::steady_clock::now();
    std::mutex mutex_;
    std::map<std::pair<std::string, std::thread::id>, uint32_t> lane_of_;
    std::vector<std::string> lanes_;
    std::vector<TimelineSpan> spans_;
};

/// A picture of it: a row a lane, a bar a step. Of a run of many frames, the beginning.
std::string to_svg(const Timeline& timeline);

} // namespace proxima
