// SPDX-License-Identifier: Apache-2.0
// A picture in memory: linear Rec.709, three floats a pixel, rows from top to bottom.
#pragma once
#include <cstdint>
#include <vector>

namespace proxima {

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> rgb; ///< width * height * 3
};

} // namespace proxima
