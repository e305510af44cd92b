// SPDX-License-Identifier: Apache-2.0
// #declare and #local of every kind of value, the predeclared names, and time.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("declare: every kind of value") {
    const SceneProgram scene = scene_of(R"(
        #declare Number = 2;
        #declare Vector = <1, 2, 3>;
        #declare Color = rgb <0.1, 0.2, 0.3>;
        #declare Name = "name"
        #declare Paint = pigment { Color }
        #declare Shine = finish { phong 0.5 }
        #declare Skin = texture { pigment { Paint } finish { Shine } }
        #declare Inside = interior { ior 1.5 }
        #declare Stuff = material { texture { Skin } interior { Inside } }
        #declare Move = transform { translate Vector }
        #declare Ball = sphere { 0, Number material { Stuff } }
        #declare Balls = union { object { Ball } object { Ball transform { Move } } }
        #declare Eye = camera { location -5*z look_at 0 }
        #declare Lamp = light_source { Vector, Color }
        object { Balls }
        camera { Eye }
        light_source { Lamp translate x }
        #declare Copy = Balls;
        object { Copy translate y }
        Ball
    )");
    REQUIRE(scene.spheres.size() == 5);
    check_near(scene.spheres[1].center, {1, 2, 3});
    check_near(scene.spheres[3].center, {1, 3, 3});
    CHECK(scene.spheres[0].radius == 2);
    CHECK(scene.materials.size() == 1);
    CHECK(scene.interiors[scene.materials[0].interior].ior == 1.5f);
    CHECK(finish_of(scene).phong == 0.5f);
    check_near(scene.lights.at(0).position, {2, 2, 3});
    check_near(scene.camera.location, {0, 0, -5});
}

TEST_CASE("declare: numbers, vectors and colors need their semicolon, right behind them") {
    const char* lacks = "this #declare lacks its ';'";
    CHECK(error_of("#declare A = 3 sphere { A, 1 }") == lacks);
    CHECK(error_of("#declare A = <1, 2>") == lacks);
    CHECK(error_of("#declare A = rgb 1") == lacks);
    CHECK(error_of("#declare A = #if (1) 5 #else 6 #end ;") == lacks);
    CHECK(error_of("#declare A = 3 #if (0) #end ;") == lacks);
    CHECK(error_of("#declare A = #if (1) 5; #else 6; #end sphere { A, 1 }") == "");
    CHECK(error_of("#declare A = (#if (1) 2 #else 3 #end); sphere { A, 1 }") == "");
    CHECK(error_of("#declare A = texture { pigment { rgb 1 } } sphere { 0, 1 texture { A } }") == "");
    CHECK(error_of("#declare A = texture { pigment { rgb 1 } }; sphere { 0, 1 texture { A } }") == "");
}

TEST_CASE("declare: a new value may use the old one and may be of another kind") {
    CHECK(scene_of("#declare A = 1; #declare A = A + 1; sphere { A*x, 1 }").spheres[0].center.x == 2);
    CHECK(scene_of(
              "#declare S = sphere { x, 1 } #declare S = union { object { S } object { S translate x } } object { S }")
              .spheres.size() == 2);
    CHECK(error_of("#declare A = 1; #declare A = texture { pigment { rgb 1 } } sphere { 0, 1 texture { A } }") == "");
}

TEST_CASE("declare: reserved words are no names") {
    for (const char* word : {"sphere", "x", "torus", "pi", "clock", "red"}) {
        CAPTURE(std::string(word));
        CHECK(error_of(std::string("#declare ") + word + " = 1;") == std::string("'") + word + "' is a reserved word");
    }
}

TEST_CASE("declare: the predeclared names") {
    EvaluationSettings settings;
    settings.image_width = 320;
    settings.image_height = 240;
    settings.time = {.clock = 0.25,
                     .clock_delta = 0.5,
                     .clock_on = true,
                     .frame_number = 3,
                     .initial_frame = 1,
                     .final_frame = 9,
                     .initial_clock = 0.125,
                     .final_clock = 2};
    const SceneProgram scene = scene_of(R"(
        sphere { <clock, clock_delta, clock_on>, 1 }
        sphere { <frame_number, initial_frame, final_frame>, 1 }
        sphere { <initial_clock, final_clock, image_width/image_height>, 1 }
        #if (input_file_name = "scene") sphere { 0, 1 } #end)",
                                        settings);
    REQUIRE(scene.spheres.size() == 4);
    check_near(scene.spheres[0].center, {0.25, 0.5, 1});
    check_near(scene.spheres[1].center, {3, 1, 9});
    check_near(scene.spheres[2].center, {0.125, 2, 4.0 / 3});
}

TEST_CASE("declare: a scene that reads the time depends on it") {
    for (const char* text : {"sphere { clock, 1 }", "sphere { frame_number, 1 }", "sphere { clock_delta, 1 }"}) {
        CAPTURE(std::string(text));
        CHECK(scene_of(text).depends_on_time);
    }
    for (const char* text : {"sphere { 0, 1 }", "sphere { image_width, 1 }", "sphere { final_frame, 1 }",
                             "#if (clock_on) #end", "#declare frame_number = 5; sphere { frame_number, 1 }"}) {
        CAPTURE(std::string(text));
        CHECK(!scene_of(text).depends_on_time);
    }
}

TEST_CASE("declare: names of the command line") {
    EvaluationSettings settings;
    settings.declares = {{"N", "3.5"}, {"S", "\"text\""}};
    CHECK(scene_of("sphere { N*x, 1 }", settings).spheres[0].center.x == 3.5);
    settings.declares.push_back({"sphere", "1"});
    CHECK(error_of("sphere { 0, 1 }", settings) == "--declare sphere: 'sphere' is a reserved word");
    settings.declares.pop_back();
    CHECK(scene_of("#if (S = \"text\") sphere { 0, 1 } #end", settings).spheres.size() == 1);
}

TEST_CASE("declare: #default holds for what follows and for what has no texture at its use") {
    const auto red = [](const std::string& text) { return pigment_of(scene_of(text)).color.rgb.x; };
    CHECK(red("#default { pigment { rgb 0.5 } } sphere { 0, 1 }") == 0.5f);
    CHECK(red("sphere { 0, 1 } #default { pigment { rgb 0.5 } }") == 0);
    CHECK(red("#default { pigment { rgb 0.25 } } #declare S = sphere { 0, 1 } #default { pigment { rgb 0.5 } } object "
              "{ S }") == 0.5f);
    CHECK(red("#default { pigment { rgb 0.25 } } #declare S = sphere { 0, 1 finish { phong 1 } } "
              "#default { pigment { rgb 0.5 } } object { S }") == 0.25f);
    const SceneProgram scene =
        scene_of("#default { finish { ambient 0.75 } } sphere { 0, 1 texture { pigment { rgb 1 } } }");
    CHECK(finish_of(scene).ambient.x == 0.75f);
    CHECK(finish_of(scene).diffuse == 0.6f);
}
