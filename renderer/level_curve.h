// SPDX-License-Identifier: Apache-2.0
// Rendered numbers in, levels of 8 bits out, for colours that go through a curve for each channel: a table made of what
// the conversion itself says, so that no level differs from its own.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace proxima {

class LevelCurve {
public:
    /// Turns rendered red, green and blue of any number of pixels into a display's, in place.
    using Convert = std::function<void(std::span<float> rgb)>;

    /// For a conversion whose channels do not mix and keep the order of numbers. None where a table would not do: the
    /// order is turned around, numbers below 0 make another level than 0, or levels follow each other too closely.
    static std::optional<LevelCurve> of(const Convert& convert);

    /// The levels that quantize() gives for converted samples: three a pixel, finite, as many out as in.
    void apply(std::span<const float> rgb, std::span<uint8_t> levels) const;

private:
    static constexpr unsigned bin_bits = 16; ///< of a float that its bin leaves out: 128 bins for each power of two

    /// One channel's.
    struct Steps {
        std::array<float, 256> next{};   ///< the least number of the following level; infinity after the last
        std::vector<uint8_t> first_of{}; ///< the level of each bin's least number; no bin has more than two

        friend bool operator==(const Steps&, const Steps&) = default;
        uint8_t level(float number) const;
    };

    std::array<Steps, 3> channels_;
    bool are_equal_ = false;
};

} // namespace proxima
