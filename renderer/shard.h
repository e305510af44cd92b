// SPDX-License-Identifier: Apache-2.0
// A share of an animation's frames, for one of many machines.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

namespace proxima {

/// Every `count`th frame, beginning with number `index`: neighbours cost alike, so shares do.
struct Shard {
    uint32_t index = 0; ///< from 0
    uint32_t count = 1;

    std::vector<int64_t> of(const std::vector<int64_t>& frames) const;
};

/// "2/5" is the second of five; "slurm" is what SLURM_ARRAY_TASK_ID, _MIN, _STEP and _COUNT say. Throws UsageError.
Shard parse_shard(std::string_view text);

} // namespace proxima
