// SPDX-License-Identifier: Apache-2.0
// A picture in memory: linear Rec.709, three floats a pixel, rows from top to bottom.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace proxima {

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> rgb; ///< width * height * 3

    /// Makes it a picture of that size, unless it is one: its rows may then be written by several threads.
    void fit(uint32_t new_width, uint32_t new_height) {
        const std::size_t size = std::size_t(new_width) * new_height * 3;
        if (width == new_width && height == new_height && rgb.size() == size)
            return;
        width = new_width;
        height = new_height;
        rgb.resize(size);
    }
    float* row(uint32_t y) { return rgb.data() + std::size_t(y) * width * 3; }
};

} // namespace proxima
