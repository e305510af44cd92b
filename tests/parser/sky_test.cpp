// SPDX-License-Identifier: Apache-2.0
// sky_sphere and fog.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("sky: pigments keep their order, a transform moves all of them, a name is a copy") {
    const SceneProgram scene =
        scene_of("#declare Sky = sky_sphere { pigment { rgb x } pigment { gradient y } emission 2 }"
                 "sky_sphere { Sky rotate 90*z }");
    REQUIRE(scene.sky.pigments.size() == 2);
    CHECK(scene.sky.emission == glm::vec3(2));
    CHECK(scene.pigments[scene.sky.pigments[0]].kind == PigmentKind::solid);
    const Pigment& gradient = scene.pigments[scene.sky.pigments[1]];
    REQUIRE(gradient.transform != Pigment::no_transform);
    CHECK(scene.transforms[gradient.transform].point({-1, 0, 0}).x == doctest::Approx(1));
}

TEST_CASE("fog: every fog counts; the ground's has a height") {
    const SceneProgram scene = scene_of("fog { distance 5 rgbft <1, 0.5, 0, 0.25, 0.125> }"
                                        "fog { fog_type 2 distance 3 rgb 1 fog_offset 1 fog_alt 2 up 3*z }");
    REQUIRE(scene.fogs.size() == 2);
    CHECK(scene.fogs[0].kind == FogKind::constant);
    CHECK(scene.fogs[0].filter == 0.25f);
    CHECK(scene.fogs[0].transmit == 0.125f);
    CHECK(scene.fogs[1].kind == FogKind::ground);
    CHECK(scene.fogs[1].altitude == 2);
    check_near(scene.fogs[1].up, {0, 0, 1});
}

TEST_CASE("sky and fog: mistakes") {
    CHECK(error_of("fog { rgb 1 }") == "the distance of a fog must not be 0");
    CHECK(error_of("fog { distance 1 fog_type 3 }") == "fog_type must be 1 (everywhere) or 2 (near the ground)");
    CHECK(error_of("fog { distance 1 fog_type 2 }") == "a ground fog needs a fog_alt other than 0");
    CHECK(error_of("fog { distance 1 turbulence 1 }") == "Proxima does not support 'turbulence'");
    CHECK(error_of("sky_sphere { texture { } }") == "unexpected 'texture'");
}
