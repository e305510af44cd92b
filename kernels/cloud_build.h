// SPDX-License-Identifier: Apache-2.0
// The distances of a cloud: one pass an axis over the lines of bricks along it, bytes in, bytes out. Distances are
// separable: what an axis adds to those of the axes before it depends on nothing but the bricks of its line (Rosenfeld
// and Pfaltz, "Distance Functions on Digital Pictures", 1968).
#pragma once
#include "kernels/cloud.h"

namespace proxima {

/// The bytes of one line of bricks; what lies beyond its ends is infinitely far from everything.
template <class Byte> struct BrickLine {
    Byte* first;
    int64_t stride;
    int32_t count;

    HD int32_t operator[](int32_t i) const { return i >= 0 && i < count ? int32_t(first[i * stride]) : 1 << 20; }
    HD void store(int32_t i, int32_t distance) const { first[i * stride] = uint8_t(smaller(distance, 255)); }
};

/// For chessboard distances, the least max(|k|, line[i + k]) over all k of a line; for octants over k >= 0 only. No
/// brick farther than the answer is looked at.
HD inline int32_t chessboard_distance(const BrickLine<const uint8_t>& line, int32_t i, bool ahead_only) {
    int32_t distance = line[i];
    for (int32_t k = 1; k < distance && k < line.count; ++k) {
        const int32_t value = ahead_only ? line[i + k] : smaller(line[i - k], line[i + k]);
        distance = smaller(distance, larger(k, value));
    }
    return distance;
}

/// What the distances of empty bricks add up to.
struct DistanceTotal {
    uint64_t sum = 0;
    uint64_t empty = 0;

    HD static DistanceTotal combine(const DistanceTotal& a, const DistanceTotal& b) {
        return {a.sum + b.sum, a.empty + b.empty};
    }
};

/// Brick -> its part of the DistanceTotal.
struct MeasureDistances {
    std::span<const uint8_t> distances;

    HD DistanceTotal operator()(uint32_t brick) const { return {distances[brick], distances[brick] != 0}; }
};

/// The pass along one axis: `in` and `out` are maps of the cloud's bricks. For octants the pass along axis a makes
/// 2^(a+1) maps of 2^a. One item is a piece of a line, so that short grids keep a device busy too.
struct DistancePass {
    CloudView cloud;
    int32_t axis = 0;
    int32_t piece = 1;                 ///< bricks an item
    std::span<const uint8_t> occupied; ///< 0 where a brick is
    std::span<const uint8_t> in{};
    std::span<uint8_t> out{};

    HD uint32_t maps() const { return cloud.metric == Metric::octant ? 2u << axis : 1; }
    HD uint32_t lines() const { return cloud.brick_count() / uint32_t(cloud.size[axis]); }
    HD uint32_t pieces() const {
        return cloud.metric == Metric::city_block ? 1 : uint32_t((cloud.size[axis] + piece - 1) / piece);
    }
    HD uint32_t item_count() const { return maps() * lines() * pieces(); }

    HD void operator()(uint32_t item) const {
        // Neighbouring items touch neighbouring bytes: pieces of one line along x, the same piece of lines elsewhere.
        const uint32_t map = item / lines() / pieces(), within = item % (lines() * pieces());
        const uint32_t line = axis == 0 ? within / pieces() : within % lines();
        const uint32_t part = axis == 0 ? within % pieces() : within / lines();
        const uint32_t width = uint32_t(cloud.size.x), height = uint32_t(cloud.size.y);
        const uint32_t first = axis == 0   ? line * width
                               : axis == 1 ? line % width + line / width * width * height
                                           : line;
        const int64_t stride = axis == 0 ? 1 : axis == 1 ? width : int64_t(width) * height;
        const bool octant = cloud.metric == Metric::octant;
        const size_t source = octant ? map & (maps() / 2 - 1) : 0;
        const bool mirrored = octant && !(map >> axis & 1); // downwards: the line is read from its other end
        const int64_t begin = first + (mirrored ? stride * (cloud.size[axis] - 1) : 0);
        const int64_t way = mirrored ? -stride : stride;
        const BrickLine<const uint8_t> from{in.data() + source * cloud.brick_count() + begin, way, cloud.size[axis]};
        const BrickLine<uint8_t> to{out.data() + size_t(map) * cloud.brick_count() + begin, way, cloud.size[axis]};
        const int32_t start = int32_t(part) * piece, end = smaller(start + piece, cloud.size[axis]);
        if (cloud.metric == Metric::city_block)
            city_block(from, to, first, stride);
        else if (cloud.metric == Metric::euclidean)
            euclidean(from, to, first, stride, start, end);
        else {
            for (int32_t i = start; i < end; ++i)
                to.store(i, chessboard_distance(from, i, octant));
        }
    }

private:
    /// The last pass turns a distance B into what the map holds.
    HD int32_t finished(int32_t distance, size_t brick) const {
        return axis < 2 ? distance : occupied[brick] == 0 ? 0 : distance + 1;
    }
    /// Bricks that touch are 0 apart, so one brick of the way along an axis is free.
    HD void city_block(const BrickLine<const uint8_t>& from, const BrickLine<uint8_t>& to, size_t first,
                       int64_t stride) const {
        int32_t distance = 255;
        for (int32_t i = 0; i < from.count; ++i) {
            distance = smaller(distance + 1, smaller(from[i], smaller(from[i - 1], from[i + 1])));
            to.store(i, distance);
        }
        distance = 255;
        for (int32_t i = from.count; i-- > 0;) {
            distance = smaller(distance + 1, int32_t(to[i]));
            to.store(i, finished(distance, first + size_t(stride * i)));
        }
    }
    HD void euclidean(const BrickLine<const uint8_t>& from, const BrickLine<uint8_t>& to, size_t first, int64_t stride,
                      int32_t start, int32_t end) const {
        for (int32_t i = start; i < end; ++i) {
            int32_t nearest = from[i] * from[i]; // squared
            for (int32_t k = 1; (k - 1) * (k - 1) < nearest && k < from.count; ++k) {
                const int32_t value = smaller(from[i - k], from[i + k]);
                nearest = smaller(nearest, (k - 1) * (k - 1) + smaller(value, 255) * smaller(value, 255));
            }
            int32_t distance = int32_t(square_root(float(nearest)));
            distance -= distance * distance > nearest;
            to.store(i, finished(distance, first + size_t(stride * i)));
        }
    }
};

} // namespace proxima
