// SPDX-License-Identifier: Apache-2.0
// The files of an animation in, one film out, by ffmpeg.
#pragma once
#include "renderer/color.h"
#include "renderer/frame_rate.h"

#include <filesystem>
#include <vector>

namespace proxima {

class Movie {
public:
    /// Finds out, before anything is rendered, whether the film can be made: throws UsageError for an ending other than
    /// .mp4 and .webm, or without an ffmpeg that can write it, and FileError when `path` cannot be written.
    Movie(std::filesystem::path path, FrameRate rate);

    /// Makes the film of these pictures, in their order. Scene-linear ones are shown through `view`. Throws FileError.
    void make(const std::vector<std::filesystem::path>& pictures, const ColorTransform& view) const;

private:
    std::filesystem::path path_;
    FrameRate rate_;
};

} // namespace proxima
