// SPDX-License-Identifier: Apache-2.0
// With image_encoder.cpp the only file that uses OpenImageIO. A damaged file must not be taken for a picture:
// OpenImageIO reads what is missing as black, and some of its readers only leave an error message behind.
#include "renderer/image_decoder.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace proxima {
namespace {

constexpr int max_side = 65536;
constexpr uint64_t max_samples = uint64_t(1) << 33;

[[noreturn]] void refuse(const std::string& reason) {
    throw std::runtime_error(reason);
}

/// Of the chosen channels; those beside them may be of any type.
SampleType sample_type(const OIIO::ImageSpec& spec, const std::vector<int>& chosen) {
    const OIIO::TypeDesc first = spec.channelformat(chosen.front());
    if (std::any_of(chosen.begin(), chosen.end(), [&](int channel) { return spec.channelformat(channel) != first; }))
        refuse("its channels are of different types");
    switch (first.basetype) {
    case OIIO::TypeDesc::UINT8:
        return SampleType::uint8;
    case OIIO::TypeDesc::UINT16:
        return SampleType::uint16;
    case OIIO::TypeDesc::HALF:
        return SampleType::half;
    case OIIO::TypeDesc::FLOAT:
        return SampleType::float32;
    default:
        refuse(std::string("its samples are of type ") + first.c_str() +
               "; only 8 and 16 bits, half and float are compared");
    }
}

void refuse_other_forms(const OIIO::ImageSpec& spec) {
    if (spec.deep || spec.depth > 1)
        refuse("it is not flat: it has a depth");
    if (spec.width > max_side || spec.height > max_side ||
        spec.image_pixels() * OIIO::imagesize_t(spec.nchannels) > max_samples)
        refuse("it is too large: " + std::to_string(spec.width) + " x " + std::to_string(spec.height) + " x " +
               std::to_string(spec.nchannels));
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height)
        refuse("its pixels cover another area than its frame; write it with the whole frame and no more");
    if (spec.get_int_attribute("Orientation", 1) != 1)
        refuse("its header says that it is to be turned; turn its pixels first");
}

/// Where red, green, blue and, as a fourth, alpha are among a file's channels.
std::vector<int> color_channels(const OIIO::ImageSpec& spec) {
    const int grey = spec.channelindex("Y");
    std::vector<int> indices{spec.channelindex("R"), spec.channelindex("G"), spec.channelindex("B")};
    if (std::find(indices.begin(), indices.end(), -1) != indices.end()) {
        const bool is_grey = spec.nchannels == 1 || (grey >= 0 && spec.nchannels == 2 && spec.alpha_channel >= 0);
        if (!is_grey)
            refuse("it has no channels R, G and B");
        indices.assign(3, std::max(grey, 0));
    }
    if (spec.alpha_channel >= 0)
        indices.push_back(spec.alpha_channel);
    return indices;
}

/// The frame hash that `proxima render` writes, as an attribute or in a sentence.
std::string frame_hash(const OIIO::ImageSpec& spec) {
    constexpr size_t digits = 32;
    std::string hash = spec.get_string_attribute("proxima:hash");
    if (hash.empty()) {
        const std::string sentence = spec.get_string_attribute("ImageDescription");
        if (const size_t at = sentence.rfind("hash "); at != std::string::npos)
            hash = sentence.substr(at + 5);
    }
    const bool is_hash = hash.size() == digits && hash.find_first_not_of("0123456789abcdef") == std::string::npos;
    return is_hash ? hash : std::string();
}

/// The first channels' samples as floats: levels of 8 and 16 bits exactly, the numbers of half and float as they are.
std::vector<float> read_samples(OIIO::ImageInput& input, SampleType type, int channels) {
    std::vector<float> samples(size_t(input.spec().image_pixels()) * size_t(channels));
    if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, samples.data()) || input.has_error())
        refuse(input.geterror());
    if (!is_scene_linear(type))
        for (float& sample : samples)
            sample = float(std::round(double(sample) * full_scale(type)));
    return samples;
}

StoredImage decode(const std::string& path) {
    OIIO::ImageSpec settings;
    settings.attribute("oiio:UnassociatedAlpha", 1); // colours as stored, not multiplied by alpha
    const auto input = OIIO::ImageInput::open(path, &settings);
    if (!input)
        refuse(OIIO::geterror());
    const OIIO::ImageSpec spec = input->spec();
    refuse_other_forms(spec);
    const std::vector<int> chosen = color_channels(spec);
    StoredImage image{.width = uint32_t(spec.width),
                      .height = uint32_t(spec.height),
                      .channels = uint32_t(chosen.size()),
                      .type = sample_type(spec, chosen),
                      .encoding = spec.get_string_attribute("oiio:ColorSpace")};
    image.hash = frame_hash(spec);
    if (image.encoding == "GammaCorrected")
        image.encoding = "Gamma" + std::to_string(spec.get_float_attribute("oiio:Gamma", 2.2f));
    for (int i = 0; i < spec.nchannels; ++i)
        if (std::find(chosen.begin(), chosen.end(), i) == chosen.end())
            image.ignored_channels.push_back(spec.channel_name(i));

    const int channels = 1 + *std::max_element(chosen.begin(), chosen.end());
    const std::vector<float> all = read_samples(*input, image.type, channels);
    if (input->seek_subimage(1, 0))
        refuse("it holds more than one picture");
    const size_t pixels = size_t(image.width) * image.height;
    image.samples.reserve(pixels * chosen.size());
    for (size_t pixel = 0; pixel < pixels; ++pixel)
        for (const int channel : chosen)
            image.samples.push_back(all[pixel * size_t(channels) + size_t(channel)]);
    return image;
}

} // namespace
} // namespace proxima

extern "C" {

proxima::DecodeImage proxima_decode_image;

proxima::StoredImage proxima_decode_image(const std::string& path) {
    return proxima::decode(path);
}
}
