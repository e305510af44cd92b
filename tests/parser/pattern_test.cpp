// SPDX-License-Identifier: Apache-2.0
// Patterns with a colour map.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

const Pattern& pattern_of(const SceneProgram& scene) {
    return scene.patterns.at(pigment_of(scene).pattern);
}

std::vector<ColorStop> stops_of(const SceneProgram& scene) {
    const Pattern& pattern = pattern_of(scene);
    const auto first = scene.color_stops.begin() + pattern.first_stop;
    return {first, first + pattern.stop_count};
}

} // namespace

TEST_CASE("patterns: a color map, a wave, frequency and phase, in any order with transforms") {
    const SceneProgram scene =
        scene_of("sphere { 0, 1 pigment { onion scale 2 frequency 3 color_map { [0 rgb x] [1, rgbt y] }"
                 " phase 0.5 poly_wave 2 } }");
    CHECK(pigment_of(scene).kind == PigmentKind::onion);
    CHECK(pattern_of(scene).frequency == 3);
    CHECK(pattern_of(scene).phase == 0.5f);
    CHECK(pattern_of(scene).wave == Wave::poly);
    CHECK(pattern_of(scene).exponent == 2);
    const std::vector<ColorStop> stops = stops_of(scene);
    REQUIRE(stops.size() == 2);
    CHECK(stops[0].color.rgb == glm::vec3(1, 0, 0));
    CHECK(stops[1].color.rgb == glm::vec3(0, 1, 0));
    CHECK(scene.transforms.at(pigment_of(scene).transform).point({2, 0, 0}).x == doctest::Approx(1));
}

TEST_CASE("patterns: an entry may have two values and two colors; a declared map is used by name") {
    const SceneProgram scene =
        scene_of("#declare Map = color_map { [0, 0.5 color rgb 0 color rgb x] [0.5, 1 color rgb y color rgb 1] }\n"
                 "sphere { 0, 1 pigment { radial color_map { Map } } }");
    const std::vector<ColorStop> stops = stops_of(scene);
    REQUIRE(stops.size() == 4);
    CHECK(stops[1].value == 0.5f);
    CHECK(stops[1].color.rgb == glm::vec3(1, 0, 0));
    CHECK(stops[2].value == 0.5f);
    CHECK(stops[2].color.rgb == glm::vec3(0, 1, 0));
}

TEST_CASE("patterns: the axis of a gradient counts as a direction") {
    const SceneProgram scene = scene_of("sphere { 0, 1 pigment { gradient <0, 3, 4> } }");
    CHECK(scene.transforms.at(pigment_of(scene).transform).point({7, 3, 4}).x == doctest::Approx(5));
    CHECK(stops_of(scene).size() == 2); // black to white
}

TEST_CASE("patterns: a map that lets light through makes the material transparent") {
    const SceneProgram scene = scene_of("sphere { 0, 1 pigment { boxed color_map { [0 rgb 1] [1 rgbt 1] } } }");
    CHECK((scene.materials[scene.sphere_materials[0]].flags & material_transparent) != 0);
}

TEST_CASE("patterns: mistakes") {
    CHECK(error_of("sphere { 0, 1 pigment { gradient 0 } }") == "the axis of a gradient must have a length");
    CHECK(error_of("sphere { 0, 1 pigment { onion color_map { } } }") == "unexpected '}'");
    CHECK(error_of("sphere { 0, 1 pigment { onion color_map { [0.5 rgb 1] [0.2 rgb 0] } } }") ==
          "the values of a color map must rise, 0.2 stands behind 0.5");
    CHECK(error_of("sphere { 0, 1 pigment { rgb 1 frequency 2 } }") == "unexpected 'frequency'");
    CHECK(error_of("sphere { 0, 1 pigment { onion turbulence 1 } }") == "Proxima does not support 'turbulence'");
    CHECK(error_of("sphere { 0, 1 pigment { onion pigment_map { [0 rgb 1] } } }") ==
          "Proxima does not support 'pigment_map'");
}
