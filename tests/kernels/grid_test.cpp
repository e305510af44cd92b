// SPDX-License-Identifier: Apache-2.0
#include "kernels/grid.h"
#include "renderer/grid_resolution.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <iterator>
#include <random>
#include <set>
#include <vector>

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
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        CHECK(grid_resolution(row.extent, row.count, row.rule) == row.size);
    }
}

TEST_CASE("grid: the voxels of small spheres are those of their rows, but for what rounding leaves open") {
    std::mt19937 engine(41);
    const auto random = [&](double low, double high) { return low + (high - low) * (engine() / 4294967296.0); };
    const GridView<float> grid =
        make_grid(Box<float>{Vec3<float>(-1, -2, -1), Vec3<float>(1, 2, 3)}, Vec3<int32_t>(20, 31, 45));
    int small = 0, open = 0;
    for (int i = 0; i < 20000; ++i) {
        const Sphere<float> sphere{{float(random(-1, 1)), float(random(-2, 2)), float(random(-1, 3))},
                                   float(random(0.001, 0.06))};
        const SmallCells cells = small_cells(grid, sphere);
        if (!cells.is_small)
            continue;
        ++small;
        std::set<std::array<int32_t, 3>> by_mask, by_rows;
        cells.for_each([&](int32_t x, int32_t y, int32_t z) { by_mask.insert({x, y, z}); });
        for_each_cell(grid, sphere, [&](int32_t x, int32_t y, int32_t z) { by_rows.insert({x, y, z}); });
        CHECK(cells.count() == by_mask.size());
        std::vector<std::array<int32_t, 3>> different;
        std::ranges::set_symmetric_difference(by_mask, by_rows, std::back_inserter(different));
        open += int(different.size());
        for (const auto& cell : different) { // as far as the sphere reaches, neither more nor less
            double gap2 = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double center = double(sphere.center[axis]) - double(grid.lower[axis]);
                const double low = double(grid.voxel[axis]) * cell[size_t(axis)], high = low + double(grid.voxel[axis]);
                const double gap = std::max({low - center, center - high, 0.0});
                gap2 += gap * gap;
            }
            CHECK(std::sqrt(gap2) == doctest::Approx(double(sphere.radius) + double(grid.inflation)).epsilon(1e-4));
        }
    }
    CHECK(small > 10000);
    CHECK(open < 20);
}
