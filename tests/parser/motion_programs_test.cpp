// SPDX-License-Identifier: Apache-2.0
// How scripts become motion programs: how many, what is shared, and what makes it impossible.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

EvaluationSettings recording(double clock = 0.25) {
    EvaluationSettings settings;
    settings.time.clock = clock;
    settings.time.clock_delta = 0.5;
    settings.record_motion = true;
    return settings;
}

SceneProgram recorded(const std::string& text) {
    return scene_of(text, recording());
}

} // namespace

TEST_CASE("motion: the spheres of a loop share one program, and constants that are equal are kept once") {
    const SceneProgram scene = recorded("#declare S = seed(1);\n"
                                        "#for (I, 1, 1000)\n"
                                        "  sphere { <sin(clock*2*pi+I)*I, rand(S), 2*I>, 0.5 }\n"
                                        "#end");
    const MotionCode& code = scene.motion.spheres;
    REQUIRE(code.programs.size() == 1);
    CHECK(code.programs[0].instances == 1000);
    CHECK(code.programs[0].own_constants == 3); // I, the random number, 2*I
    CHECK(code.programs[0].instructions == 3);  // +, sin, *: clock*2*pi is the same for all
    CHECK(scene.motion.uniforms.programs.size() == 1);
    CHECK(code.targets.size() == 1000);
    CHECK(code.targets[999] == 999);
}

TEST_CASE("motion: spheres of one shape share a program whatever their numbers are") {
    // 1*clock and 0*clock, I equal to J, literals that happen to be the loop's variable.
    CHECK(recorded("#for (I, 0, 3) #for (J, 0, 3) sphere { <I*clock, J*clock+I, 1>, 1 } #end #end")
              .motion.spheres.programs.size() == 1);
    CHECK(recorded("#for (I, 0, 3) sphere { <I*clock, 1, 2>, 1 } sphere { <1, I*clock, 2>, 1 } #end")
              .motion.spheres.programs.size() == 2);
}

TEST_CASE("motion: spheres that stand still are no part of it") {
    const SceneProgram scene =
        recorded("sphere { 0, 1 } sphere { clock, 1 } sphere { 2, 1 } camera { location clock }");
    CHECK(scene.spheres.size() == 3);
    CHECK(scene.motion.spheres.targets == std::vector<uint32_t>{1});
    CHECK(scene.motion.fields.size() == 3);
    CHECK(scene.depends_on_time);
    CHECK(recorded("sphere { 0, 1 }").motion.empty());
    CHECK(scene_of("sphere { clock, 1 }").motion.empty());
}

TEST_CASE("motion: what looks at the time is named with its place") {
    struct Row {
        const char* text;
        const char* word;
        uint32_t line;
    };
    const Row rows[] = {
        {"\n#if (clock < 0.5) sphere { 0, 1 } #end", "#if", 2},
        {"#declare N = 3*clock;\n\n#while (N < 2) #declare N = N+1; #end", "#while", 3},
        {"#for (I, 0, 10*clock) sphere { I, 1 } #end", "#for", 1},
        {"#switch (frame_number) #case (1) #break #end", "#switch", 1},
        {"#declare A = array[3] {1, 2, 3};\nsphere { A[2*clock], 1 }", "[", 2},
        {"#declare A = array[3*clock+1];", "[", 1},
        {"#declare R = seed(\nclock);", "seed", 2},
        {"#declare T = concat(\"a\", str(clock, 0, 2));", "str", 1},
        {"#declare T = chr(65+clock);", "chr", 1},
        {"global_settings { max_trace_level 5+clock }", "max_trace_level", 1},
        {"#macro M(A)\n #if (A > 0) sphere { 0, 1 } #end\n#end\nM(clock)", "#if", 2},
        {"sphere { (clock < 1 ? <1,2,3> : 0), 1 }", "clock", 1},
    };
    for (const Row& row : rows) {
        CAPTURE(std::string(row.text));
        const SceneProgram scene = recorded(row.text);
        REQUIRE(scene.obstacle);
        CHECK(scene.motion.empty());
        if (std::string(row.word) != "clock") // a condition of vectors of unequal size stands behind no word
            CHECK(scene.obstacle->word == row.word);
        CHECK(scene.obstacle->line == row.line);
        CHECK(scene.obstacle->file == "scene");
    }
}

TEST_CASE("motion: clock_delta is the same in all frames: a script may look at it") {
    const SceneProgram scene = recorded("#for (I, 0, 1, clock_delta) sphere { <I, clock, clock_delta>, 1 } #end");
    CHECK(!scene.obstacle);
    CHECK(scene.spheres.size() == 3);
    CHECK(scene.motion.spheres.programs.size() == 1);
    CHECK(recorded("#for (I, 0, 1, clock_delta+clock) #end").obstacle);
}

TEST_CASE("motion: what a script says only at other times makes the frame the script's") {
    for (const char* text : {
             "sphere { 0, 1-2*clock }",                                 // a radius below 0
             "sphere { sqrt(0.5-clock)*x, 1 }",                         // no value
             "sphere { x/(1-clock), 1 }",                               // division by zero
             "sphere { 0, 1 scale <1, 0.75+clock, 1> }",                // a sphere now, an ellipsoid then
             "camera { location <0, 0, clock-1> look_at 0 }",           // at its own location
             "camera { location -3*z look_at <0, 3, -3*clock> }",       // along its sky
             "sphere { 0, 1 finish { specular 1 roughness 1-clock } }", // not above 0
             "camera { angle 190*clock }",                              // too wide
         }) {
        CAPTURE(std::string(text));
        SceneProgram scene = recorded(text);
        CHECK(!scene.obstacle);
        CHECK(move(scene, {0.25, 0, 0.5}));
        CHECK(!move(scene, {1, 0, 0.5}));
    }
}

TEST_CASE("motion: a surface that becomes transparent or a mirror is marked as one") {
    SceneProgram scene =
        recorded("sphere { 0, 1 pigment { rgbt <1,0,0,clock-0.25> } finish { reflection clock-0.25 } }");
    const uint32_t flags = material_transparent | material_reflective;
    CHECK((scene.materials[scene.sphere_materials[0]].flags & flags) == 0);
    CHECK(move(scene, {0.5, 0, 0.5}));
    CHECK((scene.materials[scene.sphere_materials[0]].flags & flags) == flags);
}

TEST_CASE("motion: a declared texture that moves is one, however often it is worn") {
    const SceneProgram scene = recorded("#declare T = texture { pigment { checker rgb clock, rgb 1 scale clock } }\n"
                                        "#for (I, 1, 100) sphere { I, 1 texture { T } } #end\n"
                                        "union { #for (I, 1, 100) sphere { I, 1 texture { T } } #end rotate y*clock }");
    CHECK(scene.pigments.size() == 3); // #default's, T's, and T's turned
    CHECK(scene.transforms.size() == 2);
}

TEST_CASE("motion: a long script keeps no expressions that nothing needs") {
    // Some ten nodes an iteration would be tens of megabytes here.
    const SceneProgram scene = recorded("#declare A = 0;\n"
                                        "#for (I, 1, 300000) #declare A = sin(clock+I)*cos(clock*I)+clock; #end\n"
                                        "#for (I, 1, 300000) sphere { <A+I, clock*I, 0>, 1 } #end");
    CHECK(scene.spheres.size() == 300000);
    CHECK(scene.motion.spheres.programs.size() == 1);
    CHECK(scene.motion.spheres.programs[0].own_constants == 1);
}

TEST_CASE("motion: an expression that is too long is left to the script") {
    const SceneProgram scene =
        recorded("#declare A = clock; #for (I, 1, 6000) #declare A = sin(A+I); #end sphere { A, 1 }");
    CHECK(scene.motion.empty());
    REQUIRE(scene.obstacle);
    CHECK(scene.obstacle->line == 0);
}
