// SPDX-License-Identifier: Apache-2.0
// Functions that a scene declares; values of POV-Ray 3.7.
#include "tests/parser/evaluate.h"

#include <fmt/format.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

/// The value of F, declared by `text`, at some arguments.
double value_of(const std::string& text, const std::string& call) {
    const SceneProgram scene = scene_of(text + " #declare Value = " + call + "; sphere { Value*x, 1 }");
    return scene.spheres.size() == 1 ? scene.spheres[0].center.x : NAN;
}

/// The first error of a function with the parameters A and B and this expression.
std::string error_in(const std::string& expression) {
    return error_of("#declare F = function(A, B) { " + expression + " }");
}

} // namespace

TEST_CASE("declared functions: an expression of its parameters, with POV-Ray's precedence in functions") {
    struct Case {
        const char* expression; ///< of A and B
        double a, b;
        double value;
    };
    const Case cases[] = {
        {"A", 3, 0, 3},
        {"A + 2*B", 1, 2, 5},
        {"1 - A - B", 2, 3, -4},
        {"A/B/4", 2, 4, 0.125},
        {"-A*-B", 3, 2, 6},
        {"2--A", 3, 0, 5},
        {"-A/2 - A", 1, 0, -1.5},
        {"((A + 1))*2", 1, 0, 4},
        {"A*(A > 1)", 2, 0, 2},
        {"A + 1 > 1", 2, 0, 1},
        {"A > 1 + 1", 2, 0, 0},
        {"A < B", 1, 1, 0},
        {"A <= B", 1, 1, 1},
        {"A <= B", 1 + 1e-11, 1, 0}, // without the tolerance that relations have elsewhere
        {"A >= B", 1 - 1e-11, 1, 0},
        {"A = B", 1 + 1e-11, 1, 0},
        {"A = B", 1, 1, 1},
        {"A != B", 1 + 1e-11, 1, 1},
        {"A & B", 1e-11, 1, 1},
        {"A & B", 0, 1, 0},
        {"A | B", 0, 1e-11, 1},
        {"A | B", 0, 0, 0},
        {"A = 1 | A = 2 & A = 3", 1, 0, 1}, // & first
        {"A > 1 & A < 3", 2, 0, 1},
        {"sin(A > 1)", 2, 0, 0.8414709848078965},
        {"select(A - B, 1, 2, 3)", 1, 1 + 1e-11, 1},
        {"select(A, 1, 2)", 5, 0, 2},
        {"max(A, B, 2.5) + min(A, B)", 1, 2, 3.5},
        {"pow(A, 2) + sqrt(B) + atan2(A, B) + mod(B, 3)", 2, 4, 7.463647609000806},
        {"pi + A", 1, 0, 4.141592653589793},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.expression));
        const std::string call = fmt::format("F({:.17g}, {:.17g})", test.a, test.b);
        CHECK(value_of(fmt::format("#declare F = function(A, B) {{ {} }}", test.expression), call) ==
              doctest::Approx(test.value).epsilon(1e-14));
    }
}

TEST_CASE("declared functions: parameters are x, y, z unless named, and may be spelled x, y, z or u, v") {
    CHECK(value_of("#declare F = function { x + 10*y + 100*z };", "F(1, 2, 3)") == 321);
    CHECK(value_of("#declare F = function(y, x) { x + 10*y }", "F(1, 2)") == 12);
    CHECK(value_of("#declare F = function(u, v) { u + 10*v }", "F(1, 2)") == 21);
    CHECK(value_of("#declare F = function(x, Long_name) { x*Long_name }", "F(3, 4)") == 12);
    CHECK(vector_of("x + y") == Vec3<double>(1, 1, 0)); // elsewhere they are what they were
}

TEST_CASE("declared functions: names in it keep the values that they had when it was declared") {
    CHECK(value_of("#declare K = 3; #declare F = function(A) { A*K } #declare K = 4;", "F(2)") == 6);
    CHECK(value_of("#declare T = array[2] { 3, 4 } #declare F = function(A) { T[1] - A*T[0] + T[1] }", "F(1)") == 5);
    CHECK(value_of("#declare G = function(A) { A + 1 } #declare F = function(A) { G(A)*G(2*A) } #undef G", "F(1)") ==
          6);
    CHECK(value_of("#declare K = 1; #macro M() #local K = 5; F(K) #end #declare F = function(A) { A*10 + K }", "M()") ==
          51);
}

TEST_CASE("declared functions: directives and macros in the expression run when it is declared") {
    CHECK(value_of("#declare Q = 1; #declare F = function(A) { A #if (Q) + 1 #else + 2 #end } #declare Q = 0;",
                   "F(1)") == 2);
    CHECK(value_of("#macro Twice(Q) Q*2 #end #declare F = function(A) { Twice(3) + A }", "F(1)") == 7);
    CHECK(value_of("#macro Twice() A*2 #end #declare F = function(A) { Twice() + A }", "F(1)") == 3);
    CHECK(value_of("#macro Shift(Fn) function { Fn(x + 1, y, z) } #end"
                   " #declare G = function { x*y*z } #declare F = Shift(G)",
                   "F(1, 2, 3)") == 12);
}

TEST_CASE("declared functions: their values are numbers like others") {
    const std::string text = "#declare F = function(A) { A*A }";
    CHECK(value_of(text, "F(F(2))") == 16);
    CHECK(value_of(text, "-F(2) + 2*F(1)") == -2);
    CHECK(value_of(text, "(F(1) < 2)") == 1);
    CHECK(value_of(text, "vlength(<F(2), 0, 3>)") == 5);
    CHECK(value_of(text, "F(<1, 3, 2>.y)") == 9);
    CHECK(value_of(text, "F((1 < 2))") == 1);
    const SceneProgram scene = scene_of(text + "sphere { <F(1) F(2) 0> F(3) pigment { rgb F(0.5) } translate F(2) }");
    CHECK(scene.spheres.at(0).center == Vec3<double>(5, 8, 4));
    CHECK(scene.spheres[0].radius == 9);
    CHECK(pigment_of(scene).color.rgb == glm::vec3(0.25f));
}

TEST_CASE("declared functions: copies, elements of arrays, arguments of macros") {
    CHECK(value_of("#declare G = function(A) { A + 1 } #declare F = G; #undef G", "F(1)") == 2);
    CHECK(value_of("#declare B = array[2] { function(A) { A*2 }, function(A) { A*3 } }", "B[1](2) + B[0](1)") == 8);
    CHECK(value_of("#declare B = array[2]; #declare B[0] = function(A) { A*2 };", "B[0](3)") == 6);
    CHECK(value_of("#macro At2(G) G(2) #end #declare F = function(A) { A*7 }", "At2(F)") == 14);
    CHECK(value_of("#macro At2(G) G(2) #end", "At2(function(A) { A*7 })") == 14);
    CHECK(value_of("#macro M() #local G = function(A) { A*3 } G(2) #end", "M() + M()") == 12);
    CHECK(number_of("defined(F)") == 0);
    CHECK(value_of("#declare F = function { 1 }", "defined(F)") == 1);
}

TEST_CASE("declared functions: what POV-Ray refuses in the expression is refused") {
    struct Case {
        const char* expression;
        const char* message;
    };
    const Case cases[] = {
        {"", "unexpected '}'"},
        {"A +", "unexpected '}'"},
        {"A, B", "unexpected ','"},
        {"A;", "unexpected ';'"},
        {"A B", "unexpected 'B'"},
        {"A^2", "unexpected character '^'"},
        {"!A", "unexpected '!'"},
        {"- -A", "unexpected '-'"},
        {"A == 1", "unexpected '='"},
        {"A > 1 ? 2 : 3", "unexpected '?'"},
        {"(A", "unexpected '}'"},
        {"A(2)", "unexpected '('"},
        {"A.x", "unexpected '.'"},
        {"<A, B, 1>.x", "a function has no vectors"},
        {"vlength(A)", "'vlength' cannot stand in a function"},
        {"x", "'x' cannot stand in a function"},
        {"true", "'true' cannot stand in a function"},
        {"rand(A)", "'rand' cannot stand in a function"},
        {"seed(A)", "'seed' cannot stand in a function"},
        {"bitwise_and(A, 1)", "'bitwise_and' cannot stand in a function"},
        {"strlen(\"a\")", "'strlen' cannot stand in a function"},
        {"defined(A)", "'defined' cannot stand in a function"},
        {"F(A)", "'F' is not declared"},
        {"sin A", "unexpected 'A'"},
        {"sin(A, B)", "this function takes 1 arguments, here are 2"},
        {"pow(A)", "this function takes 2 arguments, here are 1"},
        {"max(A)", "this function takes at least 2 arguments, here are 1"},
        {"select(A, 1)", "this function takes at least 3 arguments, here are 2"},
        {"select(A, 1, 2, 3, 4)", "this function takes at most 4 arguments, here are 5"},
        {"sqr(A)", "Proxima does not support 'sqr'"},
        {"sum(I, 1, A, I)", "Proxima does not support 'sum'"},
        {"pigment { rgb 1 }", "unexpected 'pigment'"},
        {"A < B < 1", "two relations stand in a row"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.expression));
        CHECK(error_in(test.expression) == test.message);
    }
    CHECK(error_of("#declare V = <1, 2, 3>; #declare F = function(A) { V.y + A }") ==
          "'V' is a vector: a function has numbers alone");
    CHECK(error_of("#declare G = function(A) { A } #declare F = function(A) { G(A, 1) }") ==
          "this function takes 1 arguments, here are 2");
    CHECK(error_of("#declare G = function(A) { A } #declare F = function(A) { G }") == "unexpected '}'");
    CHECK(error_of("#declare S = spline { 0, x 1, y } #declare F = function(A) { S(A).x }") ==
          "unexpected 'S', which is a spline");
}

TEST_CASE("declared functions: mistakes in parameters, calls and declarations") {
    CHECK(error_of("#declare F = function() { 1 }") == "unexpected ')'");
    CHECK(error_of("#declare F = function(A,) { A }") == "unexpected ')'");
    CHECK(error_of("#declare F = function(A, A) { A }") == "there are two parameters 'A'");
    CHECK(error_of("#declare F = function(t) { t }") == "unexpected 't'");
    CHECK(error_of("#declare F = function(x, u) { x }") == "u and v cannot be parameters beside x, y and z");
    CHECK(error_of("#declare K = 1; #declare F = function(K) { K }") == "'K' is a number already");
    CHECK(error_of("#declare F = function A { A }") == "'A' is not declared");
    const std::string text = "#declare F = function(A) { A } ";
    CHECK(error_of(text + "#declare B = F();") == "unexpected ')'");
    CHECK(error_of(text + "#declare B = F(1, 2);") == "unexpected ','");
    CHECK(error_of(text + "#declare B = F(x);") == "the argument A of this function is a number, not a vector");
    CHECK(error_of(text + "#declare B = F(1)") == "this #declare lacks its ';'");
    CHECK(error_of(text + "#declare B = F") == "this #declare lacks its ';'");
    CHECK(error_of(text + "sphere { 0, F }") == "unexpected '}'");
    CHECK(error_of(text + "#declare F = function(A) { A }") == "'F' is a function already");
    CHECK(error_of(text + "#declare F = 3;") == "'F' is a function already");
    CHECK(error_of(text + "#macro M() #local F = function(A) { A } #end M()") == "'F' is a function already");
    CHECK(error_of(text + "#for (F, 1, 2) #end") == "'F' is a function already");
    CHECK(error_of("#declare F = 3; #declare F = function(A) { A }") == "'F' is a number already");
    CHECK(error_of(text + "#undef F #declare F = 3; sphere { 0, F }") == "");
    CHECK(error_of("sphere { 0, 1 pigment { function { x } } }") == "Proxima does not support 'function'");
}

TEST_CASE("declared functions: values that do not exist are mistakes of the expression") {
    CHECK(error_of("#declare F = function(A) { 1/A } sphere { 0, F(0) }") == "division by zero");
    CHECK(error_of("#declare F = function(A) { ln(A) } sphere { 0, F(0) }") == "'ln' has no finite value here");
    CHECK(error_of("#declare F = function(A) { A*A } sphere { 0, F(1e200) }") == "'F' has no finite value here");
    // The reader goes on behind the item.
    const Evaluated result =
        evaluate("#declare F = function(A) { 1/A } sphere { 0, F(0) } sphere { 0, 1 } sphere { 0, -1 }");
    CHECK(result.diagnostics.error_count() == 2);
}

TEST_CASE("declared functions: long ones, deep ones and many calls end with a message") {
    std::string chain = "#declare F0 = function(A) { A + 1 }\n";
    for (int i = 1; i < 60; ++i)
        chain += fmt::format("#declare F{} = function(A) {{ F{}(A) + F{}(A) }}\n", i, i - 1, i - 1);
    EvaluationSettings settings;
    settings.budget.steps = 1'000'000;
    CHECK(error_of(chain + "sphere { 0, F59(1) }", settings).find("steps") != std::string::npos);
    std::string deep = "#declare F0 = function(A) { A + 1 }\n";
    for (int i = 1; i < 300; ++i)
        deep += fmt::format("#declare F{} = function(A) {{ F{}(A) }}\n", i, i - 1);
    CHECK(error_of(deep + "sphere { 0, F50(1) }") == "");
    CHECK(error_of(deep + "sphere { 0, F299(1) }") == "this is nested more than 200 deep");
    std::string sum = "A";
    for (int i = 0; i < 20'000; ++i)
        sum += "+A";
    CHECK(error_in(sum) == "the expression of this function is too long");
}
