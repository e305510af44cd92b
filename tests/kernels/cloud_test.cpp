// SPDX-License-Identifier: Apache-2.0
// The maps of a cloud against their definitions, brick by brick.
#include "kernels/cloud_build.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
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

std::vector<uint8_t> measured(const Map& map, Metric metric, int32_t piece) {
    DistancePass pass;
    pass.cloud = {.size = map.size, .metric = metric};
    pass.piece = piece;
    pass.occupied = map.occupied;
    std::vector<uint8_t> in = map.occupied, out;
    for (pass.axis = 0; pass.axis < 3; ++pass.axis) {
        out.assign(size_t(pass.maps()) * pass.cloud.brick_count(), 77);
        pass.in = in;
        pass.out = out;
        for (uint32_t item = 0; item < pass.item_count(); ++item)
            pass(item);
        in = out;
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
            const std::vector<uint8_t> distances = measured(map, metric, round % 2 ? 64 : 7);
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
