// SPDX-License-Identifier: Apache-2.0
// A picture as a file holds it: the numbers themselves, before anything is read into them.
#pragma once
#include "renderer/output_name.h"

#include <cstdint>
#include <string>
#include <vector>

namespace proxima {

struct StoredImage {
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t channels = 3; ///< red, green, blue, and alpha if there are four; a grey file is red = green = blue
    SampleType type = SampleType::uint8;
    std::string encoding{};                      ///< "sRGB", "Linear", "Gamma2.2"; empty when the file does not say
    std::vector<float> samples{};                ///< levels up to full_scale(type); of half and float the numbers
    std::vector<std::string> ignored_channels{}; ///< what the file holds beside the above
    std::string hash{};                          ///< of a file by `proxima render`, see frame_hash.h; empty in others
};

/// The number that stands for white.
constexpr double full_scale(SampleType type) {
    switch (type) {
    case SampleType::uint8:
        return 255;
    case SampleType::uint16:
        return 65535;
    case SampleType::half:
    case SampleType::float32:
        break;
    }
    return 1;
}

} // namespace proxima
