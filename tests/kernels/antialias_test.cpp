// SPDX-License-Identifier: Apache-2.0
#include "kernels/antialias.h"

#include <doctest/doctest.h>
#include <vector>

using namespace proxima;

TEST_CASE("antialias: colours differ by the sum over the channels, after a curve") {
    CHECK(visible_difference(glm::vec3(0.5f), glm::vec3(0.5f)) == 0);
    CHECK(visible_difference(glm::vec3(1), glm::vec3(0)) == doctest::Approx(3));
    CHECK(visible_difference({0.5f, 0, 0}, {0, 0, 0}) == doctest::Approx(0.757858)); // 0.5^0.4
    CHECK(visible_difference({-1, 0, 0}, {0, 0, 0}) == 0);
}

TEST_CASE("antialias: a square whose corners differ asks for the samples of its quarters, and is their mean then") {
    std::vector<glm::vec3> samples(9, glm::vec3(0)), picture(1);
    samples[2] = samples[8] = glm::vec3(1); // the right corners of 3 x 3
    std::vector<uint8_t> marks(9, sample_unknown);
    for (const size_t corner : {0, 2, 6, 8})
        marks[corner] = sample_known;
    std::vector<uint32_t> missing(1);
    FilmView lattice{samples, 3, 3};
    lattice.marks = marks;
    const DecideSquares decide{{picture, 1, 1}, lattice, missing, 0.3f, 1};
    decide(0);
    CHECK(missing[0] == 5);
    CHECK(picture[0].x == 0.5f);
    for (uint8_t& mark : marks)
        mark = sample_known;
    samples[5] = glm::vec3(1);
    missing[0] = 0;
    decide(0);
    CHECK(missing[0] == 0);
    CHECK(picture[0].x == 0.25f); // the right quarters are light on one side, the left ones dark
}

TEST_CASE("antialias: a pixel that differs from its left neighbour is sampled, and so is the neighbour") {
    // One row of three pixels after the column and row on the left and above: black, black, white.
    std::vector<glm::vec3> centers(8, glm::vec3(0)), grids(3, glm::vec3(0)), picture(3);
    centers[7] = glm::vec3(1);
    centers[3] = glm::vec3(1); // above the white one
    std::vector<uint8_t> marks(3, sample_unknown), refined(3);
    std::vector<uint32_t> missing(1);
    FilmView grid_film{grids, 3, 1};
    grid_film.marks = marks;
    const DecideBlock decide{{picture, 3, 1}, {centers, 4, 2}, grid_film, refined, missing, 0.3f, 3};
    decide(0);
    CHECK(missing[0] == 2);
    CHECK(marks == std::vector<uint8_t>{sample_unknown, sample_wanted, sample_wanted});
    marks[1] = marks[2] = sample_known;
    grids[1] = glm::vec3(1); // one of nine samples is white
    grids[2] = glm::vec3(9);
    missing[0] = 0;
    decide(0);
    CHECK(picture[0].x == 0);
    CHECK(picture[1].x == doctest::Approx(0.1));
    CHECK(picture[2].x == 1);
}
