// SPDX-License-Identifier: Apache-2.0
// Faults that are made on purpose: a list of them comes in, and when its step of its frame comes, each is thrown. For
// tests of what happens when a device fails.
#pragma once
#include "renderer/device_error.h"
#include "renderer/frame_step.h"

#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace proxima {

struct Fault {
    DeviceError::Kind kind = DeviceError::Kind::lost;
    int64_t frame = 0;
    FrameStep step = FrameStep::trace;
    std::string device{}; ///< empty: whichever comes first
    uint32_t times = 1;

    friend bool operator==(const Fault&, const Fault&) = default;
};

/// "KIND@frameN:STEP[:DEVICE][*TIMES]" and more of them after commas; KIND is gpu-lost or out-of-memory, and STEP one
/// of frame_step_names. Throws UsageError.
std::vector<Fault> parse_faults(std::string_view text);

class FaultPlan {
public:
    explicit FaultPlan(std::vector<Fault> faults = {}) : faults_(std::move(faults)) {}

    /// Throws the fault that is planned for this step on this device, if there is one. Any thread.
    void strike(const std::string& device, int64_t frame, FrameStep step);

private:
    std::mutex mutex_;
    std::vector<Fault> faults_;
};

} // namespace proxima
