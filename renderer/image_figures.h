// SPDX-License-Identifier: Apache-2.0
// Two comparable pictures in, their difference in figures out.
#pragma once
#include "renderer/image_pair.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace proxima {

/// A pixel and what both pictures hold there, in the pair's numbers.
struct WorstPixel {
    uint32_t x = 0, y = 0; ///< from the left and the top, from 0
    std::vector<float> a{}, b{};
};

/// Errors are differences of a sample, white being 1. A pixel with a sample that is not finite is counted as such, is
/// always over the tolerance, and is left out of the other figures.
struct ImageFigures {
    uint64_t pixels = 0;
    uint64_t non_finite_a = 0, non_finite_b = 0; ///< pixels
    uint64_t pixels_over = 0;                    ///< with a sample that is further off than the tolerance
    double max_error = 0;
    double rms_error = 0;
    std::optional<double> psnr{};      ///< dB; nothing when the pictures are equal
    std::optional<double> ssim{};      ///< of the luma; nothing for pictures under 11 pixels a side
    std::optional<WorstPixel> worst{}; ///< the first that is not finite, else the first with the largest error
};

/// Whether a difference is more than the tolerance; 2/65535 times 65535 may be a little less than 2.
constexpr bool is_over(double error, double tolerance) {
    return error > tolerance * (1 + 1e-12);
}

/// `tolerance` has white as 1; a difference of just that is within it.
ImageFigures measure(const ImagePair& pair, double tolerance);

} // namespace proxima
