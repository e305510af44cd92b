// SPDX-License-Identifier: Apache-2.0
// What carries the time through the language: splines, functions, macros and arrays. Their programs say at any time
// what the script says at that time, to the bit.
#include "tests/parser/evaluate.h"
#include "tests/parser/scene_numbers.h"

#include <fmt/format.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

EvaluationSettings settings_at(double clock, bool record) {
    EvaluationSettings settings;
    settings.time = {.clock = clock, .clock_delta = 0.125, .frame_number = 8 * clock + 1};
    settings.record_motion = record;
    return settings;
}

/// Checks the motion programs of a script at several times; none of them may be left to the script.
SceneProgram check_programs(const std::string& text) {
    INFO(text);
    SceneProgram scene = scene_of(text, settings_at(0.25, true));
    CHECK(!scene.obstacle);
    CHECK(!scene.motion.empty());
    for (const double clock : {0.0, 0.25, 0.375, 0.5, 0.8125, 1.0, -1.5, 3.75}) {
        CAPTURE(clock);
        const SceneProgram direct = scene_of(text, settings_at(clock, false));
        REQUIRE(move(scene, {clock, 8 * clock + 1, 0.125}));
        CHECK(likeness(numbers_of(scene), numbers_of(direct)) == Likeness::bits);
    }
    return scene;
}

} // namespace

TEST_CASE("motion values: splines of every kind are looked up by the time") {
    const char* const points = "0, <0, 1, -0> 0.25, <3, 1, 0.5> 0.5, <2, 7, 1> 0.75, <1, 0, 9> 1, <0.5, 0.25, 0>";
    for (const char* kind : {"linear_spline", "quadratic_spline", "cubic_spline", "natural_spline"}) {
        const std::string spline = fmt::format("#declare S = spline {{ {} {} }}\n", kind, points);
        check_programs(spline + "camera { location S(clock)-9*z look_at S(clock+0.125) }");
        check_programs(spline + "light_source { S(1-clock), S(clock*2) }");
        check_programs(spline + "sphere { S(sin(clock)), 1 pigment { rgb S(frame_number/9) } }");
        check_programs(spline + "union { sphere { 0, 1 } plane { S(clock)+9*y, 1 } translate S(clock) }");
        // The call's kind, a term, a spline of a spline, few points.
        check_programs(fmt::format("{}sphere {{ S(clock, linear_spline) + S(S(clock, {}).x), 1 }}", spline, kind));
        check_programs(fmt::format("#declare S = spline {{ {} 0, y }} sphere {{ S(clock)+clock*x, 1 }}", kind));
        check_programs(fmt::format("#declare S = spline {{ {} 0, x 1, y 1.5, z }} sphere {{ S(clock), 1 }}", kind));
    }
    check_programs("#declare S = spline { natural_spline 0, x 1, y } sphere { S(clock), 1 }");
    check_programs("#declare S = spline { 0, <1,2,3,4,5> 1, <5,4,3,2,1> }"
                   "sphere { 0, 1 pigment { color S(clock)*0.2 } }");
    check_programs("#declare S = spline { 0, 1 2, 3 } sphere { <S(clock).x, S(clock).y, 0>, 1 }");
}

TEST_CASE("motion values: places of a color map, axes of gradients and albedos follow from the time") {
    const auto on_sphere = [](const std::string& surface) { check_programs("sphere { 0, 1 " + surface + " }"); };
    on_sphere("pigment { gradient y color_map { [0.1*clock rgb 0] [0.5+0.1*clock, 0.9 color rgb x color rgb y*clock] "
              "[1 rgb 1] } }");
    on_sphere("pigment { leopard color_map { [0 rgb 0] [0.2+clock*clock/99 rgb x] [1.5 rgb 1] } }");
    on_sphere("pigment { gradient <1, 0.3*clock, 0.2> color_map { [0 rgb 0] [1 rgb 1] } translate clock*x }");
    on_sphere("pigment { gradient <0.2, 3+0.3*clock, 0.2> rotate 9*clock }");
    on_sphere("finish { diffuse albedo 0.3+0.1*sin(clock) brilliance 2+cos(clock) }");
    on_sphere(
        "finish { phong albedo 0.5 phong_size 20+clock specular albedo 0.1*clock*clock roughness 0.01+clock*clock }");
    check_programs("#declare F = finish { diffuse 0.1*clock brilliance 1.5+clock/7 specular clock/3 }\n"
                   "sphere { 0, 1 finish { F diffuse albedo 0.7 } } sphere { 0, 1 finish { F specular albedo 0.25 } }\n"
                   "#declare M = color_map { [clock/9 rgb 0] [1 rgb <1, clock, 0>] }\n"
                   "sphere { 0, 1 pigment { radial color_map { M } } }");
}

TEST_CASE("motion values: colors of sRGB may go below black") {
    for (const char* gamma : {"1", "srgb"})
        check_programs(
            fmt::format("#version 3.7; global_settings {{ assumed_gamma {} }} background {{ srgb clock-2 }}\n"
                        "sphere {{ 0, 1 pigment {{ srgb <sin(9*clock), clock-0.5, 0.04045*clock> }} }}",
                        gamma));
}

TEST_CASE("motion values: an order or a side that changes is left to the script") {
    const auto left_at = [](const std::string& text, double clock) {
        SceneProgram scene = scene_of(text, settings_at(0.25, true));
        CHECK(!scene.obstacle);
        return !move(scene, {clock, 8 * clock + 1, 0.125});
    };
    const std::string map = "sphere { 0, 1 pigment { gradient y color_map { [clock rgb 0] [0.5 rgb 1] } } }";
    CHECK_FALSE(left_at(map, 0.5));
    CHECK(left_at(map, 0.625)); // where it says that the values must rise
    CHECK(error_of(map, settings_at(0.625, false)) == "the values of a color map must rise, 0.5 stands behind 0.625");
    const std::string axis = "sphere { 0, 1 pigment { gradient <clock, 1, 0> } }";
    CHECK_FALSE(left_at(axis, 0.5));
    CHECK(left_at(axis, 0.75)); // another vector stands beside it then
    CHECK(left_at("sphere { 0, 1 pigment { gradient (clock - 0.5)*x } }", 0.5));
}

TEST_CASE("motion values: a spline that goes on from another one is another one") {
    check_programs("#declare S = spline { natural_spline 0, x 1, y 2, z }\n"
                   "sphere { S(clock), 1 }\n"
                   "#declare T = spline { S cubic_spline 3, <5, 1, 0> }\n"
                   "sphere { S(clock), 1 } sphere { T(clock), 1 } #declare S = T; sphere { S(clock), 1 }");
}

TEST_CASE("motion values: spheres on splines share a program, on one spline or each on its own") {
    const SceneProgram shared = check_programs("#declare S = spline { natural_spline 0, x 0.5, y 0.75, <1,2,3> 1, z }\n"
                                               "#for (I, 1, 500) sphere { S(mod(clock+I/500, 1)) + I*y, 0.5 } #end");
    CHECK(shared.motion.spheres.programs.size() == 1);
    CHECK(shared.motion.spheres.programs[0].own_constants == 2); // I/500, I
    CHECK(shared.motion.splines.size() == 4 + 3 * (2 + 2 * 4));
    const SceneProgram own = check_programs("#declare R = seed(3);\n"
                                            "#for (I, 1, 500)\n"
                                            "  #declare S = spline { cubic_spline\n"
                                            "    #for (K, 0, 2+mod(I,5)) K/3, <rand(R), rand(R), I> #end }\n"
                                            "  sphere { S(clock), 0.5 }\n"
                                            "#end");
    CHECK(own.motion.spheres.programs.size() == 1);
    CHECK(own.motion.spheres.programs[0].own_constants == 3); // where the terms stand
}
