// SPDX-License-Identifier: Apache-2.0
// Operators, precedence and promotion; every value was read off POV-Ray 3.7.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("expressions: operators have POV-Ray's precedence") {
    struct Case {
        const char* text;
        double value;
    };
    const Case cases[] = {
        {"1 + 2*3", 7},
        {"(1 + 2)*3", 9},
        {"7 - 3 - 2", 2},
        {"8/4/2", 1},
        {"-2*-3 + !0", 7},
        {"3 + - 2", 1},
        {"-!1", 0},
        {"!-1", 0},
        {"!2", 0},
        {"1 -1", 0},
        {".5", 0.5},
        {"5.", 5},
        {"1.e2", 100},
        {"1 | 1 & 0", 0},
        {"0 & 0 | 1", 1},
        {"1 < 2 < 3", 1},
        {"3 > 2 > 1", 0},
        {"1 = 1 = 0", 0},
        {"2 & 1", 1},
        {"1 + 1 = 2", 1},
        {"-2 = -2 & 1", 1},
        {"1 <= 1", 1},
        {"1 >= 2", 0},
        {"1 != 1", 0},
        {"1 ? 2 : 3", 2},
        {"0 ? 2 : 1 ? 4 : 5", 4},
        {"1 ? 0 ? 7 : 8 : 9", 8},
        {"0.5 ? 1 : 2", 1},
        {"1e-11 ? 1 : 2", 2},
        {"1e-11 = 0", 1},
        {"0.1e-9 & 1", 0},
        {"1 + (2 = 2)*3", 4},
        {"\"a\" = \"a\"", 1},
        {"\"a\" < \"b\"", 1},
        {"\"a\" != \"a\"", 0},
        {"true + yes + on", 3},
        {"false + no + off", 0},
        {"pi", 3.141592653589793},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(number_of(test.text) == doctest::Approx(test.value).epsilon(1e-12));
    }
}

TEST_CASE("expressions: numbers are repeated and vectors padded to the longer side") {
    struct Case {
        const char* text;
        Vec3<double> value;
    };
    const Case cases[] = {
        {"<1, 2, 3>", {1, 2, 3}},
        {"<1 2 3>", {1, 2, 3}},
        {"<1, 2> + <1, 1, 1>", {2, 3, 1}},
        {"<1, 2> + 3", {4, 5, 0}},
        {"5*<1, 0, 2>/2", {2.5, 0, 5}},
        {"<1, 2, 3>*<2, 2, 2>.z", {2, 4, 6}},
        {"3/<1, 2, 4>", {3, 1.5, .75}},
        {"x + 2*y", {1, 2, 0}},
        {"-<1, 2, 3>", {-1, -2, -3}},
        {"!<1, 0, 1>", {0, 1, 0}},
        {"2", {2, 2, 2}},
        {"<1, 2, 3>*<1, 2, 3>", {1, 4, 9}},
        {"u + 2*v", {1, 2, 0}},
        {"z*z", {0, 0, 1}},
        {"(<1, 2, 3> < <2, 1, 4>)", {1, 0, 1}},
        {"(<1, 2> = <1, 3>)", {1, 0, 0}},
        {"(x ? <1, 2, 3> : y)", {NAN, 0, 0}},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        if (std::isnan(test.value.x))
            CHECK(error_of(std::string("sphere { ") + test.text + ", 1 }") ==
                  "the condition before '?' must be a number");
        else
            check_near(vector_of(test.text), test.value, 1e-14);
    }
}

TEST_CASE("expressions: one term of a vector") {
    struct Case {
        const char* text;
        double value;
    };
    for (const Case& test : {Case{"<1, 2, 3>.y", 2}, Case{"-<1, 2, 3>.y*2", -4}, Case{"x.x + 5", 6},
                             Case{"(<1, 2, 3>).z", 3}, Case{"2*<1, 2>.v", 4}, Case{"<1, 2, 3, 4, 5>.filter", 4},
                             Case{"<1, 2, 3, 4, 5>.transmit", 5}, Case{"<1, 2, 3, 4>.t", 4}, Case{"<1, 2, 3>.red", 1},
                             Case{"<1, 2, 3>.gray", 1.817}, Case{"vnormalize(<3, 4, 0>).y", 0.8}}) {
        CAPTURE(std::string(test.text));
        CHECK(number_of(test.text) == doctest::Approx(test.value).epsilon(1e-12));
    }
    CHECK(error_of("sphere { <1, 2>.z, 1 }") == "this vector has 2 terms and no .z");
}

TEST_CASE("expressions: mistakes") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"1/0", "division by zero"},
        {"<1, 2, 3>/<1, 2>", "division by zero"},
        {"<1>", "unexpected '>'"},
        {"<1, 2, 3, 4, 5, 6>", "unexpected '6'"},
        {"(1 == 1)", "there is no operator '=='"},
        {"(<1, 2>=<1, 2>=0)", "unexpected '>='"},
        {"1 +", "unexpected ','"},
        {"<x, 0, 0>", "a number is needed here, not a vector or color"},
        {"\"a\"", "unexpected '\"a\"'"},
        {"<1, 2, 3, 4>", "a vector has at most 3 terms, this one has 4"},
        {"exp(400)*exp(400)*1e200*1e200", "a vector is not finite"},
        {"<1, 2>.q", "'q' is not declared"},
        {"now", "Proxima does not support 'now'"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(error_of(std::string("sphere { ") + test.text + ", 1 }") == test.message);
    }
    // Relations need parentheses outside of conditions.
    CHECK(error_of("sphere { 0, 1 < 2 }") == "unexpected '<'");
    CHECK(error_of("#declare A = 1 = 1;") == "this #declare lacks its ';'");
}
