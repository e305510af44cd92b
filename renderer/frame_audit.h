// SPDX-License-Identifier: Apache-2.0
// Looks at the files of frames: which are there, whole, and what this run would write?
#pragma once
#include "renderer/frame_hash.h"
#include "renderer/scene_source.h"

#include <filesystem>
#include <string>
#include <vector>

namespace proxima {

enum class FrameState {
    complete,
    missing,
    corrupt, ///< not a whole picture of finite numbers
    foreign, ///< of another scene, or made with other options
};

struct AuditedFrame {
    int64_t frame = 0;
    std::filesystem::path file{};
    FrameState state = FrameState::missing;
    std::string reason{}; ///< why it is not complete
};

/// The frames of `options`, in their order. Every file that is there is read to its end. A frame by any of `backends`
/// is complete. Throws what evaluating a scene throws, and FileError when no picture can be read at all.
std::vector<AuditedFrame> audit_frames(const RenderOptions& options, SceneSource& scene, const FrameHash& hash,
                                       const std::vector<std::string>& backends);

} // namespace proxima
