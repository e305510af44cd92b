// SPDX-License-Identifier: Apache-2.0
// Which bricks of a cloud hold something: a bit each, the rows along x padded to whole words, so that the nearest one
// in a row is found a word at a time.
#pragma once
#include "kernels/platform.h"
#include "kernels/vector_math.h"

#include <span>

namespace proxima {

struct BrickMarks {
    static constexpr int32_t nowhere = 1 << 20; ///< a distance that no row has

    std::span<uint32_t> words;
    int32_t words_a_row = 0;

    /// For a cloud of that many bricks along the axes.
    HD static int32_t row_words(const Vec3<int32_t>& size) { return (size.x + 31) / 32; }
    HD static size_t word_count(const Vec3<int32_t>& size) {
        return size_t(row_words(size)) * size_t(size.y) * size_t(size.z);
    }

    /// `row`: y + height * z. Any thread.
    HD void set(uint32_t row, int32_t x) const {
        uint32_t* const word = &row_of(row)[x / 32];
        const uint32_t bit = 1u << (x % 32);
        if (!(load_relaxed(word) & bit))
            atomic_or(word, bit);
    }
    HD bool has(uint32_t row, int32_t x) const { return row_of(row)[x / 32] >> (x % 32) & 1; }

    /// How far the nearest mark of a row is, at most `x` on its way down; at least 255 where there is none so near.
    HD int32_t steps_down(uint32_t row, int32_t x) const {
        const uint32_t* const begin = row_of(row);
        uint32_t word = begin[x / 32] << (31 - x % 32);
        if (word != 0)
            return leading_zeros(word);
        for (int32_t i = x / 32 - 1, steps = x % 32 + 1; i >= 0 && steps < 255; --i, steps += 32)
            if ((word = begin[i]) != 0)
                return steps + leading_zeros(word);
        return nowhere;
    }
    /// The same on its way up.
    HD int32_t steps_up(uint32_t row, int32_t x) const {
        const uint32_t* const begin = row_of(row);
        uint32_t word = begin[x / 32] >> (x % 32);
        if (word != 0)
            return trailing_zeros(word);
        for (int32_t i = x / 32 + 1, steps = 32 - x % 32; i < words_a_row && steps < 255; ++i, steps += 32)
            if ((word = begin[i]) != 0)
                return steps + trailing_zeros(word);
        return nowhere;
    }

private:
    HD uint32_t* row_of(uint32_t row) const { return words.data() + size_t(row) * size_t(words_a_row); }
};

} // namespace proxima
