// SPDX-License-Identifier: Apache-2.0
#include "kernels/pattern.h"

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
