// SPDX-License-Identifier: Apache-2.0
#include "renderer/difference_picture.h"
#include "renderer/image_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tbb/parallel_for.h>

namespace proxima {
namespace {

using Color = std::array<float, 3>;

constexpr double finest_level = 1.0 / 65535;
constexpr Color cyan{0, 1, 1};
constexpr Color gap_color{0.5f, 0.5f, 0.5f};
constexpr uint32_t gap = 4; // pixels

/// Colours after the map "magma" (S. van der Walt and N. Smith, 2015; in the public domain), without its dark end.
constexpr Color magma[] = {{0.317f, 0.072f, 0.485f},
                           {0.550f, 0.161f, 0.506f},
                           {0.716f, 0.215f, 0.475f},
                           {0.987f, 0.536f, 0.382f},
                           {0.987f, 0.991f, 0.750f}};

Color magma_color(double position) {
    constexpr size_t last = std::size(magma) - 1;
    const double scaled = std::clamp(position, 0.0, 1.0) * double(last);
    const size_t index = std::min(size_t(scaled), last - 1);
    const auto between = float(scaled - double(index));
    Color color;
    for (size_t i = 0; i < 3; ++i)
        color[i] = magma[index][i] + between * (magma[index + 1][i] - magma[index][i]);
    return color;
}

/// The scale of one map: greys up to the tolerance, then colours in equal steps for equal factors.
struct ErrorScale {
    double tolerance;
    double first_color; ///< the error of the first colour: the tolerance, at least one level

    Color operator()(double error) const {
        if (error == 0)
            return {0, 0, 0};
        if (is_over(error, tolerance))
            return magma_color(1 - std::log(error) / std::log(first_color));
        const auto grey = float(0.1 + 0.3 * error / tolerance);
        return {grey, grey, grey};
    }
};

float encode_srgb(float linear) { // IEC 61966-2-1
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

template <class PixelColor> Image paint(const ImagePair& pair, const PixelColor& color_of) {
    Image image{pair.width, pair.height, {}};
    const size_t pixels = size_t(pair.width) * pair.height;
    image.rgb.resize(pixels * 3);
    tbb::parallel_for(size_t(0), pixels, [&](size_t i) {
        const Color color = color_of(i * pair.channels);
        std::copy(color.begin(), color.end(), image.rgb.begin() + ptrdiff_t(i * 3));
    });
    return image;
}

} // namespace

Image displayed(const ImagePair& pair, const std::vector<float>& samples) {
    return paint(pair, [&](size_t first) {
        Color color;
        for (size_t i = 0; i < 3; ++i) {
            const float value = samples[first + i] / float(pair.white);
            const float clipped = value > 0 ? std::min(value, 1.0f) : 0.0f; // NaN too is black
            color[i] = pair.is_linear ? encode_srgb(clipped) : clipped;
        }
        return color;
    });
}

Image difference_map(const ImagePair& pair, double tolerance) {
    const double level = pair.white == 1 ? finest_level : 1 / pair.white;
    const ErrorScale scale{tolerance, std::min(std::max(tolerance, level), 0.5)};
    return paint(pair, [&](size_t first) {
        double largest = 0;
        for (size_t i = first; i < first + pair.channels; ++i) {
            if (!std::isfinite(pair.a[i]) || !std::isfinite(pair.b[i]))
                return cyan;
            largest = std::max(largest, std::abs(double(pair.a[i]) - double(pair.b[i])) / pair.white);
        }
        return scale(largest);
    });
}

Image side_by_side(const std::vector<Image>& pictures) {
    const Image& first = pictures.front();
    const size_t count = pictures.size();
    Image result{uint32_t(first.width * count + gap * (count - 1)), first.height, {}};
    result.rgb.resize(size_t(result.width) * result.height * 3);
    for (size_t i = 0; i < result.rgb.size(); ++i)
        result.rgb[i] = gap_color[i % 3];
    for (size_t number = 0; number < count; ++number)
        for (uint32_t y = 0; y < first.height; ++y) {
            const auto row = pictures[number].rgb.begin() + ptrdiff_t(size_t(y) * first.width * 3);
            const size_t left = number * (first.width + gap);
            std::copy(row, row + ptrdiff_t(first.width * 3),
                      result.rgb.begin() + ptrdiff_t((size_t(y) * result.width + left) * 3));
        }
    return result;
}

} // namespace proxima
