// SPDX-License-Identifier: Apache-2.0
#include "kernels/fog.h"

#include <cmath>
#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE("fog: light fades to its color with exp(-length / distance), but never below transmit") {
    Fog<double> fog;
    fog.distance = 2;
    fog.color = {1, 0.5f, 0};
    const Ray<double> ray{{0, 0, 0}, {0, 0, 1}};
    const auto effect = [&](double length) { return fog_along<double>({&fog, 1}, ray, length); };
    CHECK(effect(4).left.x == doctest::Approx(std::exp(-2.0)));
    CHECK(effect(4).added.y == doctest::Approx(0.5 * (1 - std::exp(-2.0))));
    fog.transmit = 0.25f;
    CHECK(effect(400).left.x == 0.25);
    CHECK(effect(400).added.x == 0.75);
    fog.filter = 0.5f; // half of what is left takes the fog's colour
    CHECK(effect(400).left.y == doctest::Approx(0.25 * 0.75));
}

TEST_CASE("fog: the ground's is as thick as any below its offset and thins out above it") {
    CHECK(mean_fog_density(-3.0, -1.0) == 1);
    CHECK(mean_fog_density(2.0, 2.0) == doctest::Approx(0.2));
    CHECK(mean_fog_density(0.0, 1.0) == doctest::Approx(std::atan(1.0)));
    CHECK(mean_fog_density(-1.0, 1.0) == doctest::Approx((1 + std::atan(1.0)) / 2));
    CHECK(mean_fog_density(1.0, -1.0) == doctest::Approx(mean_fog_density(-1.0, 1.0)));
}
