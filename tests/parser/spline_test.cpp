// SPDX-License-Identifier: Apache-2.0
// Splines; values of POV-Ray 3.7.
#include "tests/parser/evaluate.h"

#include <fmt/format.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

/// Points at uneven times.
const std::string points = " 0, <1.25, 0, 1> 1, <-3, 1, 0> 2.5, <0.7, 2, 0> 3, <2, 3, 0> 5, <9, 4, 1> ";

Vec3<double> point_of(const std::string& spline, const std::string& call) {
    const SceneProgram scene = scene_of("#declare S = spline { " + spline + " } sphere { " + call + ", 1 }");
    return scene.spheres.size() == 1 ? scene.spheres[0].center : Vec3<double>(NAN);
}

} // namespace

TEST_CASE("splines: the four kinds give POV-Ray's values, between the points and outside") {
    struct Case {
        double time;
        double linear, quadratic, cubic, natural;
    };
    const Case cases[] = {
        {-1, 1.25, 1.25, -3, 1.25},
        {0.25, 0.1875, -0.31625, -3, -0.166953125},
        {1, -3, -3, -3, -3},
        {1.25, -2.383333333333333, -3.222916666666666, -2.96869212962963, -3.044392361111111},
        {2.25, 0.083333333333333, -0.75625, -0.044849537037037, -0.14529513888889},
        {2.6, 0.96, 0.957333333333333, 0.948533333333334, 0.989216},
        {2.9, 1.74, 1.737333333333333, 1.710133333333333, 1.750024},
        {4.5, 7.25, 6.98, 2, 7.0284375},
        {5, 9, 9, 2, 9},
        {6, 9, 9, 2, 9},
    };
    for (const Case& test : cases) {
        CAPTURE(test.time);
        const auto value = [&](const char* kind) {
            // As the spline's own kind, and as the one that a call asks for.
            const double own = point_of(kind + points, fmt::format("S({})", test.time)).x;
            const double asked = point_of("natural_spline" + points, fmt::format("S({}, {})", test.time, kind)).x;
            CHECK(own == asked);
            return own;
        };
        CHECK(value("linear_spline") == doctest::Approx(test.linear).epsilon(1e-14));
        CHECK(value("quadratic_spline") == doctest::Approx(test.quadratic).epsilon(1e-14));
        CHECK(value("cubic_spline") == doctest::Approx(test.cubic).epsilon(1e-14));
        CHECK(value("natural_spline") == doctest::Approx(test.natural).epsilon(1e-14));
    }
}

TEST_CASE("splines: few points") {
    check_near(point_of("0, <1, 2, 3>", "S(7)"), {1, 2, 3});
    check_near(point_of("natural_spline 0, <1, 2, 3>", "S(0)"), {1, 2, 3});
    check_near(point_of("quadratic_spline 0, x 1, y", "S(0.25)"), {0.75, 0.25, 0});
    check_near(point_of("natural_spline 0, x 1, y", "S(0.25)"), {0.75, 0.25, 0});
    check_near(point_of("natural_spline 0, x 1, y 2, z", "S(0.25)"), {0.69140625, 0.3671875, -0.05859375});
    check_near(point_of("cubic_spline 0, x 1, y 2, z", "S(1.5)"), {0, 1, 0});
    CHECK(error_of("#declare S = spline { }") == "a spline needs a point");
    CHECK(error_of("#declare S = spline { cubic_spline 0, x 1, y }") == "a cubic_spline of two points has no slope");
    CHECK(error_of("#declare S = spline { 0, x 1, y } sphere { S(0, cubic_spline), 1 }") ==
          "a cubic_spline of two points has no slope");
}

TEST_CASE("splines: points come in any order, from loops too, with or without commas") {
    check_near(point_of("1, <1, 2, 3> 0, <2, 3, 4> 0.5, <7, 7, 7>", "S(0.25)"), {4.5, 5, 5.5});
    check_near(point_of("#for (I, 0, 3) I, <I, I*I, 0> #end", "S(1.5)"), {1.5, 2.5, 0});
    check_near(point_of("0, x, 1, y,", "S(0.25)"), {0.75, 0.25, 0});
    check_near(point_of("0 x 1 y", "S(0.25)"), {0.75, 0.25, 0});
    check_near(point_of("-1, x (1 + 1), y", "S(0.5)"), {0.5, 0.5, 0});
}

TEST_CASE("splines: values have as many terms as the points, two at least") {
    const auto term = [](const std::string& spline, const std::string& term) {
        const SceneProgram scene =
            scene_of("#declare S = spline { " + spline + " } sphere { <S(0.5)." + term + ", 0, 0>, 1 }");
        return scene.spheres.at(0).center.x;
    };
    CHECK(term("0, 1 1, 2", "y") == 1.5);
    CHECK(term("0, <1, 2, 3, 4> 1, <2, 3, 4, 5>", "t") == 4.5);
    CHECK(term("0, <1, 2, 3, 4, 5> 1, <2, 3, 4, 5, 6>", "transmit") == 5.5);
    CHECK(error_of("#declare S = spline { 0, 1 1, 2 } sphere { 0, S(0.5) }") ==
          "a number is needed here, not a vector or color");
    CHECK(error_of("#declare S = spline { 0, <1, 2> 1, <2, 3> } sphere { 0, S(0.5).z }") ==
          "this vector has 2 terms and no .z");
    CHECK(error_of("#declare S = spline { 0, <1, 2> 1, <2, 3, 4> }") == "this point has 3 terms, the one before has 2");
}

TEST_CASE("splines: one may go on from another; copies, elements, arguments") {
    const std::string text = "#declare S = spline { 0, x 1, y } ";
    const auto point = [&](const std::string& more, const std::string& call) {
        return scene_of(text + more + " sphere { " + call + ", 1 }").spheres.at(0).center;
    };
    check_near(point("#declare T = spline { S 2, z }", "T(1.25)"), {0, 0.75, 0.25});
    check_near(point("#declare T = spline { S cubic_spline 2, z 3, x }", "T(1.25)"), {-0.09375, 0.8671875, 0.2265625});
    check_near(point("#declare S = spline { S 2, z }", "S(1.25)"), {0, 0.75, 0.25});
    check_near(point("#declare S = spline { 0, y 1, z }", "S(0.25)"), {0, 0.75, 0.25});
    check_near(point("#declare T = S; #undef S", "T(0.25)"), {0.75, 0.25, 0});
    check_near(point("#declare A = array[1] { S }", "A[0](0.25)"), {0.75, 0.25, 0});
    check_near(point("#macro M(Q) Q(0.25) #end", "M(S)"), {0.75, 0.25, 0});
    check_near(point("#declare P = 2*S(0.5) + x;", "P"), {2, 1, 0});
    check_near(point("#declare F = function(A) { A/2 }", "S(F(1), linear_spline)"), {0.5, 0.5, 0});
}

TEST_CASE("splines: mistakes") {
    CHECK(error_of("#declare S = spline { 0, x 0, y }") == "this spline has a point at 0 already");
    CHECK(error_of("#declare S = spline { 0, x 1 }") == "unexpected '}'");
    CHECK(error_of("#declare S = spline { 0, x; 1, y }") == "unexpected ';'");
    CHECK(error_of("#declare S = spline { 0, x y }") == "unexpected 'y'");
    CHECK(error_of("#declare S = spline { x, x }") == "unexpected 'x'");
    CHECK(error_of("#declare S = spline { x.x, x }") == "unexpected 'x'");
    CHECK(error_of("#declare S = spline { linear_spline, 0 x 1 y }") == "unexpected ','");
    CHECK(error_of("#declare S = spline { 0, x 1, y linear_spline }") == "unexpected 'linear_spline'");
    CHECK(error_of("#declare S = spline { b_spline 0, x 1, y }") == "Proxima does not support 'b_spline'");
    CHECK(error_of("#declare S = spline { 0, rgb 1 }") == "unexpected 'rgb'");
    CHECK(error_of("spline { 0, x 1, y }") == "unexpected 'spline'");
    const std::string text = "#declare S = spline { 0, x 1, y } ";
    CHECK(error_of(text + "#declare T = S") == "this #declare lacks its ';'");
    CHECK(error_of(text + "#declare P = S(0.5)") == "this #declare lacks its ';'");
    CHECK(error_of(text + "#declare T = spline { S, 2, z }") == "unexpected ','");
    CHECK(error_of(text + "#declare T = spline { cubic_spline S 2, z 3, x }") == "unexpected 'S', which is a spline");
    CHECK(error_of(text + "sphere { S, 1 }") == "unexpected ','");
    CHECK(error_of(text + "sphere { S(), 1 }") == "unexpected ')'");
    CHECK(error_of(text + "sphere { S(x), 1 }") == "a number is needed here, not a vector or color");
    CHECK(error_of(text + "sphere { S(0.5,), 1 }") == "unexpected ')'");
    CHECK(error_of(text + "sphere { S(0.5, b_spline), 1 }") == "Proxima does not support 'b_spline'");
    CHECK(error_of(text + "sphere { 0, 1 pigment { S(0.5) } }") == "unexpected 'S', which is a spline");
}
