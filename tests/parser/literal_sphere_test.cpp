// SPDX-License-Identifier: Apache-2.0
// Literal spheres: packed while parsing, and yet the same as any others.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

const std::string textures =
    "#declare A = texture { pigment { rgb 0.25 } } #declare B = texture { pigment { rgb 0.5 } }\n";

std::string many_spheres(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += "sphere { <" + std::to_string(i) + ".5, 0.25, -1e2>, 0.5 texture { A } }\n";
    return text;
}

} // namespace

TEST_CASE("literal spheres: runs are packed and cut at their capacity") {
    SourceFiles files;
    SymbolTable symbols;
    Diagnostics diagnostics;
    files.add_text("scene", many_spheres(70'000));
    const TokenProgram program = parse_text(files, 0, symbols, diagnostics);
    CHECK(program.tokens.size() == 3);
    REQUIRE(program.runs.size() == 2);
    CHECK(program.runs[0].spheres.size() == SphereRun::capacity);
    CHECK(program.runs[1].spheres.size() == 70'000 - SphereRun::capacity);
    CHECK(program.literal_spheres == 70'000);
}

TEST_CASE("literal spheres: numbers and textures arrive in order") {
    const SceneProgram scene =
        scene_of(textures + "sphere { <1, 2, 3>, 4 texture { A } } sphere { <-1.5, .5, 1e2>, 0.25 texture { B } }"
                            "sphere { <1, 2, 3>, 4 } sphere { <1, 2, 3>, 4 texture { A } }");
    REQUIRE(scene.spheres.size() == 4);
    check_near(scene.spheres[1].center, {-1.5, 0.5, 100});
    CHECK(scene.spheres[1].radius == 0.25);
    const float expected[] = {0.25f, 0.5f, 0, 0.25f};
    for (size_t i = 0; i < 4; ++i)
        CHECK(scene.pigments[top_layer(scene, scene.sphere_materials[i]).pigment].color.rgb.x == expected[i]);
    CHECK(scene.sphere_materials[0] == scene.sphere_materials[3]);
}

TEST_CASE("literal spheres: colors in them are packed too, over the default's finish") {
    const SceneProgram scene = scene_of("#default { finish { phong 0.5 } }\n"
                                        "sphere { <1, 2, 3>, 4 pigment { rgb <0.5, 0, 1> } }"
                                        "sphere { <1, 2, 3>, 4 pigment { color rgb <0.5, 0, 1> } }"
                                        "sphere { <1, 2, 3>, 4 pigment { rgb <-1, 2, .25> } }");
    REQUIRE(scene.spheres.size() == 3);
    CHECK(scene.materials.size() == 3); // the default's, which nothing wears, and two
    CHECK(pigment_of(scene).color.rgb == glm::vec3(0.5f, 0, 1));
    CHECK(finish_of(scene).phong == 0.5f);
    CHECK(scene.sphere_materials[0] == scene.sphere_materials[1]);
    CHECK(scene.pigments[top_layer(scene, scene.sphere_materials[2]).pigment].color.rgb == glm::vec3(-1, 2, 0.25f));
}

TEST_CASE("literal spheres: what is declared around them changes them") {
    const SceneProgram scene = scene_of(textures + "sphere { <1, 2, 3>, 4 texture { A } } #declare A = texture { B }\n"
                                                   "sphere { <1, 2, 3>, 4 texture { A } } sphere { <1, 2, 3>, 4 }"
                                                   "#default { pigment { rgb 0.75 } } sphere { <1, 2, 3>, 4 }");
    const float expected[] = {0.25f, 0.5f, 0, 0.75f};
    for (size_t i = 0; i < 4; ++i)
        CHECK(scene.pigments[top_layer(scene, scene.sphere_materials[i]).pigment].color.rgb.x == expected[i]);
}

TEST_CASE("literal spheres: they are objects like any other") {
    CHECK(scene_of("union { sphere { <1, 2, 3>, 4 } sphere { <1, 2, 3>, 4 } translate x }").spheres.size() == 2);
    const SceneProgram scene =
        scene_of("#declare S = sphere { <1, 2, 3>, 4 } sphere { <5, 6, 7>, 8 } object { S translate x }");
    REQUIRE(scene.spheres.size() == 2);
    CHECK(scene.spheres[0].radius == 8);
    CHECK(scene.spheres[1].center.x == 2);
    CHECK(scene_of("#for (I, 1, 3) sphere { <1, 2, 3>, 4 } sphere { <1, 2, 3>, 4 } #end").spheres.size() == 6);
    CHECK(scene_of("object { sphere { <1, 2, 3>, 4 } scale 2 }").spheres.at(0).radius == 8);
}

TEST_CASE("literal spheres: their mistakes have their own place") {
    const std::string messages = evaluate("#declare A = texture { }\nsphere { <1, 2, 3>, 4 texture { A } }\n"
                                          "sphere { <1, 2, 3>, 4 texture { Ab } }")
                                     .messages;
    CHECK(messages.find("scene:3:33: error: 'Ab' is not declared") == 0);
    CHECK(error_of("#declare P = pigment { rgb 1 } sphere { <1, 2, 3>, 4 texture { P } }") ==
          "unexpected 'P', which is a pigment");
    CHECK(evaluate("\nsphere { <1, 2, 3>, 0 }").messages.find("scene:2:21: error: the radius of a sphere") == 0);
    CHECK(evaluate("sphere { <1e300, 2, 3>, 1 }").diagnostics.error_count() == 0);
}

TEST_CASE("literal spheres: the last evaluation moves them out, others copy") {
    ScriptSources sources;
    sources.files.add_text("scene", textures + many_spheres(1000));
    EvaluationSettings settings;
    for (int round = 0; round < 3; ++round) {
        Diagnostics diagnostics;
        settings.last_evaluation = round == 2;
        const SceneProgram scene = Evaluator(sources, settings, diagnostics).run();
        CHECK(scene.spheres.size() == 1000);
        CHECK(scene.sphere_materials.size() == 1000);
        CHECK(!diagnostics.has_errors());
    }
    CHECK(sources.programs[0]->runs[0].spheres.capacity() == 0);
}
