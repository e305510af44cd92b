// SPDX-License-Identifier: Apache-2.0
// Two pictures as files hold them in, the same two on one scale out, or the reason why their numbers cannot be
// compared.
#pragma once
#include "renderer/stored_image.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace proxima {

/// Two pictures of one size whose samples mean the same.
struct ImagePair {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 3;  ///< red, green, blue, and alpha where both have it
    double white = 1;       ///< the number that stands for white: 255, 65535 or 1
    bool is_linear = false; ///< linear light; else what a display shows
    std::string rule{};     ///< what is compared, for the reader of the figures
    std::vector<float> a{}, b{};
};

/// Pictures whose difference has no meaning. The message says why, and what to do.
struct NotComparable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Levels of 8 and 16 bits are compared as stored, 8 bits times 257 where the other file has 16; half and float as
/// numbers. With `linear_light` every picture is first decoded by what its header says (sRGB, Gamma; levels of unknown
/// encoding are sRGB). Alpha is compared where both have it; where one has it, it must be opaque.
/// Throws NotComparable for pictures of two sizes or two encodings, and for a see-through picture beside one without
/// alpha.
ImagePair pair_images(StoredImage a, StoredImage b, bool linear_light);

} // namespace proxima
