// SPDX-License-Identifier: Apache-2.0
// One line of bricks along an axis: the distances of the axes before it in, those with this axis out. Distances are
// separable: what an axis adds depends on nothing but the bricks of its line (Rosenfeld and Pfaltz, "Distance Functions
// on Digital Pictures", 1968).
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// The bytes of one line of bricks; what lies beyond its ends is infinitely far from everything.
template <class Byte> struct BrickLine {
    static constexpr int32_t beyond = 1 << 20;

    Byte* first;
    int64_t stride;
    int32_t count;

    HD int32_t operator[](int32_t i) const { return i >= 0 && i < count ? int32_t(first[i * stride]) : beyond; }
    HD void store(int32_t i, int32_t distance) const { first[i * stride] = uint8_t(smaller(distance, 255)); }
};

/// For chessboard distances, the least max(|k|, line[i + k]) over all k of a line; for octants over k >= 0 only. Looks
/// a few bricks farther than the answer at most: `together` of them are on their way from memory at once.
HD inline int32_t chessboard_distance(const BrickLine<const uint8_t>& line, int32_t i, bool ahead_only) {
    constexpr int32_t together = 4;
    int32_t distance = line[i];
    for (int32_t k = 1; k < distance && k < line.count; k += together) {
        int32_t values[together];
        for (int32_t j = 0; j < together; ++j)
            values[j] = ahead_only ? line[i + k + j] : smaller(line[i - k - j], line[i + k + j]);
        for (int32_t j = 0; j < together; ++j)
            distance = smaller(distance, larger(k + j, values[j]));
    }
    return distance;
}

/// The chessboard distances of one brick of a line after the other. From a brick to the next the distance changes by at
/// most one, so that of its window, the bricks no farther away, only the far end is new. What the distance comes from
/// is kept, and what is left behind is looked for further on: each brick is seen about twice, whatever the distances.
class ChessboardScan {
public:
    HD ChessboardScan(const BrickLine<const uint8_t>& line, int32_t start)
        : line_(line), at_(start), distance_(chessboard_distance(line, start, false)), witness_(start - distance_) {}

    HD int32_t distance() const { return distance_; }
    HD void advance() {
        ++at_;
        const int32_t last = line_[at_ + distance_ - 1], next = line_[at_ + distance_];
        if (last < distance_) {
            --distance_;
            see(at_ + distance_, line_.beyond);
            return;
        }
        if (next <= distance_)
            see(at_ + distance_, line_.beyond);
        else if (last <= distance_)
            see(at_ + distance_ - 1, next);
        else
            least_ = smaller(least_, smaller(last, next));
        if (witness_ < at_ - distance_)
            look_on();
    }

private:
    HD void see(int32_t witness, int32_t least) {
        witness_ = witness;
        least_ = least;
    }
    /// To the next brick that gives the same distance, which is longer by one if there is none in the window.
    HD void look_on() {
        if (least_ <= distance_) {
            const int32_t end = smaller(at_ + distance_ + 1, line_.count);
            int32_t least = line_.beyond;
            for (int32_t i = witness_ + 1; i < end; ++i) {
                const int32_t value = line_[i];
                if (value <= distance_)
                    return see(i, 0);
                least = smaller(least, value);
            }
            least_ = least;
        }
        ++distance_;
    }

    BrickLine<const uint8_t> line_;
    int32_t at_;
    int32_t distance_;
    int32_t witness_;   ///< a brick no farther than the distance, whose number is no larger; once looked for
    int32_t least_ = 0; ///< of the numbers behind it in the window; or less, where they have not been seen
};

} // namespace proxima
