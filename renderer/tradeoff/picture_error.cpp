// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/picture_error.h"
#include "renderer/color.h"
#include "renderer/image_figures.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>
#include <vector>

namespace proxima {
namespace {

constexpr double just_noticeable = 2.3;

struct Lab {
    double l, a, b;
};

/// IEC 61966-2-1.
double encode_srgb(double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// CIE 15: linear Rec.709 in [0, 1] to CIELAB; the white point is that of the primaries' sum.
Lab to_lab(const float* rgb) {
    const double r = rgb[0], g = rgb[1], b = rgb[2];
    const auto f = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
    const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
    const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Image finite(const Image& image) {
    Image copy{image.width, image.height, image.rgb};
    replace_non_finite(copy);
    return copy;
}

void clip(Image& image) {
    for (float& sample : image.rgb)
        sample = std::clamp(sample, 0.0f, 1.0f);
}

/// Of clipped pictures in linear light.
double visible_share(const Image& a, const Image& b) {
    std::vector<uint32_t> rows(a.height);
    tbb::parallel_for(uint32_t(0), a.height, [&](uint32_t y) {
        for (size_t i = size_t(y) * a.width * 3, end = i + size_t(a.width) * 3; i < end; i += 3) {
            const Lab p = to_lab(&a.rgb[i]), q = to_lab(&b.rgb[i]);
            rows[y] += std::hypot(p.l - q.l, p.a - q.a, p.b - q.b) > just_noticeable;
        }
    });
    uint64_t count = 0;
    for (const uint32_t row : rows)
        count += row;
    return double(count) / (double(a.width) * a.height);
}

ImageFigures figures_of(const Image& a, const Image& b) {
    const ImagePair pair{.width = a.width, .height = a.height, .a = a.rgb, .b = b.rgb};
    return measure(pair, 0);
}

} // namespace

void PictureError::widen(const PictureError& other) {
    rms = std::max(rms, other.rms);
    max = std::max(max, other.max);
    levels = std::max(levels, other.levels);
    visible = std::max(visible, other.visible);
    if (other.ssim)
        ssim = ssim ? std::min(*ssim, *other.ssim) : *other.ssim;
}

PictureError measure_error(const Image& picture, const Image& reference) {
    Image a = finite(picture), b = finite(reference);
    const ImageFigures linear = figures_of(a, b);
    PictureError error{.rms = linear.rms_error, .max = linear.max_error};
    clip(a);
    clip(b);
    error.visible = visible_share(a, b);
    for (Image* image : {&a, &b})
        std::ranges::transform(image->rgb, image->rgb.begin(),
                               [](float sample) { return float(encode_srgb(double(sample))); });
    const ImageFigures shown = figures_of(a, b);
    error.levels = 255 * shown.rms_error;
    error.ssim = shown.ssim;
    return error;
}

} // namespace proxima
