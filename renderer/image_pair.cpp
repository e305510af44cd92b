// SPDX-License-Identifier: Apache-2.0
#include "renderer/image_pair.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <string_view>

namespace proxima {
namespace {

constexpr uint32_t alpha = 3; // the channel

bool is_opaque(const StoredImage& image) {
    const auto opaque = float(full_scale(image.type));
    for (size_t i = alpha; i < image.samples.size(); i += 4)
        if (image.samples[i] != opaque)
            return false;
    return true;
}

void drop_alpha(StoredImage& image) {
    const size_t pixels = image.samples.size() / 4;
    for (size_t pixel = 0; pixel < pixels; ++pixel)
        std::copy_n(image.samples.begin() + ptrdiff_t(pixel * 4), 3, image.samples.begin() + ptrdiff_t(pixel * 3));
    image.samples.resize(pixels * 3);
    image.channels = 3;
}

/// Leaves both with alpha or both without.
void match_alpha(StoredImage& a, StoredImage& b) {
    if (a.channels == b.channels)
        return;
    const bool a_has_it = a.channels == 4;
    StoredImage& image = a_has_it ? a : b;
    if (!is_opaque(image))
        throw NotComparable(fmt::format("{} is see-through in places and {} has no alpha channel; put it on its "
                                        "background first",
                                        a_has_it ? "A" : "B", a_has_it ? "B" : "A"));
    drop_alpha(image);
}

double linear_from_srgb(double value) { // IEC 61966-2-1
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

/// The decoding that a header's word for the encoding means.
std::function<double(double)> decoder(const StoredImage& image) {
    const std::string_view encoding = image.encoding;
    if (encoding == "Linear" || (encoding.empty() && is_scene_linear(image.type)))
        return [](double value) { return value; };
    if (encoding == "sRGB" || encoding.empty())
        return linear_from_srgb;
    double gamma = 0;
    if (encoding.starts_with("Gamma"))
        std::from_chars(encoding.data() + 5, encoding.data() + encoding.size(), gamma);
    if (!(gamma > 0))
        throw NotComparable(fmt::format("the encoding '{}' has no known way to linear light; save the picture as sRGB "
                                        "or linear",
                                        encoding));
    return [gamma](double value) { return value < 0 ? value : std::pow(value, gamma); };
}

void decode_to_linear(StoredImage& image) {
    const auto decode = decoder(image);
    const double white = full_scale(image.type);
    for (size_t i = 0; i < image.samples.size(); ++i) {
        const double value = double(image.samples[i]) / white;
        image.samples[i] = float(i % image.channels == alpha ? value : decode(value));
    }
    image.type = SampleType::float32;
    image.encoding = "Linear";
}

std::string describe(const StoredImage& image) {
    return image.encoding.empty() ? "of no stated encoding" : image.encoding;
}

void refuse_two_encodings(const StoredImage& a, const StoredImage& b) {
    constexpr const char* remedy = "; add --linear to compare both in linear light";
    if (is_scene_linear(a.type) != is_scene_linear(b.type))
        throw NotComparable(fmt::format("{} holds linear numbers and {} levels ({}){}",
                                        is_scene_linear(a.type) ? "A" : "B", is_scene_linear(a.type) ? "B" : "A",
                                        describe(is_scene_linear(a.type) ? b : a), remedy));
    if (!a.encoding.empty() && !b.encoding.empty() && a.encoding != b.encoding)
        throw NotComparable(fmt::format("A's levels are encoded as {}, B's as {}{}", a.encoding, b.encoding, remedy));
}

std::string level_rule(const StoredImage& a, const StoredImage& b) {
    const std::string& encoding = a.encoding.empty() ? b.encoding : a.encoding;
    const std::string levels = encoding.empty() ? "levels" : encoding + " levels";
    if (a.type == b.type)
        return fmt::format("{} of {} bits as stored", levels, a.type == SampleType::uint8 ? 8 : 16);
    return fmt::format("{} of 16 bits; {}'s 8-bit levels times 257", levels, a.type == SampleType::uint8 ? "A" : "B");
}

void widen(StoredImage& image) {
    for (float& sample : image.samples)
        sample *= 257.0f; // 255 becomes 65535
    image.type = SampleType::uint16;
}

} // namespace

ImagePair pair_images(StoredImage a, StoredImage b, bool linear_light) {
    if (a.width != b.width || a.height != b.height)
        throw NotComparable(
            fmt::format("the sizes differ: A is {} x {}, B is {} x {}", a.width, a.height, b.width, b.height));
    match_alpha(a, b);
    if (linear_light) {
        decode_to_linear(a);
        decode_to_linear(b);
    }
    refuse_two_encodings(a, b);
    const std::string rule = is_scene_linear(a.type) ? "linear numbers" : level_rule(a, b);
    if (!is_scene_linear(a.type) && a.type != b.type)
        widen(a.type == SampleType::uint8 ? a : b);
    return {.width = a.width,
            .height = a.height,
            .channels = a.channels,
            .white = full_scale(a.type),
            .is_linear = is_scene_linear(a.type) || a.encoding == "Linear" || b.encoding == "Linear",
            .rule = rule,
            .a = std::move(a.samples),
            .b = std::move(b.samples)};
}

} // namespace proxima
