// SPDX-License-Identifier: Apache-2.0
#include "kernels/light.h"

#include <cmath>
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
        CHECK(light_fade(light, row.d, 0) == doctest::Approx(row.factor));
    }
}

TEST_CASE("light: a spot is full inside its radius, dark beyond its falloff, and smooth between") {
    Light<double> light;
    light.kind = LightKind::spot;
    light.direction = {0, 0, 1};
    light.radius = 0.9;
    light.falloff = 0.5;
    const auto share_at = [&](double cosine) {
        const Vec3<double> point(std::sqrt(1 - cosine * cosine), 0, cosine);
        return light_share(light, point, light_ray(light, point), 0);
    };
    CHECK(share_at(0.95) == 1);
    CHECK(share_at(0.7) == doctest::Approx(0.5));
    CHECK(share_at(0.6) == doctest::Approx(0.15625)); // p = 1/4: p p (3 - 2 p)
    CHECK(share_at(0.4) == 0);
    CHECK(share_at(-0.95) == 0);
    light.tightness = 2;
    CHECK(share_at(0.95) == doctest::Approx(0.9025));
}

TEST_CASE("light: a cylinder is a beam of lengths along its axis, in front of the light only") {
    Light<double> light;
    light.kind = LightKind::cylinder;
    light.position = {0, 4, 0};
    light.point_at = {0, 0, 0};
    light.direction = {0, -1, 0};
    light.radius = 1;
    light.falloff = 2;
    const LightRay<double> ray = light_ray(light, {1, 1, 0});
    CHECK(ray.direction == Vec3<double>(0, 1, 0));
    CHECK(ray.distance == 3);
    CHECK(light_share(light, {0.5, 1, 0}, ray, 0) == 1);
    CHECK(light_share(light, {1.5, 1, 0}, ray, 0) == doctest::Approx(0.5));
    CHECK(light_share(light, {2.5, 1, 0}, ray, 0) == 0);
    CHECK(light_share(light, {0.5, 5, 0}, light_ray(light, {0.5, 5, 0}), 0) == 0);
}

TEST_CASE("light: parallel light comes from one direction; behind its plane the way is negative") {
    Light<double> light;
    light.parallel = 1;
    light.position = {0, 4, 0};
    light.direction = {0, -1, 0};
    CHECK(light_ray(light, {3, 0, 0}).direction == Vec3<double>(0, 1, 0));
    CHECK(light_ray(light, {3, 0, 0}).distance == doctest::Approx(4));
    CHECK(light_ray(light, {3, 6, 0}).distance == doctest::Approx(-2));
}
