// SPDX-License-Identifier: Apache-2.0
#include "renderer/level_curve.h"
#include "renderer/image_file.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace proxima {
namespace {

constexpr size_t levels = 256;
constexpr float largest = std::numeric_limits<float>::max();

/// Numbers from 0 on, as integers in the same order.
uint32_t place_of(float number) {
    return std::bit_cast<uint32_t>(number);
}
float number_at(uint32_t place) {
    return std::bit_cast<float>(place);
}

using Pixel = std::array<float, 3>;

std::vector<std::array<uint8_t, 3>> converted(std::vector<Pixel> pixels, const LevelCurve::Convert& convert) {
    convert({pixels.data()->data(), pixels.size() * 3});
    std::vector<std::array<uint8_t, 3>> result(pixels.size());
    for (size_t i = 0; i < pixels.size(); ++i)
        for (size_t c = 0; c < 3; ++c)
            result[i][c] = quantize<uint8_t>(pixels[i][c], 255);
    return result;
}

/// The least numbers from 0 on that reach each level from the first on, all looked for together by halving.
std::array<std::vector<float>, 3> least_numbers(const LevelCurve::Convert& convert) {
    constexpr uint32_t none = 0x7f800000; // infinity
    struct Bounds {
        uint32_t low = 0, high = none; ///< it is one of these and those between
    };
    std::vector<std::array<Bounds, 3>> bounds(levels - 1);
    const auto middle = [](const Bounds& b) { return b.low + (b.high - b.low) / 2; };
    for (unsigned round = 0; round < 32; ++round) {
        std::vector<Pixel> probes(bounds.size());
        for (size_t k = 0; k < bounds.size(); ++k)
            for (size_t c = 0; c < 3; ++c)
                probes[k][c] = std::min(number_at(middle(bounds[k][c])), largest);
        const auto met = converted(std::move(probes), convert);
        for (size_t k = 0; k < bounds.size(); ++k)
            for (size_t c = 0; c < 3; ++c)
                if (Bounds& b = bounds[k][c]; b.low < b.high)
                    (met[k][c] > k ? b.high : b.low) = met[k][c] > k ? middle(b) : middle(b) + 1;
    }
    std::array<std::vector<float>, 3> least;
    for (size_t c = 0; c < 3; ++c)
        for (const auto& b : bounds)
            least[c].push_back(number_at(b[c].low));
    return least;
}

} // namespace

std::optional<LevelCurve> LevelCurve::of(const Convert& convert) {
    const auto least = least_numbers(convert);
    const auto ends =
        converted({Pixel{-largest, -largest, -largest}, Pixel{}, Pixel{largest, largest, largest}}, convert);
    LevelCurve curve;
    for (size_t c = 0; c < 3; ++c) {
        Steps& steps = curve.channels_[c];
        std::ranges::copy(least[c], steps.next.begin());
        steps.next.back() = std::numeric_limits<float>::infinity();
        const auto level_of = [&](float number) {
            return size_t(std::ranges::upper_bound(least[c], number) - least[c].begin());
        };
        if (ends[0][c] != ends[1][c] || ends[2][c] != level_of(largest))
            return std::nullopt;
        const uint32_t bins = (place_of(largest) >> bin_bits) + 1;
        for (uint32_t bin = 0; bin < bins; ++bin) {
            const size_t first = level_of(number_at(bin << bin_bits));
            const size_t last = level_of(number_at((bin + 1) * (1u << bin_bits) - 1));
            if (last > first + 1)
                return std::nullopt;
            steps.first_of.push_back(uint8_t(first));
        }
    }
    curve.are_equal_ = curve.channels_[0] == curve.channels_[1] && curve.channels_[0] == curve.channels_[2];
    return curve;
}

inline uint8_t LevelCurve::Steps::level(float number) const {
    const float from_zero = number > 0 ? number : 0.0f;
    const uint8_t first = first_of[place_of(from_zero) >> bin_bits];
    return uint8_t(first + (from_zero >= next[first] ? 1 : 0));
}

void LevelCurve::apply(std::span<const float> rgb, std::span<uint8_t> levels) const {
    if (are_equal_) { // the cache holds one table better than three
        for (size_t i = 0; i < rgb.size(); ++i)
            levels[i] = channels_[0].level(rgb[i]);
        return;
    }
    for (size_t i = 0; i < rgb.size(); i += 3)
        for (size_t c = 0; c < 3; ++c)
            levels[i + c] = channels_[c].level(rgb[i + c]);
}

} // namespace proxima
