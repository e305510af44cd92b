// SPDX-License-Identifier: Apache-2.0
// Frames a second as a fraction, and the time code that a frame has at that rate.
#pragma once
#include <cstdint>
#include <string_view>

namespace proxima {

struct FrameRate {
    uint32_t numerator = 24;
    uint32_t denominator = 1;

    /// Frames that a time code counts in a second.
    constexpr uint32_t nominal() const { return (numerator + denominator / 2) / denominator; }
    friend bool operator==(const FrameRate&, const FrameRate&) = default;
};

/// "24", "30000/1001", or a number with a point: 23.976, 29.97 and 59.94 are the rates of television that they stand
/// for. Throws UsageError.
FrameRate parse_frame_rate(std::string_view text);

/// Hours, minutes, seconds and frames since frame 0, without dropping numbers; a day has 24 hours.
struct TimeCode {
    uint32_t hours = 0, minutes = 0, seconds = 0, frames = 0;
};
TimeCode time_code(int64_t frame, const FrameRate& rate);

} // namespace proxima
