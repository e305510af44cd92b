// SPDX-License-Identifier: Apache-2.0
#include "parser/standard_includes.h"
#include "tests/parser/evaluate.h"

#include <map>

using namespace proxima;
using namespace proxima::testing;

namespace {

const std::string everything = "#include \"colors.inc\" #include \"textures.inc\" #include \"metals.inc\" "
                               "#include \"glass.inc\" #include \"shapes.inc\" #include \"rand.inc\" "
                               "#include \"woods.inc\" #include \"ior.inc\" ";

Vec3<double> standard_vector(const std::string& expression) {
    const SceneProgram scene = scene_of(everything + "sphere { " + expression + ", 1 }");
    return scene.spheres.size() == 1 ? scene.spheres[0].center : Vec3<double>(NAN);
}

double standard_number(const std::string& expression) {
    return standard_vector("<0, 0, 0> + (" + expression + ")").x;
}

} // namespace

TEST_CASE("standard includes: numbers and vectors have the values of POV-Ray's files") {
    const std::map<std::string, double> numbers = {
        {"Diamond_Ior", 2.47},
        {"e", 2.718281828459045},
        {"FoV_60", 1.732113},
        {"iorDiamond", 2.417},
        {"dispQuartz", 1.008455285},
        {"sind(30)", 0.5},
        {"atan2d(1, 1)", 45},
        {"clamp(7, 0, 3)", 1},
        {"clamp(-1, 0, 3)", 2},
        {"clip(7, 0, 3)", 3},
        {"adj_range(0.5, 2, 4)", 3},
        {"adj_range2(5, 0, 10, 1, 2)", 1.5},
        {"even(4)", 1},
        {"odd(4)", 0},
        {"sgn(-3)", -1},
        {"VDist(<1, 2, 3>, <1, 2, 5>)", 2},
        {"VAngleD(x, y)", 90},
        {"VRotationD(x, y, -z)", -90},
        {"Interpolate(1, 0, 2, 10, 20, 1)", 15},
        {"Interpolate(1, 0, 2, 10, 20, 0)", 15},
        {"VMax(<1, 5, 2>)", 5},
    };
    for (const auto& [expression, value] : numbers) {
        CAPTURE(expression);
        CHECK(standard_number(expression) == doctest::Approx(value).epsilon(1e-9));
    }
    check_near(standard_vector("VPow(<1, 2, 3>, 2)"), {1, 4, 9});
    check_near(standard_vector("VProject_Plane(<1, 2, 3>, 5*y)"), {1, 0, 3});
    check_near(standard_vector("VPerp_To_Vector(y)"), {1, 0, 0});
    const SceneProgram scene = scene_of(everything + "sphere { 0, 1 pigment { color CHSV2RGB(<120, 1, 0.5>) } }");
    check_near(pigment_of(scene).color.rgb, {0, 0.5f, 0});
}

TEST_CASE("standard includes: macros of random numbers leave the stream where POV-Ray's do") {
    // How many numbers each takes, by the one that follows.
    const std::map<std::string, int> taken = {
        {"SRand(R)", 1},
        {"RRand(2, 3, R)", 1},
        {"VRand(R)", 3},
        {"VRand_In_Box(0, 1, R)", 3},
        {"VRand_On_Sphere(R)", 2},
        {"VRand_In_Sphere(R)", 3},
        {"Rand_Gauss(0, 1, R)", 2},
        {"Rand_Erlang(1, 4, R)", 4},
        {"Rand_Binomial(6, 0.5, R)", 6},
    };
    for (const auto& [call, count] : taken) {
        CAPTURE(call);
        const std::string start = everything + "#declare R = seed(7); ";
        std::string skipped = start;
        for (int i = 0; i < count; ++i)
            skipped += "#declare Skip = rand(R); ";
        const SceneProgram expected = scene_of(skipped + "sphere { rand(R)*x, 1 }");
        const SceneProgram scene = scene_of(start + "#declare Skip = " + call + "; sphere { rand(R)*x, 1 }");
        REQUIRE(scene.spheres.size() == 1);
        CHECK(scene.spheres[0].center.x == expected.spheres[0].center.x);
    }
}

TEST_CASE("standard includes: surfaces are known by name") {
    CHECK(finish_of(scene_of(everything + "sphere { 0, 1 finish { Phong_Shiny } }")).phong_size == 200);
    CHECK(finish_of(scene_of(everything + "sphere { 0, 1 texture { T_Silver_3E } }")).reflection_max.x == 0.8f);
    CHECK(finish_of(scene_of(everything + "sphere { 0, 1 texture { T_Gold_5A } }")).reflection_max.x == 0.55f);
    CHECK(pigment_of(scene_of(everything + "sphere { 0, 1 texture { Gold_Metal } }")).color.rgb.z == 0.1f);
    const SceneProgram glass = scene_of(everything + "sphere { 0, 1 material { M_Yellow_Glass } }");
    CHECK(pigment_of(glass).color.filter == 0.8f);
    CHECK(glass.interiors[glass.materials[glass.sphere_materials.at(0)].interior].ior == 1.5f);
}

TEST_CASE("standard includes: #default before them counts in them, as it does in files") {
    const std::string text =
        "#default { finish { ambient 0.5 } } #include \"finish.inc\" sphere { 0, 1 finish { Dull } }";
    CHECK(finish_of(scene_of(text)).ambient.x == 0.5f);
}

TEST_CASE("standard includes: a file is read once, and its names may be declared anew") {
    const std::string text = "#include \"colors.inc\" #declare Red = rgb <0, 0, 1>; #include \"colors.inc\" "
                             "sphere { 0, 1 pigment { Red } }";
    CHECK(pigment_of(scene_of(text)).color.rgb.z == 1);
    CHECK(scene_of("#include \"colors.inc\" #ifdef (Colors_Inc_Temp) sphere { 0, 1 } #end").spheres.size() == 1);
}

TEST_CASE("standard includes: a name that needs what Proxima lacks is there, and refused where it is used") {
    CHECK(error_of(everything + "sphere { 0, 1 texture { T_Wood1 } }") ==
          "'T_Wood1' needs 'wood', which Proxima does not support");
    CHECK(error_of(everything + "sphere { 0, 1 texture { pigment { rgb 1 } } } object { Round_Box(0, 1, 0.1, 0) }") ==
          "'Round_Box' needs 'cylinder', which Proxima does not support");
    CHECK(error_of(everything + "sphere { <0, 0, 0>, 1 texture { T_Wood1 } }") ==
          "'T_Wood1' needs 'wood', which Proxima does not support");
    CHECK(scene_of(everything + "#ifdef (T_Wood1) sphere { 0, 1 } #end").spheres.size() == 1);
    CHECK(scene_of(everything + "#macro Round_Box(A) sphere { 0, A } #end Round_Box(2)").spheres.size() == 1);
    CHECK(scene_of(everything + "#declare T_Wood1 = texture { Gold_Metal } sphere { 0, 1 texture { T_Wood1 } }")
              .spheres.size() == 1);
}

TEST_CASE("standard includes: color maps and gradients are known by name") {
    const std::string start = "#include \"textures.inc\"\n#include \"woodmaps.inc\"\nsphere { 0, 1 pigment { ";
    const SceneProgram gradient = scene_of(start + "X_Gradient } }");
    CHECK(pigment_of(gradient).kind == PigmentKind::gradient);
    const SceneProgram map = scene_of(start + "radial color_map { M_Wood19A } } }");
    const Pattern& pattern = map.patterns.at(pigment_of(map).pattern);
    REQUIRE(pattern.stop_count == 4);
    CHECK(map.color_stops[pattern.first_stop + 1].value == 0.4f);
    check_near(map.color_stops[pattern.first_stop + 1].color.rgb, {1, 0.5f, 0.25f});
}

TEST_CASE("standard includes: what a refused name is said to need is indeed refused") {
    for (const char* name :
         {"arrays",  "chars",    "functions", "glass",      "ior",        "logo",  "math",  "rand",
          "shapes",  "shapes2",  "shapes3",   "shapes_old", "shapesq",    "skies", "stars", "stones1",
          "stones2", "stoneold", "strings",   "textures",   "transforms", "woods"})
        for (const RefusedNames& refused : find_standard_file(std::string(name) + ".inc")->refused) {
            CAPTURE(refused.word);
            const auto words = reserved_words();
            const auto word = std::find(words.begin(), words.end(), refused.word) - words.begin();
            CHECK((word >= ptrdiff_t(Word::first_unsupported) || refused.word == "write" ||
                   refused.word == "caustics" || !word_advice(refused.word).empty()));
        }
}

TEST_CASE("standard includes: a name whose file is not included says which file that is") {
    const Evaluated result = evaluate("sphere { 0, 1 texture { Gold_Metal } }");
    CHECK(result.messages.find("write #include \"textures.inc\" before it") != std::string::npos);
}

TEST_CASE("standard includes: none of their names is noted as unused") {
    CHECK(evaluate(everything + "sphere { 0, 1 }").messages == "");
}

TEST_CASE("standard includes: what functions and splines of a scene are called does not matter to their macros") {
    const SceneProgram scene =
        scene_of("#include \"transforms.inc\" #declare Side = function { x } #declare Front = function { x }"
                 "#declare S = spline { 0, x 1, y }"
                 "sphere { 0, 1 Spline_Trans(S, 0.5, z, 0.1, 0) } sphere { Side(3, 0, 0)*x, 1 }");
    REQUIRE(scene.spheres.size() == 2);
    check_near(scene.spheres[0].center, {0.5, 0.5, 0});
    CHECK(scene.spheres[1].center.x == 3);
}
