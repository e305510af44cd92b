// SPDX-License-Identifier: Apache-2.0
// The steps that a frame goes through, by name, and who is told when one begins and ends: the timeline, and tests that
// make one fail.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>

namespace proxima {

enum class FrameStep { motion, build, map, choose, relay, trace, read_back, color, encode, write };

inline constexpr std::array<const char*, 10> frame_step_names{"motion", "build",     "map",   "choose", "relay",
                                                              "trace",  "read-back", "color", "encode", "write"};

inline const char* name_of(FrameStep step) {
    return frame_step_names[size_t(step)];
}

/// Is told of the steps on the thread that takes them. What it throws ends the frame.
class StepWatch {
public:
    using Time = std::chrono::steady_clock::time_point;

    virtual ~StepWatch() = default;
    virtual void begin(FrameStep) {}
    virtual void end(FrameStep, Time /*begin*/, Time /*end*/) {}
    /// Who is told of what another device does for the frame.
    virtual StepWatch* builder() { return this; }
};

/// Takes a step: tells `watch`, which may be null, and adds the milliseconds to `total`.
template <class Work> void take_step(StepWatch* watch, FrameStep step, double& total, const Work& work) {
    if (watch)
        watch->begin(step);
    const auto begin = std::chrono::steady_clock::now();
    work();
    const auto end = std::chrono::steady_clock::now();
    total += std::chrono::duration<double, std::milli>(end - begin).count();
    if (watch)
        watch->end(step, begin, end);
}

} // namespace proxima
