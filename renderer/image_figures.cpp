// SPDX-License-Identifier: Apache-2.0
#include "renderer/image_figures.h"
#include "renderer/ssim.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_for.h>

namespace proxima {
namespace {

/// What one row adds. Rows are added in order, so that the sums do not depend on the threads.
struct RowFigures {
    uint64_t non_finite_a = 0, non_finite_b = 0, non_finite = 0, over = 0;
    double squares = 0, max_error = 0; ///< in the pair's numbers
    uint32_t worst_x = 0;
    std::optional<uint32_t> non_finite_x; ///< the first
};

bool is_finite(const float* pixel, uint32_t channels) {
    return std::all_of(pixel, pixel + channels, [](float sample) { return std::isfinite(sample); });
}

RowFigures measure_row(const ImagePair& pair, uint32_t y, double limit) {
    RowFigures row;
    for (uint32_t x = 0; x < pair.width; ++x) {
        const size_t first = (size_t(y) * pair.width + x) * pair.channels;
        const bool finite_a = is_finite(&pair.a[first], pair.channels);
        const bool finite_b = is_finite(&pair.b[first], pair.channels);
        row.non_finite_a += !finite_a;
        row.non_finite_b += !finite_b;
        if (!finite_a || !finite_b) {
            ++row.non_finite;
            if (!row.non_finite_x)
                row.non_finite_x = x;
            continue;
        }
        double largest = 0;
        for (uint32_t channel = 0; channel < pair.channels; ++channel) {
            const double error = std::abs(double(pair.a[first + channel]) - double(pair.b[first + channel]));
            largest = std::max(largest, error);
            row.squares += error * error;
        }
        row.over += is_over(largest, limit);
        if (largest > row.max_error) {
            row.max_error = largest;
            row.worst_x = x;
        }
    }
    return row;
}

/// Rec. 709's weights. A pixel that is not finite in one of the pictures is black in both.
void add_luma(const ImagePair& pair, std::vector<float>& a, std::vector<float>& b) {
    const size_t pixels = size_t(pair.width) * pair.height;
    const auto luma = [](const float* pixel) {
        return float(0.2126 * double(pixel[0]) + 0.7152 * double(pixel[1]) + 0.0722 * double(pixel[2]));
    };
    a.resize(pixels);
    b.resize(pixels);
    tbb::parallel_for(size_t(0), pixels, [&](size_t i) {
        const float *pixel_a = &pair.a[i * pair.channels], *pixel_b = &pair.b[i * pair.channels];
        const bool finite = is_finite(pixel_a, 3) && is_finite(pixel_b, 3);
        a[i] = finite ? luma(pixel_a) : 0.0f;
        b[i] = finite ? luma(pixel_b) : 0.0f;
    });
}

WorstPixel pixel_at(const ImagePair& pair, uint32_t x, uint32_t y) {
    const auto first = ptrdiff_t((size_t(y) * pair.width + x) * pair.channels);
    const auto values = [&](const std::vector<float>& samples) {
        return std::vector<float>(samples.begin() + first, samples.begin() + first + ptrdiff_t(pair.channels));
    };
    return {x, y, values(pair.a), values(pair.b)};
}

std::optional<WorstPixel> find_worst(const ImagePair& pair, const std::vector<RowFigures>& rows) {
    for (uint32_t y = 0; y < pair.height; ++y)
        if (rows[y].non_finite_x)
            return pixel_at(pair, *rows[y].non_finite_x, y);
    const auto worst = std::max_element(
        rows.begin(), rows.end(), [](const RowFigures& a, const RowFigures& b) { return a.max_error < b.max_error; });
    if (worst == rows.end() || worst->max_error == 0)
        return std::nullopt;
    return pixel_at(pair, worst->worst_x, uint32_t(worst - rows.begin()));
}

} // namespace

ImageFigures measure(const ImagePair& pair, double tolerance) {
    const double limit = tolerance * pair.white;
    std::vector<RowFigures> rows(pair.height);
    tbb::parallel_for(uint32_t(0), pair.height, [&](uint32_t y) { rows[y] = measure_row(pair, y, limit); });

    ImageFigures figures{.pixels = uint64_t(pair.width) * pair.height};
    uint64_t non_finite = 0;
    double squares = 0;
    for (const RowFigures& row : rows) {
        figures.non_finite_a += row.non_finite_a;
        figures.non_finite_b += row.non_finite_b;
        non_finite += row.non_finite;
        figures.pixels_over += row.over + row.non_finite;
        figures.max_error = std::max(figures.max_error, row.max_error / pair.white);
        squares += row.squares;
    }
    const double samples = double(figures.pixels - non_finite) * double(pair.channels);
    if (squares > 0) {
        figures.rms_error = std::sqrt(squares / samples) / pair.white;
        figures.psnr = -20 * std::log10(figures.rms_error);
    }
    figures.worst = find_worst(pair, rows);
    std::vector<float> luma_a, luma_b;
    add_luma(pair, luma_a, luma_b);
    figures.ssim = structural_similarity(luma_a, luma_b, pair.width, pair.height, pair.white);
    return figures;
}

} // namespace proxima
