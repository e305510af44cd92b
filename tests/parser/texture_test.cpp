// SPDX-License-Identifier: Apache-2.0
// Pigments, finishes, interiors, layers, and what is stored once.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

Finish finish_from(const std::string& text) {
    return finish_of(scene_of("sphere { 0, 1 finish { " + text + " } }"));
}

} // namespace

TEST_CASE("textures: the default is POV-Ray's") {
    const SceneProgram scene = scene_of("sphere { 0, 1 }");
    CHECK(pigment_of(scene).color.rgb == glm::vec3(0));
    CHECK(finish_of(scene).ambient == glm::vec3(0.1f));
    CHECK(finish_of(scene).diffuse == 0.6f);
    CHECK(scene.interiors[scene.materials[0].interior].ior == 1);
    CHECK(scene.materials[0].flags == 0);
}

TEST_CASE("textures: every word of a finish") {
    CHECK(finish_from("ambient rgb <1, 2, 3>").ambient == glm::vec3(1, 2, 3));
    CHECK(finish_from("ambient 0.5").ambient == glm::vec3(0.5f));
    CHECK(finish_from("emission 0.5").emission == glm::vec3(0.5f));
    CHECK(finish_from("diffuse 0.25 brilliance 2").brilliance == 2);
    CHECK(finish_from("phong 0.5 phong_size 20").phong_size == 20);
    CHECK(finish_from("specular 0.5 roughness 0.01").inverse_roughness == doctest::Approx(100));
    CHECK(finish_from("metallic").metallic == 1);
    CHECK(finish_from("metallic 0.5").metallic == 0.5f);
    CHECK(finish_from("conserve_energy").conserve_energy == 1);
    CHECK(finish_from("reflection 0.5").reflection_min == glm::vec3(0.5f));
    CHECK(finish_from("reflection rgb <1, 0, 0>").reflection_max == glm::vec3(1, 0, 0));
}

TEST_CASE("textures: reflection in braces") {
    Finish finish = finish_from("reflection { 0.1, 0.9 falloff 2 exponent 0.5 metallic }");
    CHECK(finish.reflection_min == glm::vec3(0.1f));
    CHECK(finish.reflection_max == glm::vec3(0.9f));
    CHECK(finish.reflection_falloff == 2);
    CHECK(finish.reflection_exponent == 0.5f);
    CHECK(finish.reflection_metallic == 1);
    finish = finish_from("reflection { 0.5 }");
    CHECK(finish.reflection_min == glm::vec3(0.5f));
    finish = finish_from("reflection { 0.5 fresnel }");
    CHECK(finish.reflection_min == glm::vec3(0));
    CHECK(finish.reflection_max == glm::vec3(0.5f));
    CHECK(finish.fresnel == 1);
    CHECK(finish_from("reflection { 0.5 fresnel off }").fresnel == 0);
}

TEST_CASE("textures: albedo amounts become plain ones") {
    CHECK(finish_from("diffuse albedo 0.5 brilliance 3").diffuse == doctest::Approx(1.0));
    CHECK(finish_from("phong albedo 0.5 phong_size 20").phong == doctest::Approx(5.25));
    const double n = 100;
    CHECK(finish_from("specular albedo 0.5 roughness 0.01").specular ==
          doctest::Approx(0.5 * (n + 2) / (4 * (2 - std::pow(2, -n / 2)))));
}

TEST_CASE("textures: a block starts from the declared one or from what is there") {
    const std::string header = "#declare F = finish { phong 0.5 ambient 0.3 } #declare P = pigment { rgb 0.25 }"
                               "#declare T = texture { pigment { P } finish { F } }";
    CHECK(finish_of(scene_of(header + "sphere { 0, 1 finish { F phong 1 } }")).ambient.x == 0.3f);
    CHECK(finish_of(scene_of(header + "sphere { 0, 1 texture { T } finish { phong 1 } }")).ambient.x == 0.3f);
    CHECK(pigment_of(scene_of(header + "sphere { 0, 1 texture { T finish { phong 1 } } }")).color.rgb.x == 0.25f);
    CHECK(finish_of(scene_of(header + "sphere { 0, 1 texture { T pigment { rgb 1 } } }")).phong == 0.5f);
    CHECK(pigment_of(scene_of(header + "sphere { 0, 1 pigment { P } }")).color.rgb.x == 0.25f);
}

TEST_CASE("textures: layers lie in the order of the text, the last on top") {
    const SceneProgram scene = scene_of("#declare T = texture { pigment { rgb 0.1 } } texture { pigment { rgbt 0.2 } }"
                                        "sphere { 0, 1 texture { T } texture { pigment { rgbt 0.3 } } }");
    const Material& material = scene.materials[scene.sphere_materials[0]];
    REQUIRE(material.layer_count == 3);
    for (uint32_t i = 0; i < 3; ++i)
        CHECK(scene.pigments[scene.layers[material.first_layer + i].pigment].color.rgb.x ==
              doctest::Approx(0.1 * (i + 1)));
    CHECK((material.flags & material_transparent) != 0);
    CHECK(error_of("#declare T = texture { } texture { } sphere { 0, 1 texture { T } pigment { rgb 1 } }") ==
          "this texture has 2 layers");
}

TEST_CASE("textures: checker, with its transforms") {
    const SceneProgram scene =
        scene_of("plane { y, 0 pigment { checker rgb 0.25, rgb <1, 0, 0> scale 2 translate x } }");
    const Pigment& pigment = scene.pigments[top_layer(scene, scene.planes[0].material).pigment];
    CHECK(pigment.kind == PigmentKind::checker);
    CHECK(pigment.color.rgb.x == 0.25f);
    CHECK(pigment.second_color.rgb == glm::vec3(1, 0, 0));
    REQUIRE(pigment.transform != Pigment::no_transform);
    check_near(scene.transforms[pigment.transform].point({3, 0, 0}), {1, 0, 0});
    const SceneProgram plain = scene_of("plane { y, 0 pigment { checker } }");
    const Pigment& blue_green = plain.pigments[top_layer(plain, plain.planes[0].material).pigment];
    CHECK(blue_green.color.rgb == glm::vec3(0, 0, 1));
    CHECK(blue_green.second_color.rgb == glm::vec3(0, 1, 0));
    CHECK(blue_green.transform == Pigment::no_transform);
}

TEST_CASE("textures: a transform moves the textures before it, not those after it") {
    const auto offset = [](const std::string& text) {
        const SceneProgram scene = scene_of("sphere { 0, 1 " + text + " }");
        const Pigment& pigment = pigment_of(scene);
        return pigment.transform == Pigment::no_transform ? 0.0 : scene.transforms[pigment.transform].offset.x;
    };
    CHECK(offset("pigment { checker } translate x") == -1);
    CHECK(offset("translate x pigment { checker }") == 0);
    CHECK(offset("texture { pigment { checker } translate x } translate 2*x") == -3);
    CHECK(offset("pigment { checker translate x } translate 2*x") == -3);
    CHECK(offset("material { texture { pigment { checker } } translate x }") == -1);
}

TEST_CASE("textures: interiors") {
    const SceneProgram scene =
        scene_of("sphere { 0, 1 interior { ior 1.5 fade_distance 2 fade_power 3 fade_color rgb <1, 0.5, 0> } }");
    const Interior& interior = scene.interiors[scene.materials[scene.sphere_materials[0]].interior];
    CHECK(interior.ior == 1.5f);
    CHECK(interior.fade_distance == 2);
    CHECK(interior.fade_power == 3);
    CHECK(interior.fade_color == glm::vec3(1, 0.5f, 0));
}

TEST_CASE("textures: equal surfaces are stored once, flags say what they do") {
    const SceneProgram scene =
        scene_of("#for (I, 1, 10) sphere { I, 0.1 pigment { rgb <1, 0, 0> } finish { phong 1 } } #end "
                 "sphere { 0, 1 pigment { rgbt 1 } no_shadow } sphere { 0, 1 finish { reflection 0.1 } }");
    CHECK(scene.materials.size() == 3);
    CHECK(scene.materials[0].flags == 0);
    CHECK(scene.materials[1].flags == (material_transparent | material_no_shadow));
    CHECK(scene.materials[2].flags == material_reflective);
}

TEST_CASE("textures: values that make no sense are refused") {
    CHECK(error_of("sphere { 0, 1 finish { roughness 0 } }") == "roughness must be above 0");
    CHECK(error_of("sphere { 0, 1 interior { ior 0 } }") == "ior must be above 0");
    CHECK(error_of("sphere { 0, 1 finish { reflection { 1 exponent 0 } } }") ==
          "the exponent of a reflection must be above 0");
    CHECK(error_of("sphere { 0, 1 finish { crand 0.5 } }") == "Proxima does not support 'crand'");
    CHECK(error_of("sphere { 0, 1 interior { caustics 1 } }") == "Proxima does not support 'caustics'");
    CHECK(error_of("sphere { 0, 1 finish { irid { 0.5 } } }") == "Proxima does not support 'irid'");
    CHECK(error_of("sphere { 0, 1 pigment { bozo } }") == "Proxima does not support 'bozo'");
}
