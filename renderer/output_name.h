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

enum class ImageFormat { png, exr, tiff, jpeg, gif };
enum class SampleType { uint8, uint16, half, float32 };

/// Of EXR. All but dwaa keep every bit of the samples.
enum class Compression { zip, zips, piz, dwaa, none };

/// A GIF holds all frames of an animation; of the other formats each frame has a file.
constexpr bool holds_animation(ImageFormat format) {
    return format == ImageFormat::gif;
}

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

/// What --compression means; zip without it. Throws UsageError for a format that has no choice.
Compression choose_compression(ImageFormat format, const std::optional<std::string>& name);

} // namespace proxima
