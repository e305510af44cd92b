// SPDX-License-Identifier: Apache-2.0
// Patterns with a colour map.
#include "kernels/pigment.h"
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
    const auto error_of_entry = [](const std::string& entry) {
        return error_of("sphere { 0, 1 pigment { onion color_map { [" + entry + "] } } }");
    };
    CHECK(error_of_entry("0, 1 color rgb 1 color rgb 0") == "");
    CHECK(error_of_entry("0, 1 rgb 1 rgb 0") == "unexpected 'rgb'");
    CHECK(error_of_entry("0, 1 color rgb 1 rgb 0") == "unexpected 'rgb'");
    CHECK(error_of_entry("0, 1 color rgb 1, color rgb 0") == "unexpected ','");
    CHECK(error_of_entry("0, 1, color rgb 1 color rgb 0") == "unexpected ','");
    CHECK(error_of("sphere { 0, 1 pigment { rgb 1 frequency 2 } }") == "unexpected 'frequency'");
    CHECK(error_of("sphere { 0, 1 pigment { onion turbulence 1 } }") == "Proxima does not support 'turbulence'");
}

namespace {

/// The colour of the first sphere's pigment at a point.
Vec3<double> color_at(const SceneProgram& scene, const Vec3<double>& point) {
    SurfacesView<double> surfaces;
    surfaces.pigments = scene.pigments;
    surfaces.patterns = scene.patterns;
    surfaces.color_stops = scene.color_stops;
    surfaces.transforms = scene.transforms;
    return pigment_color(surfaces, pigment_of(scene), point).rgb;
}

} // namespace

TEST_CASE("pigment maps: pigments in the space of the block, with transforms of their own") {
    const SceneProgram scene = scene_of(
        "sphere { 0, 1 pigment { gradient y pigment_map { [0 rgb z] [1 checker rgb x rgb y scale 0.5] } scale 2"
        " } }");
    // y = 0.5 is a quarter of the way up; the checker's cells are cubes of 1.
    check_near(color_at(scene, {0.5, 0.5, 0.5}), {0.25, 0, 0.75});
    check_near(color_at(scene, {1.5, 0.5, 0.5}), {0, 0.25, 0.75});
    check_near(color_at(scene, {0.5, 0.5, -0.5}), {0, 0.25, 0.75});
}

TEST_CASE("pigment maps: by name, in each other, with waves, and moved with their object") {
    const std::string map = "#declare Map = pigment_map { [0 rgb x] [0.5 onion scale 4] [1, rgb z] } ";
    SceneProgram scene = scene_of(map + "sphere { 0, 1 pigment { gradient x pigment_map { Map } } translate 8*x }");
    check_near(color_at(scene, {8.5, 0, 0}), {0.125, 0.125, 0.125}); // half way: the onion at 0.5/4
    scene = scene_of(map + "#declare Both = pigment { gradient y pigment_map { [0 gradient z pigment_map { Map }]"
                           " [1 rgb 1] } } sphere { 0, 1 pigment { Both triangle_wave } }");
    check_near(color_at(scene, {0, 0.25, 0.75}), {0.5 + 0.25 * 0.1976423537605237, 0.5 + 0.25 * 0.1976423537605237,
                                                  0.5 + 0.25 * (0.1976423537605237 + 1)});
}

TEST_CASE("pigment maps: one that lets light through makes the material transparent") {
    const SceneProgram scene = scene_of(
        "sphere { 0, 1 pigment { boxed pigment_map { [0 rgb 1] [1 onion color_map { [0 rgbt 1] [1 rgb 0] }] } } }");
    CHECK((scene.materials[scene.sphere_materials[0]].flags & material_transparent) != 0);
}

TEST_CASE("pigment maps: mistakes") {
    const auto error_in = [](const std::string& pigment) {
        return error_of("sphere { 0, 1 pigment { " + pigment + " } }");
    };
    CHECK(error_in("onion pigment_map { }") == "unexpected '}'");
    CHECK(error_in("onion pigment_map { [0] }") == "unexpected ']'");
    CHECK(error_in("onion pigment_map { [0 scale 2] }") == "unexpected 'scale'");
    CHECK(error_in("onion pigment_map { [0 pigment { rgb 1 }] }") == "unexpected 'pigment'");
    CHECK(error_in("onion pigment_map { [0, 1 rgb 1 rgb 0] }") == "unexpected '1'");
    CHECK(error_in("onion pigment_map { [0 rgb 1], [1 rgb 0] }") == "unexpected ','");
    CHECK(error_in("onion pigment_map { [0.5 rgb 1] [0.2 rgb 0] }") ==
          "the values of a color map must rise, 0.2 stands behind 0.5");
    CHECK(error_in("onion pigment_map { [0 bozo] }") == "Proxima does not support 'bozo'");
    CHECK(error_in("onion color_map { [0 rgb 1] } pigment_map { [0 rgb 1] }") == "this pattern has a map already");
    CHECK(error_in("onion pigment_map { [0 rgb 1] } color_map { [0 rgb 1] }") ==
          "this pattern has a pigment_map already");
    CHECK(error_in("rgb 1 pigment_map { [0 rgb 1] }") == "unexpected 'pigment_map'");
    CHECK(error_in("pigment_map { [0 rgb 1] }") == "unexpected 'pigment_map'");
    CHECK(error_of("#declare A = pigment { onion } sphere { 0, 1 pigment { A pigment_map { [0 rgb 1] } } }") ==
          "the pattern of this pigment_map stands in another pigment");
    CHECK(error_of("#declare M = pigment_map { [0 rgb 1] } sphere { 0, 1 pigment { onion color_map { M } } }") ==
          "unexpected 'M', which is a pigment map");
    CHECK(error_in("onion pigment_map { [0 onion pigment_map { [0 onion pigment_map { [0 rgb 1] }] }] }") ==
          "pigment maps stand in each other more than 2 deep");
}
