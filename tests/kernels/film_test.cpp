// SPDX-License-Identifier: Apache-2.0
#include "kernels/film.h"

#include <doctest/doctest.h>
#include <set>
#include <vector>

using namespace proxima;

TEST_CASE("film: tiles cover every pixel once") {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {8u, 4u}, {13u, 7u}, {160u, 121u}}) {
        std::vector<int> seen(width * height);
        const uint64_t count = tiled_pixel_count(width, height);
        CHECK(count % (tile_width * tile_height) == 0);
        for (uint64_t i = 0; i < count; ++i) {
            const PixelPosition p = tiled_pixel(i, width);
            if (p.x < width && p.y < height)
                ++seen[p.y * width + p.x];
        }
        CHECK(std::set<int>(seen.begin(), seen.end()) == std::set<int>{1});
    }
}

TEST_CASE("film: a single sample is the pixel's centre, further ones spread over the pixel") {
    CHECK(sample_offset<double>(0).x == 0.5);
    CHECK(sample_offset<double>(0).y == 0.5);
    std::set<std::pair<int, int>> cells;
    for (uint32_t i = 0; i < 64; ++i) {
        const auto offset = sample_offset<double>(i);
        CHECK(double(sample_offset<float>(i).x) == offset.x); // the same in either precision
        CHECK(offset.x >= 0);
        CHECK(offset.x < 1);
        cells.insert({int(offset.x * 4), int(offset.y * 4)});
    }
    CHECK(cells.size() == 16);
}

TEST_CASE("film: the picture is the samples' mean, through the scene's curve") {
    struct Row {
        FilmCurve curve;
        float gamma, sum, result;
    };
    const Row rows[] = {
        {FilmCurve::linear, 1, 2, 0.5f}, {FilmCurve::linear, 1, -2, -0.5f},  {FilmCurve::power, 2, 2, 0.25f},
        {FilmCurve::power, 2.2f, -2, 0}, {FilmCurve::srgb, 1, 2, 0.214041f}, {FilmCurve::srgb, 1, 0.08f, 0.00154799f},
        {FilmCurve::srgb, 1, 4, 1},
    };
    for (const Row& row : rows) {
        glm::vec3 pixel(row.sum);
        ResolvePixels{{{&pixel, 1}, 1, 1, 4}, row.curve, row.gamma}(0);
        CHECK(pixel.x == doctest::Approx(row.result).epsilon(1e-5));
    }
}

TEST_CASE("film: a grid's samples lie in the middle of its cells, behind the pixel's centre where that counts too") {
    FilmView film;
    film.pattern = SamplePattern::center_and_grid;
    film.grid_side = 2;
    CHECK(sample_offset<double>(film, 0).x == 0.5);
    CHECK(sample_offset<double>(film, 1).y == 0.25);
    CHECK(sample_offset<double>(film, 2).x == 0.75);
    CHECK(sample_offset<double>(film, 4).y == 0.75);
    film.pattern = SamplePattern::grid;
    CHECK(sample_offset<double>(film, 0).x == 0.25);
}
