// SPDX-License-Identifier: Apache-2.0
// Where pictures go and what kind of file holds them: the -o option's text in, one path a frame out.
// The frame number stands where the file name has `####` (n >= 2 hashes are n digits, one hash is four) or `%04d`.
#pragma once
#include "renderer/numbered_name.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace proxima {

enum class ImageFormat { png, exr, tiff, jpeg };
enum class SampleType { uint8, uint16, half, float32 };

/// Half and float files hold scene-linear light; the others what a display shows.
constexpr bool is_scene_linear(SampleType type) {
    return type == SampleType::half || type == SampleType::float32;
}

class OutputName {
public:
    /// Throws UsageError when the ending names no format, or the name has two places for the frame number.
    explicit OutputName(const std::filesystem::path& pattern);

    bool has_frame_number() const { return name_.has_number(); }
    ImageFormat format() const { return format_; }

    /// The file of `frame`. Without a place for a number every frame has the same name.
    std::filesystem::path path(int64_t frame) const { return name_.path(frame); }

private:
    NumberedName name_;
    ImageFormat format_;
};

/// The sample type that --bits means for a file of this format; without --bits 8 bits, and half for EXR.
/// Throws UsageError naming what fits.
SampleType choose_sample_type(ImageFormat format, const std::optional<std::string>& bits);

} // namespace proxima
