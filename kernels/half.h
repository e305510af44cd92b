// SPDX-License-Identifier: Apache-2.0
// A picture of floats in, one of half-floats out, as scene-linear files keep them: half the way over the bus.
#pragma once
#include "kernels/platform.h"

#include <bit>
#include <cstdint>
#include <span>

namespace proxima {

inline constexpr float largest_half = 65504.0f;

/// The bits of the nearest half; of two that are equally near, the even one. `value` is at most `largest_half` away
/// from 0.
HD inline uint16_t half_bits(float value) {
    const uint32_t bits = std::bit_cast<uint32_t>(value);
    const uint32_t sign = bits >> 16 & 0x8000u, magnitude = bits & 0x7fffffffu;
    if (magnitude < 0x38800000u) { // below the normal halves, whose steps are those of floats from 0.5 to 1
        const float shifted = std::bit_cast<float>(magnitude) + 0.5f;
        return uint16_t(sign | (std::bit_cast<uint32_t>(shifted) - 0x3f000000u));
    }
    const uint32_t rounded = magnitude + 0xfffu + (magnitude >> 13 & 1u) - 0x38000000u;
    return uint16_t(sign | rounded >> 13);
}

/// Samples that could not stay as they were.
struct SampleRepairs {
    uint32_t replaced = 0; ///< not finite: NaN becomes 0, infinity the largest half
    uint32_t clamped = 0;  ///< beyond the largest half
};

/// Sample -> half, and in `repairs` how many were repaired.
struct HalveSamples {
    std::span<const float> samples;
    std::span<uint16_t> halves;
    std::span<SampleRepairs> repairs; ///< one

    HD void operator()(uint32_t index) const {
        float value = samples[index];
        const uint32_t magnitude = std::bit_cast<uint32_t>(value) & 0x7fffffffu;
        constexpr uint32_t infinite = 0x7f800000u;
        if (magnitude >= infinite)
            atomic_add(&repairs[0].replaced, 1);
        else if (magnitude > std::bit_cast<uint32_t>(largest_half))
            atomic_add(&repairs[0].clamped, 1);
        if (magnitude > infinite)
            value = 0;
        else if (magnitude > std::bit_cast<uint32_t>(largest_half))
            value = value < 0 ? -largest_half : largest_half;
        halves[index] = half_bits(value);
    }
};

} // namespace proxima
