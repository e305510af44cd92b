// SPDX-License-Identifier: Apache-2.0
#include "kernels/half.h"

#include <cmath>
#include <doctest/doctest.h>
#include <limits>

using namespace proxima;

namespace {

/// The number of a finite, positive half.
float value_of(uint32_t half) {
    const int exponent = int(half >> 10);
    const float fraction = float(half & 1023) / 1024;
    return exponent ? std::ldexp(1 + fraction, exponent - 15) : std::ldexp(fraction, -14);
}

} // namespace

TEST_CASE("half: every number goes to the nearest half, and from the middle between two to the even one") {
    uint32_t wrong = 0;
    for (uint32_t half = 0; half < 0x7bff; ++half) {
        const float value = value_of(half), next = value_of(half + 1);
        const float middle = value + (next - value) / 2; // exact
        wrong += half_bits(value) != half;
        wrong += half_bits(middle) != half + (half & 1);
        wrong += half_bits(std::nextafter(middle, 0.0f)) != half;
        wrong += half_bits(std::nextafter(middle, 1e9f)) != half + 1;
        wrong += half_bits(-value) != (half | 0x8000);
    }
    CHECK(wrong == 0);
    CHECK(half_bits(largest_half) == 0x7bff);
    CHECK(half_bits(1e-30f) == 0);
}

TEST_CASE("half: samples that no half can be are repaired and counted") {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const float samples[] = {1, std::nanf(""), infinity, -infinity, 70000, -1e30f, 65504, -std::nanf("")};
    const uint16_t expected[] = {0x3c00, 0, 0x7bff, 0xfbff, 0x7bff, 0xfbff, 0x7bff, 0};
    uint16_t halves[8];
    SampleRepairs repairs;
    for (uint32_t i = 0; i < 8; ++i)
        HalveSamples{samples, halves, {&repairs, 1}}(i);
    for (int i = 0; i < 8; ++i)
        CHECK(halves[i] == expected[i]);
    CHECK(repairs.replaced == 4);
    CHECK(repairs.clamped == 2);
}
