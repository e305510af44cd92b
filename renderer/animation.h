// SPDX-License-Identifier: Apache-2.0
// An animation's frames and the numbers that a scene reads in each of them, as POV-Ray 3.7 has them to the bit.
#pragma once
#include "parser/scene_script.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace proxima {

/// How long each frame is exposed, in steps from frame to frame: the moments that it is the mean of are the middles of
/// `samples` equal parts of the time from `open` to `close`, counted from the frame's own clock.
struct Shutter {
    static constexpr uint32_t most_samples = 1024;

    double open = 0;
    double close = 0;
    uint32_t samples = 1;
};

struct Animation {
    bool is_still = true;
    std::vector<int64_t> frames{0}; ///< to render now, in this order; a still is frame 0
    int64_t initial_frame = 0;
    int64_t final_frame = 0;
    int64_t middle_frame = 0;   ///< in the middle of all frames
    float initial_clock = 0.0f; ///< a still's clock
    float final_clock = 1.0f;
    bool clock_on = false;
    bool cyclic = false; ///< the clock of the last frame stops one step short of final_clock
    Shutter shutter;

    /// A still. `clock_on` reads as true when a clock was asked for.
    static Animation still(std::optional<float> clock);

    /// The animation that runs from the smallest to the largest of `all_frames`, of which `frames` are rendered.
    static Animation sequence(const std::vector<int64_t>& all_frames, std::vector<int64_t> frames);

    /// One frame without a step between frames: POV-Ray's clock is NaN here, ours the initial one with a delta of 0.
    bool has_no_step() const { return !is_still && !cyclic && initial_frame == final_frame; }

    /// The predeclared names in `frame`. The clock is a float32 widened to double; everything else went through text
    /// of six significant digits.
    SceneClock clock(int64_t frame) const { return clock(frame, 0); }
    /// The same some frame steps later; the other numbers are the frame's.
    SceneClock clock(int64_t frame, double steps) const;
    /// The moments that a frame shows, one or more.
    std::vector<SceneClock> moments(int64_t frame) const;
};

} // namespace proxima
