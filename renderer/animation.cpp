// SPDX-License-Identifier: Apache-2.0
#include "renderer/animation.h"

#include <algorithm>
#include <charconv>

namespace proxima {
namespace {

/// `value` as POV-Ray hands it to the scene: written with six significant digits and read again.
double through_text(double value) {
    char text[32];
    const auto written = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6);
    double result = 0;
    std::from_chars(text, written.ptr, result);
    return result;
}

} // namespace

Animation Animation::still(std::optional<float> clock) {
    Animation animation;
    animation.initial_clock = clock.value_or(0.0f);
    animation.clock_on = clock.has_value();
    return animation;
}

Animation Animation::sequence(const std::vector<int64_t>& all_frames, std::vector<int64_t> frames) {
    const auto [smallest, largest] = std::minmax_element(all_frames.begin(), all_frames.end());
    Animation animation;
    animation.is_still = false;
    animation.clock_on = true;
    animation.initial_frame = *smallest;
    animation.final_frame = *largest;
    animation.middle_frame = all_frames[all_frames.size() / 2];
    animation.frames = std::move(frames);
    return animation;
}

SceneClock Animation::clock(int64_t frame, double steps) const {
    SceneClock time;
    time.clock_on = clock_on;
    if (is_still) {
        time.clock = double(initial_clock);
        return time;
    }
    const int64_t last = final_frame + (cyclic ? 1 : 0);
    // The range of the clock is rounded to float, its division among the frames is not.
    const double delta = has_no_step() ? 0.0 : double(final_clock - initial_clock) / double(last - initial_frame);
    time.clock = double(float(double(initial_clock) + (double(frame - initial_frame) + steps) * delta));
    time.clock_delta = through_text(delta);
    time.frame_number = through_text(double(frame));
    time.initial_frame = through_text(double(initial_frame));
    time.final_frame = through_text(double(last));
    time.initial_clock = through_text(initial_clock);
    time.final_clock = through_text(final_clock);
    return time;
}

std::vector<SceneClock> Animation::moments(int64_t frame) const {
    std::vector<SceneClock> result;
    for (uint32_t i = 0; i < shutter.samples; ++i)
        result.push_back(
            clock(frame, shutter.open + (shutter.close - shutter.open) * (i + 0.5) / double(shutter.samples)));
    return result;
}

} // namespace proxima
