// SPDX-License-Identifier: Apache-2.0
#include "kernels/light.h"

#include <doctest/doctest.h>

using namespace proxima;

TEST_CASE("light: fades as 2 / (1 + (d / distance)^power)") {
    struct Row {
        float distance, power;
        double d, factor;
    };
    const Row rows[] = {
        {0, 0, 7, 1},          // no fading
        {2, 0, 7, 1},          // no power
        {0, 2, 7, 1},          // no distance
        {2, 2, 2, 1},          // at the fade distance
        {2, 2, 0, 2},          // at the light
        {2, 2, 4, 0.4},        // 2 / (1 + 4)
        {2, 1, 6, 0.5},        // 2 / (1 + 3)
        {1, 1.5f, 4, 2 / 9.0}, // 2 / (1 + 8)
    };
    for (const Row& row : rows) {
        CAPTURE(row.distance);
        CAPTURE(row.power);
        Light<double> light;
        light.fade_distance = row.distance;
        light.fade_power = row.power;
        CHECK(light_fade(light, row.d) == doctest::Approx(row.factor));
    }
}
