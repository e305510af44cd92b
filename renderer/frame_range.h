// SPDX-License-Identifier: Apache-2.0
// Lists of frame numbers as people and farms write them: 1-100, 1-100x2, 1-100:2, 1,3,5..9, 10-1x-1, -10--5.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

namespace proxima {

inline constexpr int64_t max_frame_number = 1'000'000'000; ///< and its negative
inline constexpr int64_t max_frame_count = 1'000'000;

/// The frames in the order written, each once. `x` and `:` both give the step; without one a range counts by 1 towards
/// its end. `option` names the command-line option in messages. Throws UsageError, before anything large is built.
std::vector<int64_t> parse_frame_range(std::string_view option, std::string_view text);

} // namespace proxima
