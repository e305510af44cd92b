// SPDX-License-Identifier: Apache-2.0
// Spheres, planes, unions, and who wears what. What wins was seen in POV-Ray's pictures.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

/// The red of each sphere's top layer.
std::vector<float> reds(const std::string& text) {
    const SceneProgram scene = scene_of(text);
    std::vector<float> result;
    for (const uint32_t material : scene.sphere_materials)
        result.push_back(scene.pigments[top_layer(scene, material).pigment].color.rgb.x);
    return result;
}

using Reds = std::vector<float>;

} // namespace

TEST_CASE("objects: commas between their numbers are optional") {
    for (const char* text : {"sphere { <1, 2, 3>, 4 }", "sphere { <1 2 3> 4 }", "sphere { <1, 2, 3> 4 }"}) {
        CAPTURE(std::string(text));
        const SceneProgram scene = scene_of(text);
        check_near(scene.spheres.at(0).center, {1, 2, 3});
        CHECK(scene.spheres.at(0).radius == 4);
    }
    CHECK(scene_of("plane { y 1 }").planes.at(0).distance == 1);
}

TEST_CASE("objects: a union's texture is for those that have none") {
    CHECK(reds("union { sphere { 0, 1 } sphere { 1, 1 pigment { rgb 0.5 } } pigment { rgb 1 } }") == Reds{1, 0.5f});
    CHECK(reds("union { union { sphere { 0, 1 } } sphere { 1, 1 } pigment { rgb 1 } }") == Reds{1, 1});
    CHECK(reds("union { union { sphere { 0, 1 } pigment { rgb 0.5 } } sphere { 1, 1 } pigment { rgb 1 } }") ==
          Reds{0.5f, 1});
}

TEST_CASE("objects: a declared object can be dressed again") {
    const std::string ball = "#declare S = sphere { 0, 1 pigment { rgb 0.5 } } ";
    const std::string both = "#declare U = union { sphere { 0, 1 } sphere { 1, 1 } pigment { rgb 0.5 } } ";
    CHECK(reds(ball + "object { S pigment { rgb 1 } }") == Reds{1});
    CHECK(reds(ball + "object { S texture { pigment { rgbt 1 } } }") == Reds{1});
    CHECK(reds(both + "object { U pigment { rgb 1 } }") == Reds{1, 1});
    CHECK(reds(both + "union { object { U } sphere { 2, 1 } pigment { rgb 1 } }") == Reds{0.5f, 0.5f, 1});
    const SceneProgram scene = scene_of(ball + "object { S texture { pigment { rgbt 1 } } }");
    CHECK(scene.materials[scene.sphere_materials[0]].layer_count == 2);
}

TEST_CASE("objects: interior and no_shadow of a union go to its parts") {
    const SceneProgram scene =
        scene_of("union { sphere { 0, 1 } sphere { 1, 1 interior { ior 2 } } interior { ior 1.5 } no_shadow }");
    const auto ior = [&](size_t i) { return scene.interiors[scene.materials[scene.sphere_materials[i]].interior].ior; };
    CHECK(ior(0) == 1.5f);
    CHECK(ior(1) == 2);
    for (const uint32_t material : scene.sphere_materials)
        CHECK((scene.materials[material].flags & material_no_shadow) != 0);
}

TEST_CASE("objects: unions hold spheres, ellipsoids and planes") {
    const SceneProgram scene =
        scene_of("union { sphere { 0, 1 } sphere { 0, 1 scale <1, 2, 1> } plane { y, 0 } translate x }");
    CHECK(scene.spheres.at(0).center.x == 1);
    CHECK(scene.ellipsoids.at(0).world_from_object.offset.x == 1);
    CHECK(scene.planes.size() == 1);
}

TEST_CASE("objects: flags of a union go to its parts; hollow does unless the part says otherwise") {
    const SceneProgram scene = scene_of("union { sphere { 0, 1 no_image } sphere { 1, 1 hollow off } double_illuminate "
                                        "no_reflection hollow }");
    const auto flags = [&](size_t sphere) { return scene.materials[scene.sphere_materials[sphere]].flags; };
    CHECK(flags(0) == (material_no_image | material_double_illuminate | material_no_reflection | material_hollow));
    CHECK(flags(1) == (material_double_illuminate | material_no_reflection));
}

TEST_CASE("objects: mistakes") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"sphere { 0, -1 }", "the radius of a sphere must be above 0, this one is -1"},
        {"sphere { 0, 0 }", "the radius of a sphere must be above 0, this one is 0"},
        {"plane { 0, 1 }", "the normal of a plane must have a length"},
        {"sphere { 0, 1", "the scene ends here"},
        {"sphere { 0, 1 }}", "unexpected '}'"},
        {"sphere { 0, 1 };", "unexpected ';'"},
        {"union { }", "unexpected '}'"},
        {"union { sphere { 0, 1 } box { 0, 1 } }", "Proxima does not support 'box'"},
        {"object { Nothing }", "'Nothing' is not declared"},
        {"#declare T = texture { } object { T }", "unexpected 'T', which is a texture"},
        {"sphere { 0, 1 hollow split_union }", "unexpected 'split_union'"},
        {"sphere { 0, 1 no_radiosity }", "Proxima does not support 'no_radiosity'"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(error_of(test.text) == test.message);
    }
}
