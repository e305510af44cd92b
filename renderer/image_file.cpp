// SPDX-License-Identifier: Apache-2.0
#include "renderer/image_file.h"
#include "parser/source_files.h"
#include "renderer/image_decoder.h"
#include "renderer/image_module.h"

#include <algorithm>
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

constexpr float largest_half = 65504.0f; // beyond it a half is infinite

template <class Output, class Convert> std::vector<Output> convert_samples(const Image& image, const Convert& convert) {
    std::vector<Output> samples(image.rgb.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, samples.size(), 1 << 16), [&](const auto& range) {
        for (size_t i = range.begin(); i != range.end(); ++i)
            samples[i] = convert(image.rgb[i]);
    });
    return samples;
}

template <class Integer> std::vector<Integer> quantize_all(const Image& image) {
    return convert_samples<Integer>(
        image, [](float value) { return quantize<Integer>(value, std::numeric_limits<Integer>::max()); });
}

std::string first_line(std::string_view text) {
    return std::string(text.substr(0, text.find('\n')));
}

} // namespace

ImageEncoder::ImageEncoder()
    : function_(std::async(std::launch::async, image_module_function<EncodeImage>, encoder_function).share()) {}

std::vector<unsigned char> ImageEncoder::encode(const Image& image, const ImageFileSettings& settings) {
    EncodeRequest request{.format = settings.format,
                          .type = settings.type,
                          .width = image.width,
                          .height = image.height,
                          .samples = image.rgb.data(),
                          .color_encoding = settings.color_encoding,
                          .software = "Proxima " PROXIMA_VERSION,
                          .scene = settings.scene,
                          .frame = settings.frame};
    EncodeImage* const encode = function_.get();
    switch (settings.type) {
    case SampleType::uint8: {
        const auto samples = quantize_all<uint8_t>(image);
        request.samples = samples.data();
        return encode(request);
    }
    case SampleType::uint16: {
        const auto samples = quantize_all<uint16_t>(image);
        request.samples = samples.data();
        return encode(request);
    }
    case SampleType::half: {
        const auto samples =
            convert_samples<float>(image, [](float value) { return std::clamp(value, -largest_half, largest_half); });
        request.samples = samples.data();
        return encode(request);
    }
    case SampleType::float32:
        break;
    }
    return encode(request);
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
