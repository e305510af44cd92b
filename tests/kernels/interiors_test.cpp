// SPDX-License-Identifier: Apache-2.0
#include "kernels/interiors.h"

#include <cmath>
#include <doctest/doctest.h>
#include <vector>

using namespace proxima;

TEST_CASE("interiors: entered and left in any order, none twice, full is noticed") {
    InteriorList list;
    CHECK(list.last() == no_primitive);
    for (const uint32_t id : {5u, 9u, 2u})
        list.toggle(id);
    CHECK(list.count == 3);
    CHECK(list.last() == 2);
    list.toggle(9);
    CHECK(list.count == 2);
    CHECK_FALSE(list.contains(9));
    CHECK(list.ids[0] == 5);
    CHECK(list.ids[1] == 2);
    for (uint32_t id = 100; list.count < InteriorList::capacity; ++id)
        list.toggle(id);
    CHECK_FALSE(list.overflow);
    list.toggle(7);
    CHECK(list.overflow);
    CHECK(list.count == InteriorList::capacity);
}

TEST_CASE("interiors: those around a point are in the order of their ids") {
    InteriorList list;
    for (const uint32_t id : {5u, 9u, 2u, 5u, 7u})
        list.enter_sorted(id);
    REQUIRE(list.count == 4);
    for (uint32_t i = 1; i < list.count; ++i)
        CHECK(list.ids[i - 1] < list.ids[i]);
}

TEST_CASE("interiors: of those that are in the same place, the first one stays") {
    InteriorList list;
    for (const uint32_t id : {1u, 2u, 4u, 5u, 7u, 11u})
        list.enter(id);
    list.leave_out_repeated([](uint32_t a, uint32_t b) { return a % 3 == b % 3; });
    REQUIRE(list.count == 2);
    CHECK(list.ids[0] == 1);
    CHECK(list.ids[1] == 2);
}

TEST_CASE("interiors: light fades on its way out") {
    struct Row {
        float power, distance, tint;
        double way, left;
    };
    const Row rows[] = {
        {0, 1, 0.2f, 3, 1},    // no fading
        {2, 0, 0.2f, 3, 1},    // no distance
        {2, 1, 0, 2, 0.2},     // 1 / (1 + 2^2)
        {2, 1, 0.2f, 2, 0.36}, // 0.2 + 0.8 / 5
        {1, 0.5f, 0.5f, 1, 0.5 + 0.5 / 3},
        {1001, 0.5f, 0.25f, 1, std::exp(-0.75 * 2)},
    };
    for (const Row& row : rows) {
        CAPTURE(row.power);
        const Interior interior{1.0f, row.distance, row.power, glm::vec3(row.tint)};
        CHECK(attenuation(interior, row.way, 0).x == doctest::Approx(row.left));
    }
}

TEST_CASE("interiors: indices of refraction follow what a ray has entered last") {
    // Three spheres of indices 1.2, 1.5 and 2.
    const std::vector<Sphere<double>> spheres(3);
    const std::vector<uint32_t> materials{0, 1, 2};
    const std::vector<Material> surfaces{{.interior = 0}, {.interior = 1}, {.interior = 2}};
    const std::vector<Interior> interiors{{.ior = 1.2f}, {.ior = 1.5f}, {.ior = 2.0f}};
    SceneView<double> scene;
    scene.geometry.spheres = spheres;
    scene.geometry.sphere_materials = materials;
    scene.surfaces.materials = surfaces;
    scene.surfaces.interiors = interiors;
    struct Row {
        const char* what;
        std::vector<uint32_t> inside;
        uint32_t crossed;
        double near_over_far, far_over_near;
    };
    const Row rows[] = {
        {"into the first", {}, 1, 1 / 1.5, 1.5},         {"out of the only one", {1}, 1, 1.5, 1 / 1.5},
        {"into a nested one", {1}, 2, 1.5 / 2, 2 / 1.5}, {"out of the nested one", {1, 2}, 2, 2 / 1.5, 1},
        {"out of an overlap", {1, 2}, 1, 1, 2 / 1.5},    {"into a third", {1, 2}, 0, 2 / 1.2, 1.2 / 2},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        InteriorList list;
        for (const uint32_t id : row.inside)
            list.enter(id);
        CHECK(crossing_ior_ratio<double>(scene, list, row.crossed) == doctest::Approx(row.near_over_far));
        CHECK(far_over_near_ior(scene, list, row.crossed) == doctest::Approx(row.far_over_near));
    }
}
