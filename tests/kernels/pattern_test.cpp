// SPDX-License-Identifier: Apache-2.0
#include "kernels/pigment.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE_TEMPLATE("patterns: the number of a point", Real, float, double) {
    struct Row {
        PigmentKind kind;
        Vec3<double> point;
        double number;
    };
    const Row rows[] = {
        {PigmentKind::gradient, {0.3, 9, 9}, 0.3},     {PigmentKind::gradient, {2.25, 0, 0}, 0.25},
        {PigmentKind::gradient, {-0.25, 0, 0}, -0.25}, {PigmentKind::spherical, {0.5, 0, 0}, 0.5},
        {PigmentKind::spherical, {0, 3, 0}, 0},        {PigmentKind::planar, {9, -0.25, 9}, 0.75},
        {PigmentKind::cylindrical, {0.6, 9, 0.8}, 0},  {PigmentKind::cylindrical, {0.3, 9, 0.4}, 0.5},
        {PigmentKind::boxed, {0.1, -0.75, 0.2}, 0.25}, {PigmentKind::onion, {0, 0, 2.5}, 0.5},
        {PigmentKind::radial, {0, 5, 0}, 0.25},        {PigmentKind::radial, {0, 0, 1}, 0.75},
        {PigmentKind::radial, {1, 0, 0}, 1},           {PigmentKind::radial, {-1, 0, 0}, 0.5},
        {PigmentKind::leopard, {0, 0, 0}, 0},
    };
    for (const Row& row : rows) {
        CAPTURE(int(row.kind));
        CHECK(pattern_number(row.kind, Vec3<Real>(row.point)) == doctest::Approx(row.number));
    }
}

TEST_CASE("patterns: waves") {
    const auto wave = [](Wave kind, double number) {
        Pattern pattern;
        pattern.wave = kind;
        pattern.exponent = 2;
        return wave_number(pattern, number);
    };
    CHECK(wave(Wave::ramp, 0.25) == 0.25);
    CHECK(wave(Wave::ramp, -0.25) == 0.75);
    CHECK(wave(Wave::sine, 0.25) == doctest::Approx(1));
    CHECK(wave(Wave::sine, 0.75) == doctest::Approx(0));
    CHECK(wave(Wave::triangle, 0.25) == 0.5);
    CHECK(wave(Wave::triangle, 0.75) == 0.5);
    CHECK(wave(Wave::scallop, 0.5) == doctest::Approx(1));
    CHECK(wave(Wave::cubic, 0.25) == 0.15625);
    CHECK(wave(Wave::poly, 0.5) == 0.25);
    Pattern twice;
    twice.frequency = 2;
    twice.phase = 0.25f;
    CHECK(wave_number(twice, 0.5) == doctest::Approx(0.24999)); // 1.25 over POV-Ray's 1.00001
}

TEST_CASE("patterns: colors between the stops of a map are mixed, those beyond are the end's") {
    const ColorStop stops[] = {
        {0.25f, {{0, 0, 0}, 0, 1}}, {0.5f, {{1, 0, 0}}}, {0.5f, {{0, 1, 0}}}, {0.75f, {{0, 0, 1}}}};
    CHECK(map_color<double>(stops, 0).transmit == 1);
    CHECK(map_color<double>(stops, 0.375).rgb == Vec3<double>(0.5, 0, 0));
    CHECK(map_color<double>(stops, 0.375).transmit == 0.5);
    CHECK(map_color<double>(stops, 0.5).rgb == Vec3<double>(1, 0, 0)); // the first of two at one place
    CHECK(map_color<double>(stops, 0.625).rgb == Vec3<double>(0, 0.5, 0.5));
    CHECK(map_color<double>(stops, 9).rgb == Vec3<double>(0, 0, 1));
}

TEST_CASE_TEMPLATE("patterns: a pigment map mixes its pigments at the point of the pattern's space", Real, float,
                   double) {
    // x from 0 to 1 in units of 2: a solid colour, then a checker in units of 0.5 of that space.
    const Affine<Real> transforms[] = {{Mat3<Real>(Real(0.5)), Vec3<Real>(0)}, {Mat3<Real>(Real(2)), Vec3<Real>(0)}};
    Pigment solid, checker, outer;
    solid.color.rgb = {0, 1, 0};
    checker.kind = PigmentKind::checker;
    checker.transform = 1;
    checker.color.rgb = {1, 0, 0};
    checker.second_color = {{0, 0, 1}, 0, 1};
    outer.kind = PigmentKind::gradient;
    outer.transform = 0;
    const Pigment pigments[] = {solid, checker, outer};
    const ColorStop stops[] = {{0, {}, 0}, {1, {}, 1}};
    const Pattern patterns[] = {{.stop_count = 2}};
    SurfacesView<Real> surfaces;
    surfaces.pigments = pigments;
    surfaces.patterns = patterns;
    surfaces.color_stops = stops;
    surfaces.transforms = transforms;
    // 0.4 in the pattern's space is 0.8 in the checker's: its first colour.
    CHECK(pigment_color(surfaces, outer, Vec3<Real>(Real(0.8), Real(0.1), Real(0.1))).rgb.x == doctest::Approx(0.4));
    CHECK(pigment_color(surfaces, outer, Vec3<Real>(Real(0.8), Real(0.1), Real(0.1))).rgb.y == doctest::Approx(0.6));
    // 0.6 is 1.2: its second one, with its transparency.
    CHECK(pigment_color(surfaces, outer, Vec3<Real>(Real(1.2), Real(0.1), Real(0.1))).rgb.z == doctest::Approx(0.6));
    CHECK(pigment_color(surfaces, outer, Vec3<Real>(Real(1.2), Real(0.1), Real(0.1))).transmit == doctest::Approx(0.6));
}
