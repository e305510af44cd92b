// SPDX-License-Identifier: Apache-2.0
// The distances of a cloud: one pass an axis over the lines of bricks along it, each in a time that grows with the
// bricks and not with the distances. Along x they come from the marks, along y and z from the axis before.
#pragma once
#include "kernels/brick_marks.h"
#include "kernels/cloud.h"
#include "kernels/distance_line.h"

namespace proxima {

/// What the distances of empty bricks add up to.
struct DistanceTotal {
    uint64_t sum = 0;
    uint64_t empty = 0;
};

/// The last pass's output of a piece of a line, and what its distances add up to.
struct DistanceSink {
    BrickLine<uint8_t> line;
    uint32_t sum = 0;
    uint32_t empty = 0;

    HD void store(int32_t i, int32_t distance) {
        const int32_t kept = smaller(distance, 255);
        line.first[i * line.stride] = uint8_t(kept);
        sum += uint32_t(kept);
        empty += kept != 0;
    }
};

/// The pass along x: marks in, distances out; for octants two maps of them, downwards and upwards. One item is `group`
/// bricks of a row, 16 where rows are whole groups, so that neighbouring items fill whole lines of memory.
template <int32_t group> struct RowDistances {
    CloudView cloud;
    BrickMarks marks;
    std::span<uint8_t> out{};

    HD static bool fits(const CloudView& cloud) { return cloud.size.x % group == 0; }
    HD uint32_t map_count() const { return cloud.metric == Metric::octant ? 2 : 1; }
    HD uint32_t item_count() const { return map_count() * (cloud.brick_count() / group); }

    HD void operator()(uint32_t item) const {
        const uint32_t groups = cloud.brick_count() / group, map = item / groups;
        const uint32_t brick = (item - map * groups) * group, row = brick / uint32_t(cloud.size.x);
        const int32_t x = int32_t(brick - row * uint32_t(cloud.size.x));
        const bool both = cloud.metric != Metric::octant, down = both || map == 0, up = both || map == 1;
        uint8_t distances[group];
        int32_t steps = down ? marks.steps_down(row, x) : marks.nowhere;
        for (int32_t i = 0; i < group; ++i, ++steps) {
            steps = down && i > 0 && marks.has(row, x + i) ? 0 : steps;
            distances[i] = in_metric(steps);
        }
        steps = up ? marks.steps_up(row, x + group - 1) : marks.nowhere;
        for (int32_t i = group; i-- > 0; ++steps) {
            steps = up && i < group - 1 && marks.has(row, x + i) ? 0 : steps;
            distances[i] = smaller(distances[i], in_metric(steps));
        }
        store(out.data() + size_t(map) * cloud.brick_count() + brick, distances);
    }

private:
    /// Bricks that touch are 0 apart where ways are measured, so one brick along an axis is free.
    HD uint8_t in_metric(int32_t steps) const {
        const bool is_way = cloud.metric == Metric::city_block || cloud.metric == Metric::euclidean;
        return uint8_t(smaller(is_way && steps > 0 ? steps - 1 : steps, 255));
    }
    HD static void store(uint8_t* to, const uint8_t (&distances)[group]) {
        if constexpr (group % 4 == 0) {
            for (int32_t i = 0; i < group; i += 4)
                reinterpret_cast<uint32_t*>(to)[i / 4] = uint32_t(distances[i]) | uint32_t(distances[i + 1]) << 8 |
                                                         uint32_t(distances[i + 2]) << 16 |
                                                         uint32_t(distances[i + 3]) << 24;
        } else {
            for (int32_t i = 0; i < group; ++i)
                to[i] = distances[i];
        }
    }
};

/// The pass along y or z: `in` and `out` are maps of the cloud's bricks. For octants the pass along axis a makes
/// 2^(a+1) maps of 2^a. One item is a piece of a line, so that short grids keep a device busy too. The last pass adds
/// the empty bricks to `total`.
struct DistancePass {
    CloudView cloud;
    BrickMarks marks;
    int32_t axis = 1;  ///< 1 or 2
    int32_t piece = 1; ///< bricks an item
    std::span<const uint8_t> in{};
    std::span<uint8_t> out{};
    std::span<DistanceTotal> total{}; ///< one; 0 at the start

    HD uint32_t maps() const { return cloud.metric == Metric::octant ? 2u << axis : 1; }
    HD uint32_t lines() const { return cloud.brick_count() / uint32_t(cloud.size[axis]); }
    HD uint32_t pieces() const {
        return cloud.metric == Metric::city_block ? 1 : uint32_t((cloud.size[axis] + piece - 1) / piece);
    }
    HD uint32_t item_count() const { return maps() * lines() * pieces(); }

    HD void operator()(uint32_t item) const {
        // Neighbouring items touch neighbouring bytes: the same piece of the lines beside each other.
        const uint32_t map = item / lines() / pieces(), within = item % (lines() * pieces());
        const uint32_t line = within % lines(), part = within / lines();
        const uint32_t width = uint32_t(cloud.size.x), height = uint32_t(cloud.size.y);
        const uint32_t first = axis == 1 ? line % width + line / width * width * height : line;
        const int64_t stride = axis == 1 ? width : int64_t(width) * height;
        const bool octant = cloud.metric == Metric::octant;
        const size_t source = octant ? map & (maps() / 2 - 1) : 0;
        const bool mirrored = octant && !(map >> axis & 1); // downwards: the line is read from its other end
        const int64_t begin = first + (mirrored ? stride * (cloud.size[axis] - 1) : 0);
        const int64_t way = mirrored ? -stride : stride;
        const BrickLine<const uint8_t> from{in.data() + source * cloud.brick_count() + begin, way, cloud.size[axis]};
        DistanceSink to{{out.data() + size_t(map) * cloud.brick_count() + begin, way, cloud.size[axis]}};
        const int32_t start = int32_t(part) * piece, end = smaller(start + piece, cloud.size[axis]);
        if (cloud.metric == Metric::city_block)
            city_block(from, to, line);
        else if (cloud.metric == Metric::euclidean)
            euclidean(from, to, line, start, end);
        else if (octant)
            for (int32_t i = start; i < end; ++i)
                to.store(i, chessboard_distance(from, i, true));
        else
            chessboard(from, to, start, end);
        if (axis == 2) {
            count_up(&total[0].sum, to.sum);
            count_up(&total[0].empty, to.empty);
        }
    }

private:
    HD static void chessboard(const BrickLine<const uint8_t>& from, DistanceSink& to, int32_t start, int32_t end) {
        ChessboardScan scan(from, start);
        to.store(start, scan.distance());
        for (int32_t i = start + 1; i < end; ++i) {
            scan.advance();
            to.store(i, scan.distance());
        }
    }
    /// The last pass turns a distance B into what the map holds.
    HD int32_t finished(int32_t distance, uint32_t line, int32_t i) const {
        if (axis < 2)
            return distance;
        const uint32_t y = line / uint32_t(cloud.size.x);
        const uint32_t row = y + uint32_t(cloud.size.y) * uint32_t(i);
        return marks.has(row, int32_t(line - y * uint32_t(cloud.size.x))) ? 0 : distance + 1;
    }
    /// Bricks that touch are 0 apart, so one brick of the way along an axis is free.
    HD void city_block(const BrickLine<const uint8_t>& from, DistanceSink& to, uint32_t line) const {
        int32_t distance = 255;
        for (int32_t i = 0; i < from.count; ++i) {
            distance = smaller(distance + 1, smaller(from[i], smaller(from[i - 1], from[i + 1])));
            to.line.store(i, distance);
        }
        distance = 255;
        for (int32_t i = from.count; i-- > 0;) {
            distance = smaller(distance + 1, to.line[i]);
            to.store(i, finished(distance, line, i));
        }
    }
    HD void euclidean(const BrickLine<const uint8_t>& from, DistanceSink& to, uint32_t line, int32_t start,
                      int32_t end) const {
        for (int32_t i = start; i < end; ++i) {
            int32_t nearest = from[i] * from[i]; // squared
            for (int32_t k = 1; (k - 1) * (k - 1) < nearest && k < from.count; ++k) {
                const int32_t value = smaller(from[i - k], from[i + k]);
                nearest = smaller(nearest, (k - 1) * (k - 1) + smaller(value, 255) * smaller(value, 255));
            }
            int32_t distance = int32_t(square_root(float(nearest)));
            distance -= distance * distance > nearest;
            to.store(i, finished(distance, line, i));
        }
    }
};

} // namespace proxima
