// SPDX-License-Identifier: Apache-2.0
// A finished picture in, a file's bytes out: display colours or linear light, rounded as the file wants them. And a
// picture file in, its numbers out.
#pragma once
#include "renderer/image.h"
#include "renderer/image_encoder.h"
#include "renderer/stored_image.h"

#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace proxima {

/// The level of a display value in [0, max]: floor(clip(value, 0, 1) * max + 0.5), which is POV-Ray's rounding. Another
/// `offset` below 1 rounds elsewhere.
template <class Integer> Integer quantize(float value, Integer max, double offset = 0.5) {
    const float clipped = value < 0.0f ? 0.0f : value > 1.0f ? 1.0f : value;
    return Integer(double(clipped) * double(max) + offset);
}

struct ImageFileSettings {
    ImageFormat format = ImageFormat::png;
    SampleType type = SampleType::uint8;
    Compression compression = Compression::zip;
    bool dither = false; ///< see quantize_to_bytes
    AovLayers layers{};  ///< of EXR: channels beside the picture's, from Image::aovs
    ImageFacts facts{};  ///< `software` is this program
};

/// The levels of all samples at 8 bits. With `dither` each is rounded up or down by chance, so that areas keep their
/// mean; the chance depends on the sample's place alone. Those that the image has already are taken as they are.
std::vector<uint8_t> quantize_to_bytes(const Image& image, bool dither = false);

/// What makes files. PNG needs nothing more; the others are made by the image module (image_module.h).
class ImageEncoder {
public:
    /// Starts to load what files of `format` need, on a thread of its own, and returns.
    explicit ImageEncoder(ImageFormat format = ImageFormat::png);

    /// The file's bytes, of any format. `image` holds finite numbers, for half none beyond 65504. Waits for the module
    /// where the format needs it. Throws FileError when the module cannot be loaded, std::runtime_error when the
    /// picture cannot be encoded.
    std::vector<unsigned char> encode(const Image& image, const ImageFileSettings& settings);

    /// What makes one file of many pictures of this size, 8 bits a channel. Throws as encode.
    std::unique_ptr<SequenceEncoder> encode_sequence(uint32_t width, uint32_t height,
                                                     const ImageFileSettings& settings);

private:
    struct Functions {
        EncodeImage* encode;
        MakeSequenceEncoder* make_sequence;
    };
    EncodeImage* encoder_of(ImageFormat format);

    std::shared_future<Functions> functions_;
};

/// Reads a whole picture file, of any kind that OpenImageIO knows. Throws FileError when it cannot be read, is damaged
/// or cut short, or holds something else than one flat picture of 8 or 16 bits, half or float.
StoredImage read_image_file(const std::filesystem::path& path);

} // namespace proxima
