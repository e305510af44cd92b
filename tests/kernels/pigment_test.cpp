// SPDX-License-Identifier: Apache-2.0
#include "kernels/pigment.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE_TEMPLATE("pigment: checker cells alternate, also below zero and on their faces", Real, float, double) {
    struct Row {
        double x, y, z;
        bool odd;
    };
    const Row rows[] = {
        {0.5, 0.5, 0.5, false},   {1.5, 0.5, 0.5, true},       {1.5, 1.5, 0.5, false},    {-0.5, 0.5, 0.5, true},
        {-0.5, -0.5, 0.5, false}, {0.5, 0, 0.5, false},        {0.5, -1e-12, 0.5, false}, {0.5, 1e-12, 0.5, false},
        {1000.5, 0, 0.5, false},  {1001.5, -1e-13, 0.5, true}, {-7.5, -3.5, 2.5, false},
    };
    for (const Row& row : rows) {
        CAPTURE(row.x);
        CAPTURE(row.y);
        CHECK(is_odd_checker_cell(Vec3<Real>(Real(row.x), Real(row.y), Real(row.z))) == row.odd);
    }
}

TEST_CASE("pigment: opacity and transmission") {
    SurfacesView<double> surfaces;
    Pigment pigment;
    pigment.color = {{0.5f, 0.25f, 1.0f}, 0.5f, 0.25f};
    LayerColor<double> color = layer_color(surfaces, pigment, {0, 0, 0});
    CHECK(color.opacity == doctest::Approx(0.25));
    CHECK(color.transmission == Vec3<double>(0.5, 0.375, 0.75));
    surfaces.legacy_transparency = true;
    pigment.color.rgb = {0.5f, 0.25f, 0.75f};
    color = layer_color(surfaces, pigment, {0, 0, 0});
    CHECK(color.opacity == doctest::Approx(1 - (0.5 * 0.75 + 0.25)));
}

TEST_CASE("pigment: a checker is looked up where its transform maps the point") {
    Affine<double> map;
    map.linear = Mat3<double>(0.5); // cells of 2 units
    SurfacesView<double> surfaces;
    surfaces.transforms = {&map, 1};
    Pigment pigment;
    pigment.kind = PigmentKind::checker;
    pigment.color.rgb = {1, 0, 0};
    pigment.second_color.rgb = {0, 1, 0};
    CHECK(layer_color(surfaces, pigment, {1.5, 0.5, 0.5}).rgb.y == 1);
    pigment.transform = 0;
    CHECK(layer_color(surfaces, pigment, {1.5, 0.5, 0.5}).rgb.x == 1);
}
