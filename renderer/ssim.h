// SPDX-License-Identifier: Apache-2.0
// How alike two grey pictures look: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli, "Image Quality Assessment:
// From Error Visibility to Structural Similarity", IEEE Transactions on Image Processing, 2004.
#pragma once
#include <cstdint>
#include <optional>
#include <span>

namespace proxima {

/// The mean of the index over all 11 x 11 windows that lie in the picture, weighted by a Gauss function of 1.5 pixels,
/// with K1 = 0.01 and K2 = 0.03. 1 means equal. `white` is the paper's dynamic range. All samples are finite. Nothing
/// for a picture that is smaller than the window. The same pictures give the same bits on any number of threads.
std::optional<double> structural_similarity(std::span<const float> a, std::span<const float> b, uint32_t width,
                                            uint32_t height, double white);

} // namespace proxima
