// SPDX-License-Identifier: Apache-2.0
// Transforms of objects, and when a sphere stays one.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

Sphere<double> sphere_of(const std::string& modifiers) {
    const SceneProgram scene = scene_of("sphere { <1, 2, 3>, 0.5 " + modifiers + " }");
    CHECK(scene.ellipsoids.empty());
    return scene.spheres.size() == 1 ? scene.spheres[0] : Sphere<double>{};
}

} // namespace

TEST_CASE("transforms: similar maps keep a sphere a sphere") {
    struct Case {
        const char* text;
        Vec3<double> center;
        double radius;
    };
    const Case cases[] = {
        {"translate <1, 0, -1>", {2, 2, 2}, 0.5},
        {"translate 1", {2, 3, 4}, 0.5},
        {"rotate 90*z", {-2, 1, 3}, 0.5},
        {"rotate <90, 90, 0>", {2, -3, -1}, 0.5},
        {"scale 2", {2, 4, 6}, 1},
        {"scale -2", {-2, -4, -6}, 1},
        {"scale <-1, 1, 1>", {-1, 2, 3}, 0.5},
        {"scale <2, 0, 0>*0 + 3", {3, 6, 9}, 1.5},
        {"matrix <0, 1, 0, -1, 0, 0, 0, 0, 1, 10, 0, 0>", {8, 1, 3}, 0.5},
        {"transform { translate x scale 2 }", {4, 4, 6}, 1},
        {"transform { translate x inverse }", {0, 2, 3}, 0.5},
        {"translate -<1, 2, 3> scale 3 translate y", {0, 1, 0}, 1.5},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        const Sphere<double> sphere = sphere_of(test.text);
        check_near(sphere.center, test.center, 1e-12);
        CHECK(sphere.radius == doctest::Approx(test.radius));
    }
}

TEST_CASE("transforms: other maps make an ellipsoid with a map and its inverse") {
    for (const char* text : {"scale <1, 2, 1>", "scale <1, 2, 3> rotate 30 translate x",
                             "matrix <1, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0>"}) {
        CAPTURE(std::string(text));
        const SceneProgram scene = scene_of(std::string("sphere { <1, 2, 3>, 0.5 ") + text + " }");
        REQUIRE(scene.ellipsoids.size() == 1);
        CHECK(scene.spheres.empty());
        const Ellipsoid<double>& ellipsoid = scene.ellipsoids[0];
        check_near(ellipsoid.object_from_world.point(ellipsoid.world_from_object.point({0.1, 0.2, 0.3})),
                   {0.1, 0.2, 0.3}, 1e-12);
    }
    const SceneProgram scene = scene_of("sphere { <1, 2, 3>, 0.5 scale <1, 2, 1> }");
    check_near(scene.ellipsoids[0].world_from_object.point({0, 1, 0}), {1, 5, 3});
}

TEST_CASE("transforms: planes keep a unit normal") {
    struct Case {
        const char* text;
        Vec3<double> normal;
        double distance;
    };
    for (const Case& test :
         {Case{"plane { 2*y, 3 }", {0, 1, 0}, 3}, Case{"plane { y, 3 translate <5, 1, 5> }", {0, 1, 0}, 4},
          Case{"plane { y, 3 scale 2 }", {0, 1, 0}, 6}, Case{"plane { y, 3 rotate 90*x }", {0, 0, 1}, 3},
          Case{"plane { <1, 1, 0>, 0 scale <2, 1, 1> translate x }", glm::normalize(Vec3<double>(1, 2, 0)),
               1 / std::sqrt(5.0)}}) {
        CAPTURE(std::string(test.text));
        const SceneProgram scene = scene_of(test.text);
        REQUIRE(scene.planes.size() == 1);
        check_near(scene.planes[0].normal, test.normal, 1e-12);
        CHECK(scene.planes[0].distance == doctest::Approx(test.distance));
    }
}

TEST_CASE("transforms: mistakes") {
    CHECK(error_of("sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 0, 2, 3, 4> }") ==
          "this matrix squeezes space flat: it has no inverse");
    CHECK(error_of("sphere { 0, 1 matrix <1, 2, 3> }") == "unexpected '>'");
    CHECK(error_of("sphere { 0, 1 translate }") == "unexpected '}'");
    CHECK(evaluate("sphere { 0, 1 scale <1, 0, 1> }").messages.find("warning: a scale of 0 is taken as 1") !=
          std::string::npos);
}
