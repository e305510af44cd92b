// SPDX-License-Identifier: Apache-2.0
// What a run cost, as one JSON object: the --stats-json file.
#pragma once
#include "renderer/frame_renderer.h"
#include "renderer/scene_facts.h"
#include "renderer/timeline.h"
#include "renderer/tradeoff/picture_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace proxima {

struct FrameRecord {
    int64_t frame = 0;
    std::string file{};
    std::string device{};
    std::string precision{};
    SceneFacts scene{};
    std::string hash{}; ///< of all that the file follows from, see frame_hash.h
    FrameStatistics statistics{};
    uint64_t replaced_samples = 0; ///< not finite, see replace_non_finite
    uint64_t clamped_samples = 0;  ///< beyond what a half holds
    uint64_t host_bytes = 0;       ///< resident when the frame was rendered
    double color_ms = 0, encode_ms = 0, write_ms = 0;
};

/// What --max-error chose.
struct QualityRecord {
    std::string max_error; ///< as it was asked for
    std::string options;
    std::string pilot;
    double pilot_ms = 0;
    PictureError predicted;
    std::optional<PictureError> measured{};
};

struct RunRecord {
    std::string scene;
    uint32_t width = 0, height = 0, samples = 1;
    double parse_ms = 0;
    double evaluate_ms = 0; ///< all frames together
    double wall_ms = 0;
    uint64_t spheres = 0; ///< in the first frame; ellipsoids included
    uint64_t moving = 0;
    std::optional<QualityRecord> quality{};
    std::vector<FrameRecord> frames{};
};

/// The JSON text, ending in a line's end; with what ran when. `peak_host_bytes` is read from the system.
std::string to_json(const RunRecord& run, const Timeline& timeline = {});

} // namespace proxima
