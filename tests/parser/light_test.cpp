// SPDX-License-Identifier: Apache-2.0
// light_source: kinds, areas, transforms, what it looks like.
#include "tests/parser/evaluate.h"

#include <cmath>
#include <numbers>

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("lights: place, color, fading and shadows") {
    const SceneProgram scene =
        scene_of("light_source { <1, 2, 3>, rgb <1, 0.5, 0> fade_distance 5 fade_power 2 translate x }"
                 "light_source { 0 0.5 shadowless }");
    REQUIRE(scene.lights.size() == 2);
    check_near(scene.lights[0].position, {2, 2, 3});
    CHECK(scene.lights[0].color == glm::vec3(1, 0.5f, 0));
    CHECK(scene.lights[0].fade_distance == 5);
    CHECK(scene.lights[0].fade_power == 2);
    CHECK(scene.lights[0].shadowless == 0);
    CHECK(scene.lights[1].color == glm::vec3(0.5f));
    CHECK(scene.lights[1].shadowless == 1);
}

TEST_CASE("lights: the cone of a spotlight is kept as cosines, a cylinder's as lengths; both have defaults") {
    const double degree = std::numbers::pi / 180;
    const SceneProgram scene = scene_of("light_source { y, 1 spotlight point_at 0 }"
                                        "light_source { y, 1 spotlight radius 10 falloff 20 tightness 3 }"
                                        "light_source { y, 1 cylinder }"
                                        "light_source { y, 1 shadowless spotlight }");
    REQUIRE(scene.lights.size() == 4);
    CHECK(scene.lights[0].kind == LightKind::spot);
    CHECK(scene.lights[0].radius == doctest::Approx(std::cos(30 * degree)));
    CHECK(scene.lights[0].falloff == doctest::Approx(std::cos(45 * degree)));
    check_near(scene.lights[0].direction, {0, -1, 0});
    CHECK(scene.lights[1].radius == doctest::Approx(std::cos(10 * degree)));
    CHECK(scene.lights[1].tightness == 3);
    check_near(scene.lights[1].direction, glm::normalize(Vec3<double>(0, -1, 1))); // point_at is z unless told
    CHECK(scene.lights[2].kind == LightKind::cylinder);
    CHECK(scene.lights[2].radius == 0.75);
    CHECK(scene.lights[2].falloff == 1);
    CHECK(scene.lights[3].shadowless == 0); // the last kind counts
}

TEST_CASE("lights: a transform moves the light, where it points and its axes; a union moves its lights") {
    const SceneProgram scene =
        scene_of("#declare Lamp = light_source { y, 1 spotlight point_at 0 area_light x, z, 2, 2 }"
                 "union { light_source { Lamp scale 2 } sphere { 0, 1 } rotate 90*z }"
                 "object { Lamp translate x }");
    REQUIRE(scene.lights.size() == 2);
    check_near(scene.lights[0].position, {-2, 0, 0});
    check_near(scene.lights[0].direction, {1, 0, 0});
    check_near(scene.area_lights.at(scene.lights[0].area).axis1, {0, 2, 0});
    check_near(scene.lights[1].position, {1, 1, 0});
    check_near(scene.lights[1].point_at, {1, 0, 0});
}

TEST_CASE("lights: the places of an area light weigh as in POV-Ray, those on the seams more") {
    const SceneProgram scene = scene_of("light_source { 0, 1 area_light x, y, 3, 1 } "
                                        "light_source { 0, 1 area_light x, y, 4, 4 }"
                                        "light_source { 0, 1 area_light x, y, 9, 9 adaptive 1 }");
    REQUIRE(scene.area_lights.size() == 3);
    const float thirds[] = {0.25f, 0.5f, 0.25f}; // the middle one stands in both halves
    CHECK(scene.area_lights[0].sample_count == 3);
    for (uint32_t i = 0; i < 3; ++i)
        CHECK(scene.area_samples[i].weight == thirds[i]);
    CHECK(scene.area_lights[1].sample_count == 16);
    for (uint32_t i = 3; i < 19; ++i)
        CHECK(scene.area_samples[i].weight == 1.0f / 16);
    CHECK(scene.area_lights[2].adaptive == 1);
    CHECK(scene.area_lights[2].sample_count == 0);
}

TEST_CASE("lights: what a light looks like stands around it, casts no shadow and moves with it") {
    const SceneProgram scene = scene_of("light_source { y, 1 looks_like { sphere { x, 1 } } translate 2*z }");
    REQUIRE(scene.spheres.size() == 1);
    check_near(scene.spheres[0].center, {1, 1, 2});
    CHECK((scene.materials[scene.sphere_materials[0]].flags & material_no_shadow) != 0);
    check_near(scene.lights.at(0).position, {0, 1, 2});
}

TEST_CASE("lights: mistakes") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"light_source { 0, 1 radius 10 }", "'radius' stands in a point light"},
        {"light_source { 0, 1 adaptive 1 }", "'adaptive' stands in a light without area"},
        {"light_source { 0, 1 area_light x, y, 0, 4 }", "an area light has 1 to 256 places along an axis, this one 0"},
        {"light_source { 0, 1 area_light x, y, 1, 4 circular }",
         "a circular area light needs more than one place along each axis"},
        {"light_source { 0, 1 media_attenuation on }", "Proxima does not support 'media_attenuation'"},
        {"light_source { 0, 1 looks_like { } }", "unexpected '}'"},
        {"light_source { 0, 1 projected_through { sphere { 0, 1 } } }", "Proxima does not support 'projected_through'"},
        {"light_source { 0, 1 area_illumination on }", "Proxima does not support 'area_illumination'"},
        {"cylinder { 0, y, 1 }", "Proxima does not support 'cylinder'"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(error_of(test.text) == test.message);
    }
}
