// SPDX-License-Identifier: Apache-2.0
#include "renderer/spatial_order.h"
#include "tests/kernels/test_scene.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <numeric>

using namespace proxima;

TEST_CASE("spatial order: every sphere once, neighbours close, those around the camera first") {
    SceneProgram scene = test::random_scene(1, {.spheres = 20000, .radius = 0.02});
    scene.camera.location = {0.5, 0.5, 0.5};
    scene.spheres[15000].radius = scene.spheres[7000].radius = 10;
    const std::vector<uint32_t> order = spatial_order(scene);
    REQUIRE(order.size() == scene.spheres.size());
    std::vector<uint32_t> sorted = order, all(order.size());
    std::iota(all.begin(), all.end(), 0u);
    std::sort(sorted.begin(), sorted.end());
    CHECK(sorted == all);
    CHECK(order[0] == 7000);
    CHECK(order[1] == 15000);
    double way = 0;
    for (size_t i = 3; i < order.size(); ++i)
        way += glm::length(scene.spheres[order[i]].center - scene.spheres[order[i - 1]].center);
    CHECK(way / double(order.size()) < 0.6); // in the order of the scene it is 2.6
}

TEST_CASE("spatial order: small scenes keep theirs, and degenerate ones are sorted all the same") {
    CHECK(spatial_order(test::random_scene(1, {.spheres = 100})).empty());
    SceneProgram scene = test::empty_scene();
    const uint32_t material = test::add_material(scene, {});
    for (int i = 0; i < 5000; ++i)
        test::add_sphere(scene, {1e9, 1, 1}, 1, material);
    const std::vector<uint32_t> order = spatial_order(scene);
    CHECK(std::is_sorted(order.begin(), order.end()));
    CHECK(order.size() == 5000);
}
