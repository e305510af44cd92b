// SPDX-License-Identifier: Apache-2.0
#include "renderer/image_file.h"
#include "parser/source_files.h"
#include "renderer/image_decoder.h"
#include "renderer/image_module.h"
#include "renderer/png_file.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <string_view>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

namespace proxima {
namespace {

/// A number from 0 to 1 for a sample: the mixing steps of MurmurHash3 (Appleby).
double chance(uint64_t sample) {
    uint64_t mixed = sample + 0x9e3779b97f4a7c15u;
    mixed = (mixed ^ (mixed >> 33)) * 0xff51afd7ed558ccdu;
    mixed = (mixed ^ (mixed >> 33)) * 0xc4ceb9fe1a85ec53u;
    return double((mixed ^ (mixed >> 33)) >> 11) * 0x1p-53;
}

template <class Integer> std::vector<Integer> quantize_all(const Image& image, bool dither) {
    std::vector<Integer> samples(image.rgb.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, samples.size(), 1 << 16), [&](const auto& range) {
        for (size_t i = range.begin(); i != range.end(); ++i)
            samples[i] = quantize<Integer>(image.rgb[i], std::numeric_limits<Integer>::max(), dither ? chance(i) : 0.5);
    });
    return samples;
}

EncodeRequest request_for(uint32_t width, uint32_t height, const ImageFileSettings& settings) {
    EncodeRequest request{.format = settings.format,
                          .type = settings.type,
                          .compression = settings.compression,
                          .width = width,
                          .height = height,
                          .layers = settings.layers,
                          .facts = settings.facts};
    request.facts.software = "Proxima " PROXIMA_VERSION;
    return request;
}

std::string first_line(std::string_view text) {
    return std::string(text.substr(0, text.find('\n')));
}

} // namespace

std::vector<uint8_t> quantize_to_bytes(const Image& image, bool dither) {
    return image.levels.empty() ? quantize_all<uint8_t>(image, dither) : image.levels;
}

ImageEncoder::ImageEncoder(ImageFormat format)
    : functions_(std::async(format == ImageFormat::png ? std::launch::deferred : std::launch::async, [] {
                     return Functions{image_module_function<EncodeImage>(encoder_function),
                                      image_module_function<MakeSequenceEncoder>(sequence_encoder_function)};
                 }).share()) {}

EncodeImage* ImageEncoder::encoder_of(ImageFormat format) {
    return format == ImageFormat::png ? encode_png : functions_.get().encode;
}

std::vector<unsigned char> ImageEncoder::encode(const Image& image, const ImageFileSettings& settings) {
    EncodeRequest request = request_for(image.width, image.height, settings);
    EncodeImage* const encode = encoder_of(settings.format);
    switch (settings.type) {
    case SampleType::uint8: {
        if (!image.levels.empty()) {
            request.samples = image.levels.data();
            return encode(request);
        }
        const auto samples = quantize_to_bytes(image, settings.dither);
        request.samples = samples.data();
        return encode(request);
    }
    case SampleType::uint16: {
        const auto samples = quantize_all<uint16_t>(image, settings.dither);
        request.samples = samples.data();
        return encode(request);
    }
    case SampleType::half:
    case SampleType::float32:
        break;
    }
    request.aovs = image.aovs.data();
    request.samples_are_halves = !image.halves.empty();
    request.samples = request.samples_are_halves ? static_cast<const void*>(image.halves.data()) : image.rgb.data();
    return encode(request);
}

std::unique_ptr<SequenceEncoder> ImageEncoder::encode_sequence(uint32_t width, uint32_t height,
                                                               const ImageFileSettings& settings) {
    return functions_.get().make_sequence(request_for(width, height, settings));
}

StoredImage read_image_file(const std::filesystem::path& path) {
    if (::access(path.c_str(), R_OK) != 0)
        throw FileError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
    if (std::error_code error; !std::filesystem::is_regular_file(path, error))
        throw FileError(fmt::format("{}: cannot be read: it is not a file", path.string()));
    DecodeImage* const decode = image_module_function<DecodeImage>(decoder_function);
    try {
        return decode(path.string());
    } catch (const std::runtime_error& reason) {
        throw FileError(fmt::format("{}: not a readable picture: {}", path.string(), first_line(reason.what())));
    }
}

} // namespace proxima
