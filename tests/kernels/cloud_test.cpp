// SPDX-License-Identifier: Apache-2.0
// The maps of a cloud against their definitions, brick by brick.
#include "kernels/cloud_build.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numeric>
#include <random>
#include <vector>

using namespace proxima;

namespace {

struct Map {
    Vec3<int32_t> size;
    std::vector<uint8_t> occupied; ///< 0 where a brick is, else 255
};

/// Mostly empty, mostly full, in layers, or with nothing in it.
Map random_map(std::mt19937& engine, int kind) {
    const auto up_to = [&](uint32_t n) { return int32_t(engine() % n) + 1; };
    Map map{{up_to(40), up_to(40), up_to(40)}, {}};
    if (engine() % 3 == 0)
        map.size.x = 16 * up_to(3);
    if (kind == 1) // longer than a distance can be
        map.size = {up_to(600), up_to(3), up_to(3)};
    if (kind == 2)
        map.size = {up_to(3), up_to(3), up_to(600)};
    const uint32_t one_in = kind == 0 ? 2 : kind == 5 ? 0 : 1u << (engine() % 12);
    for (int z = 0; z < map.size.z; ++z)
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) {
                const bool here =
                    kind == 4 ? y == map.size.y / 3 && engine() % 3 == 0 : one_in && engine() % one_in == 0;
                map.occupied.push_back(here ? 0 : 255);
            }
    return map;
}

template <int32_t group> void measure_rows(const CloudView& cloud, const BrickMarks& marks, std::span<uint8_t> out) {
    const RowDistances<group> rows{cloud, marks, out};
    for (uint32_t item = 0; item < rows.item_count(); ++item)
        rows(item);
}

/// `groups`: rows that are whole groups of 16 are measured as such.
std::vector<uint8_t> measured(const Map& map, Metric metric, int32_t piece, bool groups, DistanceTotal& total) {
    std::vector<uint32_t> words(BrickMarks::word_count(map.size));
    DistancePass pass;
    pass.cloud = {.size = map.size, .metric = metric};
    pass.marks = {words, BrickMarks::row_words(map.size)};
    pass.piece = piece;
    pass.total = {&total, 1};
    for (size_t i = 0; i < map.occupied.size(); ++i)
        if (map.occupied[i] == 0)
            pass.marks.set(uint32_t(i / size_t(map.size.x)), int32_t(i % size_t(map.size.x)));
    std::vector<uint8_t> in, out(pass.cloud.brick_count() * (metric == Metric::octant ? 2 : 1), 77);
    if (groups && RowDistances<16>::fits(pass.cloud))
        measure_rows<16>(pass.cloud, pass.marks, out);
    else
        measure_rows<1>(pass.cloud, pass.marks, out);
    for (pass.axis = 1; pass.axis < 3; ++pass.axis) {
        in = out;
        out.assign(size_t(pass.maps()) * pass.cloud.brick_count(), 77);
        pass.in = in;
        pass.out = out;
        for (uint32_t item = 0; item < pass.item_count(); ++item)
            pass(item);
    }
    return out;
}

/// What the map should hold of a brick, by looking at all others; not cut to a byte.
double defined(const Map& map, Metric metric, const Vec3<int32_t>& at, uint32_t octant) {
    double least = 1e9;
    size_t i = 0;
    for (int z = 0; z < map.size.z; ++z)
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x, ++i) {
                if (map.occupied[i] != 0)
                    continue;
                const int way[3] = {x - at.x, y - at.y, z - at.z};
                int step[3], gap[3];
                bool ahead = true;
                for (int a = 0; a < 3; ++a) {
                    ahead &= octant >> a & 1 ? way[a] >= 0 : way[a] <= 0;
                    step[a] = std::abs(way[a]);
                    gap[a] = std::max(step[a] - 1, 0);
                }
                const int chessboard = std::max({step[0], step[1], step[2]});
                if (chessboard == 0)
                    return 0;
                if (metric == Metric::chessboard || (metric == Metric::octant && ahead))
                    least = std::min(least, double(chessboard));
                if (metric == Metric::city_block)
                    least = std::min(least, 1.0 + gap[0] + gap[1] + gap[2]);
                if (metric == Metric::euclidean)
                    least = std::min(least, 1.0 + std::hypot(gap[0], gap[1], gap[2]));
            }
    return least;
}

} // namespace

TEST_CASE("cloud: the maps hold the distances that they are defined by") {
    std::mt19937 engine(3);
    for (int round = 0; round < 60; ++round) {
        const Map map = random_map(engine, round % 6);
        for (const Metric metric : {Metric::chessboard, Metric::city_block, Metric::euclidean, Metric::octant}) {
            DistanceTotal total;
            const std::vector<uint8_t> distances = measured(map, metric, round % 2 ? 64 : 7, round % 3 > 0, total);
            CHECK(total.sum == std::accumulate(distances.begin(), distances.end(), uint64_t(0)));
            CHECK(total.empty == distances.size() - size_t(std::ranges::count(distances, 0)));
            const size_t count = map.occupied.size();
            for (int probe = 0; probe < 200; ++probe) {
                const size_t i = engine() % count;
                const uint32_t octant = metric == Metric::octant ? engine() % 8 : 0;
                const Vec3<int32_t> at(int(i) % map.size.x, int(i) / map.size.x % map.size.y,
                                       int(i) / map.size.x / map.size.y);
                const double exact = std::min(defined(map, metric, at, octant), 255.0);
                const double found = distances[octant * count + i];
                CAPTURE(int(metric));
                CAPTURE(i);
                if (metric == Metric::euclidean) // rounded down once an axis
                    REQUIRE((found <= exact && found > exact - 3));
                else
                    REQUIRE(found == exact);
            }
        }
    }
}

TEST_CASE("cloud: a line that is scanned has the distances that each of its bricks would find") {
    std::mt19937 engine(5);
    for (int round = 0; round < 4000; ++round) {
        std::vector<uint8_t> line(engine() % 700 + 1);
        int32_t height = int32_t(engine() % 256);
        for (uint8_t& value : line) {
            switch (round % 5) {
            case 0: // anything
                value = uint8_t(engine());
                break;
            case 1: // empty but for a few
                value = engine() % 50 ? 255 : uint8_t(engine() % 20);
                break;
            default: // stairs of every steepness, up and down, with gaps
                height = std::clamp(height + int32_t(engine() % uint32_t(round % 5 * 2 - 1)) - round % 5 + 1, 0, 255);
                value = engine() % 9 ? uint8_t(height) : 255;
            }
        }
        const BrickLine<const uint8_t> bricks{line.data(), 1, int32_t(line.size())};
        const int32_t start = int32_t(engine() % line.size());
        ChessboardScan scan(bricks, start);
        CAPTURE(round);
        REQUIRE(scan.distance() == chessboard_distance(bricks, start, false));
        for (int32_t i = start + 1; i < bricks.count; ++i) {
            scan.advance();
            REQUIRE(scan.distance() == std::min(chessboard_distance(bricks, i, false), 255));
        }
    }
}
