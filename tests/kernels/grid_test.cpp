// SPDX-License-Identifier: Apache-2.0
#include "kernels/grid.h"
#include "renderer/grid_resolution.h"

#include <doctest/doctest.h>
#include <random>
#include <set>

using namespace proxima;

namespace {

/// Whether a sphere touches a voxel, straight from the definition and in double.
bool touches(const GridView<double>& grid, const Sphere<double>& sphere, int x, int y, int z) {
    double d2 = 0;
    const int cell[3] = {x, y, z};
    for (int i = 0; i < 3; ++i) {
        const double low = grid.lower[i] + cell[i] * grid.voxel[i], high = low + grid.voxel[i];
        const double gap = std::max({low - sphere.center[i], sphere.center[i] - high, 0.0});
        d2 += gap * gap;
    }
    return d2 <= sphere.radius * sphere.radius;
}

} // namespace

TEST_CASE("grid: each sphere is listed once in every cell it touches, and in hardly any other") {
    std::mt19937 engine(11);
    const auto uniform = [&](double low, double high) { return low + (high - low) * engine() / 4294967296.0; };
    const Box<double> bounds{{-1, 0, 2}, {3, 1, 7}};
    for (const Vec3<int32_t> size : {Vec3<int32_t>(1, 1, 1), {8, 2, 10}, {5, 1, 7}, {40, 10, 50}}) {
        const GridView<float> grid = make_grid(Box<float>{Vec3<float>(bounds.lower), Vec3<float>(bounds.upper)}, size);
        const GridView<double> exact = make_grid(bounds, size);
        for (int i = 0; i < 50; ++i) {
            const Sphere<float> sphere{{float(uniform(-1, 3)), float(uniform(0, 1)), float(uniform(2, 7))},
                                       float(uniform(0.001, 0.5))};
            std::multiset<uint32_t> listed;
            for_each_cell(grid, sphere, [&](int x, int y, int z) { listed.insert(grid.index(x, y, z)); });
            const Sphere<double> same{Vec3<double>(sphere.center), sphere.radius};
            const Sphere<double> larger{same.center, same.radius + 1.1 * double(grid.inflation)};
            for (int z = 0; z < size.z; ++z)
                for (int y = 0; y < size.y; ++y)
                    for (int x = 0; x < size.x; ++x) {
                        const size_t times = listed.count(grid.index(x, y, z));
                        REQUIRE(times <= 1);
                        if (touches(exact, same, x, y, z))
                            REQUIRE(times == 1);
                        if (times == 1)
                            REQUIRE(touches(exact, larger, x, y, z));
                    }
        }
    }
}

TEST_CASE("grid: a sphere whose square is no number is listed where it is, and nowhere outside") {
    std::mt19937 engine(12);
    const auto uniform = [&](float low, float high) { return low + (high - low) * float(engine() / 4294967296.0); };
    const float scale = std::ldexp(1.0f, 100);
    const Vec3<int32_t> size(20, 10, 20);
    const GridView<float> grid = make_grid(Box<float>{{-1, 0, 2}, {3, 1, 7}}, size);
    const GridView<float> scaled = make_grid(Box<float>{{-scale, 0, 2 * scale}, {3 * scale, scale, 7 * scale}}, size);
    for (int i = 0; i < 200; ++i) {
        const Sphere<float> sphere{{uniform(-1, 3), uniform(0, 1), uniform(2, 7)}, uniform(0.001f, 0.5f)};
        std::set<uint32_t> missing;
        for_each_cell(grid, sphere, [&](int x, int y, int z) { missing.insert(grid.index(x, y, z)); });
        bool outside = false;
        for_each_cell(scaled, Sphere<float>{sphere.center * scale, sphere.radius * scale}, [&](int x, int y, int z) {
            outside = outside || x < 0 || y < 0 || z < 0 || x >= size.x || y >= size.y || z >= size.z;
            missing.erase(grid.index(x, y, z));
        });
        REQUIRE_FALSE(outside);
        REQUIRE(missing.empty());
    }
}

static uint32_t index_at(const GridView<double>& grid, const Vec3<double>& point) {
    const Vec3<int32_t> cell = grid.cell_at(point);
    return grid.index(cell.x, cell.y, cell.z);
}

TEST_CASE("grid: points outside belong to the nearest voxel") {
    const GridView<double> grid = make_grid(Box<double>{{0, 0, 0}, {4, 2, 1}}, Vec3<int32_t>(4, 2, 1));
    CHECK(index_at(grid, {0.5, 0.5, 0.5}) == 0);
    CHECK(index_at(grid, {3.5, 1.5, 0.5}) == 7);
    CHECK(index_at(grid, {-1, 9, 0}) == 4);
    CHECK(index_at(grid, {4, 2, 1}) == 7);
}

TEST_CASE("grid resolution: cubic voxels, one along an axis without extent, never too many") {
    struct Row {
        const char* what;
        std::array<double, 3> extent;
        uint64_t count;
        GridRule rule;
        std::array<uint32_t, 3> size;
    };
    const Row rows[] = {
        {"cube", {1, 1, 1}, 1000, {8}, {20, 20, 20}},
        {"box", {4, 2, 1}, 1000, {8}, {40, 20, 10}},
        {"flat", {10, 1e-9, 10}, 100, {4}, {20, 1, 20}},
        {"line", {1, 1e-9, 1e-9}, 100, {4}, {400, 1, 1}},
        {"long line", {1, 1e-9, 1e-9}, 1000000, {4}, {4096, 1, 1}},
        {"one", {1, 1, 1}, 1, {1}, {1, 1, 1}},
        {"thin plate", {100, 1, 100}, 4, {4}, {4, 1, 4}},
        {"capped", {1, 1, 1}, 1000000, {8, 4096, 1000}, {10, 10, 10}},
        {"no finer than is worth it", {4, 2, 1}, 1000000, {8, 4096, 1ull << 31, 0.3}, {13, 6, 3}},
        {"coarser than its bounds", {4, 2, 1}, 1000000, {8, 4096, 1ull << 31, 5}, {1, 1, 1}},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        CHECK(grid_resolution(row.extent, row.count, row.rule) == row.size);
    }
}
