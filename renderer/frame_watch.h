// SPDX-License-Identifier: Apache-2.0
// Watches the steps of one frame on one device, or behind it: makes planned faults, and notes what ran when.
#pragma once
#include "renderer/fault_plan.h"
#include "renderer/timeline.h"

#include <string>
#include <utility>

namespace proxima {

/// What watches all frames of a run; null for what does not.
struct RunWatch {
    FaultPlan* faults = nullptr;
    Timeline* timeline = nullptr;
};

class FrameWatch : public StepWatch {
public:
    /// `builder` watches the device that builds for this one, if there is one.
    FrameWatch(RunWatch run, std::string device, int64_t frame, StepWatch* builder = nullptr)
        : run_(run), device_(std::move(device)), frame_(frame), builder_(builder) {}

    StepWatch* builder() override { return builder_ ? builder_ : this; }

    void begin(FrameStep step) override {
        if (run_.faults)
            run_.faults->strike(device_, frame_, step);
    }
    void end(FrameStep step, Time begin, Time end) override {
        if (run_.timeline)
            run_.timeline->add(device_, step, frame_, begin, end);
    }

private:
    RunWatch run_;
    std::string device_;
    int64_t frame_;
    StepWatch* builder_;
};

} // namespace proxima
