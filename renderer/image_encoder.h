// SPDX-License-Identifier: Apache-2.0
// The writing half of the image module, see image_module.h.
#pragma once
#include "kernels/aov_sample.h"
#include "renderer/frame_rate.h"
#include "renderer/output_name.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace proxima {

/// What a file says beside its picture. Nothing in here differs between two runs: no time, no host.
struct ImageFacts {
    std::string software{};                               ///< the program and its version
    std::string scene{};                                  ///< the scene's file name
    std::string hash{};                                   ///< of all that the picture follows from, see frame_hash.h
    std::string color_encoding{};                         ///< "sRGB", "Linear", "Gamma2.4" or empty: where it fits
    std::optional<std::array<float, 8>> chromaticities{}; ///< x and y of red, green, blue and white, of linear light
    std::string color_interop_id{};                       ///< of linear light
    int64_t frame = 0;
    std::optional<FrameRate> rate{}; ///< of an animation
    /// Of the camera, row by row, for vectors that stand to the left; see camera_matrices.h.
    std::optional<std::array<float, 16>> world_to_camera{}, world_to_ndc{};

    /// For formats that know texts alone.
    std::string sentence() const { return "frame " + std::to_string(frame) + " of " + scene + ", hash " + hash; }
};

/// A picture in the form that the file keeps, three channels, rows from top to bottom.
struct EncodeRequest {
    ImageFormat format = ImageFormat::png; ///< see png_file.h for this one
    SampleType type = SampleType::uint8;
    Compression compression = Compression::zip; ///< of EXR
    uint32_t width = 0;
    uint32_t height = 0;
    const void* samples = nullptr;   ///< uint8_t, uint16_t, or float (for half and float32)
    bool samples_are_halves = false; ///< bits of half-floats, instead of floats
    AovLayers layers{};              ///< of EXR
    const AovSample* aovs = nullptr; ///< one a pixel, if there are layers
    ImageFacts facts{};
};

/// The file's bytes, of any format but PNG. The same request gives the same bytes. Throws std::runtime_error.
using EncodeImage = std::vector<unsigned char>(const EncodeRequest& request);

/// Makes a file of many pictures, one after the other.
class SequenceEncoder {
public:
    virtual ~SequenceEncoder() = default;
    /// A picture like the one that the encoder was made for: width * height * 3 bytes. Throws std::runtime_error.
    virtual void append(const unsigned char* levels) = 0;
    /// The file's bytes, after the last picture. Throws std::runtime_error.
    virtual std::vector<unsigned char> finish() = 0;
};

/// For pictures as `request` describes them; its `samples` are not used.
using MakeSequenceEncoder = std::unique_ptr<SequenceEncoder>(const EncodeRequest& request);

inline constexpr const char encoder_function[] = "proxima_encode_image";
inline constexpr const char sequence_encoder_function[] = "proxima_make_sequence_encoder";

} // namespace proxima
