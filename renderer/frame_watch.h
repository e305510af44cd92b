// SPDX-License-Identifier: Apache-2.0
// Watches the steps of one frame on one device, or behind it: makes planned faults.
#pragma once
#include "renderer/fault_plan.h"

#include <string>
#include <utility>

namespace proxima {

/// What watches all frames of a run; null for what does not.
struct RunWatch {
    FaultPlan* faults = nullptr;
};

class FrameWatch : public StepWatch {
public:
    FrameWatch(RunWatch run, std::string device, int64_t frame)
        : run_(run), device_(std::move(device)), frame_(frame) {}

    void begin(FrameStep step) override {
        if (run_.faults)
            run_.faults->strike(device_, frame_, step);
    }

private:
    RunWatch run_;
    std::string device_;
    int64_t frame_;
};

} // namespace proxima
