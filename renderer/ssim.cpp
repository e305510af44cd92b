// SPDX-License-Identifier: Apache-2.0
#include "renderer/ssim.h"

#include <array>
#include <cmath>
#include <tbb/parallel_for.h>
#include <vector>

namespace proxima {
namespace {

constexpr uint32_t window = 11;
constexpr double deviation = 1.5; // pixels
constexpr uint32_t rows_a_task = 64;

/// Weighted sums over a window.
struct Moments {
    double a = 0, b = 0, aa = 0, bb = 0, ab = 0;

    void add(double weight, const Moments& other) {
        a += weight * other.a;
        b += weight * other.b;
        aa += weight * other.aa;
        bb += weight * other.bb;
        ab += weight * other.ab;
    }
};

std::array<double, window> window_weights() {
    std::array<double, window> weights{};
    double sum = 0;
    for (uint32_t i = 0; i < window; ++i) {
        const double x = double(i) - (window - 1) / 2;
        weights[i] = std::exp(-x * x / (2 * deviation * deviation));
        sum += weights[i];
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

/// The index of one window (the paper's equation 13).
double similarity(const Moments& m, double white) {
    const double c1 = 0.01 * white * 0.01 * white, c2 = 0.03 * white * 0.03 * white;
    const double variance_a = m.aa - m.a * m.a, variance_b = m.bb - m.b * m.b, covariance = m.ab - m.a * m.b;
    return (2 * m.a * m.b + c1) * (2 * covariance + c2) /
           ((m.a * m.a + m.b * m.b + c1) * (variance_a + variance_b + c2));
}

} // namespace

std::optional<double> structural_similarity(std::span<const float> a, std::span<const float> b, uint32_t width,
                                            uint32_t height, double white) {
    if (width < window || height < window)
        return std::nullopt;
    const auto weights = window_weights();
    const uint32_t columns = width - window + 1, rows = height - window + 1;
    std::vector<double> row_sums(rows);
    const uint32_t tasks = (rows + rows_a_task - 1) / rows_a_task;
    tbb::parallel_for(uint32_t(0), tasks, [&](uint32_t task) {
        const uint32_t first = task * rows_a_task, last = std::min(rows, first + rows_a_task);
        // The window is a product: first along the rows, then down the columns.
        std::vector<Moments> along(size_t(last - first + window - 1) * columns);
        for (uint32_t y = first; y < last + window - 1; ++y)
            for (uint32_t x = 0; x < columns; ++x)
                for (uint32_t i = 0; i < window; ++i) {
                    const size_t at = size_t(y) * width + x + i;
                    const double va = double(a[at]), vb = double(b[at]);
                    along[size_t(y - first) * columns + x].add(weights[i], {va, vb, va * va, vb * vb, va * vb});
                }
        for (uint32_t y = first; y < last; ++y)
            for (uint32_t x = 0; x < columns; ++x) {
                Moments moments;
                for (uint32_t i = 0; i < window; ++i)
                    moments.add(weights[i], along[size_t(y - first + i) * columns + x]);
                row_sums[y] += similarity(moments, white);
            }
    });
    double sum = 0;
    for (const double row : row_sums)
        sum += row;
    return sum / (double(rows) * double(columns));
}

} // namespace proxima
