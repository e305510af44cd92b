// SPDX-License-Identifier: Apache-2.0
// Functions of numbers and vectors; values of POV-Ray 3.7.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("functions: numbers") {
    struct Case {
        const char* text;
        double value;
    };
    const Case cases[] = {
        {"abs(-2)", 2},
        {"acos(0)", 1.5707963267948966},
        {"asin(1)", 1.5707963267948966},
        {"atan2(1, -1)", 2.356194490192345},
        {"atan(1)", 0.7853981633974483},
        {"acosh(1)", 0},
        {"asinh(1)", 0.881373587019543},
        {"atanh(0.5)", 0.5493061443340549},
        {"ceil(1.2)", 2},
        {"floor(-2.5)", -3},
        {"int(-2.7)", -2},
        {"int(2.7)", 2},
        {"mod(-7, 3)", -1},
        {"mod(7, -3)", 1},
        {"div(-7, 2)", -3},
        {"degrees(pi)", 180},
        {"radians(180)", 3.141592653589793},
        {"exp(1)", 2.718281828459045},
        {"ln(exp(2))", 2},
        {"log(1000)", 3},
        {"pow(2, 10)", 1024},
        {"pow(-2, 3)", -8},
        {"sqrt(2)", 1.4142135623730951},
        {"sin(pi/6)", 0.5},
        {"cos(pi/3)", 0.5},
        {"tan(pi/4)", 1},
        {"sinh(1)", 1.1752011936438014},
        {"cosh(1)", 1.5430806348152437},
        {"tanh(1)", 0.7615941559557649},
        {"max(1, 5, 3)", 5},
        {"min(4, 2, 8)", 2},
        {"max(1, 2)", 2},
        {"select(-1, 2, 3)", 2},
        {"select(0, 2, 3)", 3},
        {"select(1, 2, 3)", 3},
        {"select(0, 2, 3, 4)", 3},
        {"select(1, 2, 3, 4)", 4},
        {"bitwise_and(12, 10)", 8},
        {"bitwise_or(12, 10)", 14},
        {"bitwise_xor(12, 10)", 6},
        {"vdot(<1, 2, 3>, <4, 5, 6>)", 32},
        {"vlength(<3, 4, 0>)", 5},
        {"defined(Nothing)", 0},
        {"defined(frame_number)", 1},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(number_of(test.text) == doctest::Approx(test.value).epsilon(1e-12));
    }
}

TEST_CASE("functions: vectors turn left-handed, about x, then y, then z") {
    check_near(vector_of("vrotate(x, 90*z)"), {0, 1, 0});
    check_near(vector_of("vrotate(x, 90*y)"), {0, 0, -1});
    check_near(vector_of("vrotate(y, 90*x)"), {0, 0, 1});
    check_near(vector_of("vaxis_rotate(x, y, 90)"), {0, 0, -1});
    check_near(vector_of("vrotate(<1, 2, 3>, <10, 20, 30>)"), {1.06742538, 2.28905948, 2.76058141}, 1e-8);
    check_near(vector_of("vaxis_rotate(<1, 2, 3>, <1, 1, 0>, 30)"), {2.12764747, 0.87235253, 2.95162960}, 1e-8);
    check_near(vector_of("vcross(x, y)"), {0, 0, 1});
    check_near(vector_of("vnormalize(<0, 0, 5>)"), {0, 0, 1});
}

TEST_CASE("functions: random numbers are POV-Ray's") {
    CHECK(number_of("seed(77)") == 0);
    const SceneProgram scene = scene_of("#declare A = seed(1234); #declare B = seed(0);"
                                        "sphere { <rand(A), rand(B), rand(A)>, 1 }");
    CHECK(scene.spheres[0].center.x == doctest::Approx(0.735663955038).epsilon(1e-11));
    CHECK(scene.spheres[0].center.y == doctest::Approx(2.874294e-6).epsilon(1e-6));
    CHECK(scene.spheres[0].center.z == doctest::Approx(0.834535582185).epsilon(1e-11));
    CHECK(number_of("rand(seed(-1))") == doctest::Approx(0.578013).epsilon(1e-6));
    CHECK(error_of("#declare R = seed(3e9);") ==
          "a stream of random numbers starts from a number between -2147483648 and 2147483647");
    CHECK(error_of("sphere { rand(3), 1 }") == "this is no stream of random numbers");
}

TEST_CASE("functions: values that do not exist are mistakes") {
    for (const char* text :
         {"sqrt(-1)", "atan2(0, 0)", "ln(0)", "log(-1)", "pow(0, 0)", "asin(2)", "acos(-2)", "pow(-8, 1/3)",
          "mod(3, 0)", "div(3, 0)", "exp(1000)", "acosh(0.5)", "atanh(1)", "bitwise_and(3000000000, 1)"}) {
        CAPTURE(std::string(text));
        CHECK(error_of(std::string("sphere { ") + text + ", 1 }").find("has no finite value here") !=
              std::string::npos);
    }
    CHECK(error_of("sphere { vnormalize(0*x), 1 }") == "a vector of length 0 has no direction");
    CHECK(error_of("sphere { vaxis_rotate(x, 0*x, 90), 1 }") == "the axis has length 0");
    CHECK(error_of("sphere { pow(2), 1 }") == "unexpected ')'");
    CHECK(error_of("sphere { sin(1, 2), 1 }") == "unexpected ','");
    CHECK(error_of("sphere { sin 1, 1 }") == "unexpected '1'");
}
