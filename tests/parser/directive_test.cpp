// SPDX-License-Identifier: Apache-2.0
// Conditions, loops and includes; the centres of the spheres tell what ran.
#include "tests/parser/evaluate.h"

#include <fmt/format.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

/// The x of every sphere's centre, as text: "1 2 3".
std::string trace(const std::string& text) {
    std::string result;
    for (const Sphere<double>& sphere : scene_of(text).spheres)
        result += fmt::format("{}{}", result.empty() ? "" : " ", int(sphere.center.x));
    return result;
}

} // namespace

TEST_CASE("directives: #if chooses one branch") {
    CHECK(trace("#if (1) sphere { 1, 1 } #else sphere { 2, 1 } #end") == "1");
    CHECK(trace("#if (0) sphere { 1, 1 } #else sphere { 2, 1 } #end") == "2");
    CHECK(trace("#if (0) sphere { 1, 1 } #end sphere { 3, 1 }") == "3");
    CHECK(trace("#if (0) foo #elseif (1) sphere { 2, 1 } #elseif (1) bar #else baz #end") == "2");
    CHECK(trace("#if (1) #if (0) foo #else sphere { 1, 1 } #end #else bar #end") == "1");
    CHECK(trace("#if (1 = 1 & 2 > 1) sphere { 1, 1 } #end") == "1");
}

TEST_CASE("directives: #ifdef and #ifndef look for a name") {
    CHECK(trace("#declare A = 1; #ifdef (A) sphere { 1, 1 } #end #ifdef (B) foo #end") == "1");
    CHECK(trace("#ifndef (A) sphere { 1, 1 } #else foo #end") == "1");
    CHECK(trace("#declare A = 1; #undef A #ifndef (A) sphere { 1, 1 } #end") == "1");
}

TEST_CASE("directives: #switch takes the first case that fits and falls through without #break") {
    const auto choose = [](const char* value) {
        return trace(
            std::string("#switch (") + value +
            ") #case (1) sphere { 1, 1 } #case (2) sphere { 2, 1 } #break #range (4, 6) sphere { 4, 1 } #break "
            "#else sphere { 9, 1 } #end");
    };
    CHECK(choose("1") == "1 2");
    CHECK(choose("2") == "2");
    CHECK(choose("5.5") == "4");
    CHECK(choose("6") == "4");
    CHECK(choose("3") == "9");
    CHECK(trace("#switch (3) #case (3) sphere { 3, 1 } #else sphere { 9, 1 } #end") == "3 9");
    CHECK(trace("#switch (3) #case (1) foo #end") == "");
}

TEST_CASE("directives: #for includes its end and adds up its step") {
    CHECK(trace("#for (I, 1, 4) sphere { I, 1 } #end") == "1 2 3 4");
    CHECK(trace("#for (I, 3, 1, -1) sphere { I, 1 } #end") == "3 2 1");
    CHECK(trace("#for (I, 9999999, 10000000) sphere { I - 9999990, 1 } #end") == "9 10");
    CHECK(trace("#for (I, -9999999, -10000000, -1) sphere { I + 9999990, 1 } #end") == "-9 -10");
    CHECK(trace("#for (I, 0.99e-10, 0) sphere { 1, 1 } #end #for (J, 1e-10, 0) sphere { 2, 1 } #end") == "1");
    CHECK(trace("#for (I, 3, 1) sphere { I, 1 } #end") == "");
    CHECK(trace("#for (I, 0, 1, 0.1) sphere { 10*I + 0.5, 1 } #end") == "0 1 2 3 4 5 6 7 8 9 10");
    CHECK(trace("#for (I, 1, 3) #declare I = I + 1; sphere { I, 1 } #end") == "2 4");
    CHECK(trace("#for (I, 1, 3) #end sphere { I, 1 }") == "4");
    CHECK(trace("#for (I, 1, 9) #if (I = 3) #break #end sphere { I, 1 } #end") == "1 2");
    CHECK(trace("#for (I, 1, 2) #for (J, 1, 2) sphere { 10*I + J, 1 } #end #end") == "11 12 21 22");
}

TEST_CASE("directives: #while asks before every round") {
    CHECK(trace("#declare I = 0; #while (I < 3) sphere { I, 1 } #declare I = I + 1; #end") == "0 1 2");
    CHECK(trace("#while (0) foo #end sphere { 1, 1 }") == "1");
    CHECK(trace("#declare I = 0; #while (1) #declare I = I + 1; #if (I > 2) #break #end sphere { I, 1 } #end") ==
          "1 2");
    CHECK(trace("#declare R = seed(1); #while (rand(R) < 0.9) #end sphere { 1, 1 }") == "1");
}

TEST_CASE("directives: they may stand between any two tokens") {
    CHECK(trace("sphere { #if (1) 5 #else 6 #end , 1 }") == "5");
    CHECK(trace("sphere { <1, #if (0) 2 #end 3, 4>, 1 #if (1) scale 2 #end }") == "2");
    CHECK(trace("union { #for (I, 1, 3) sphere { I, 1 } #end }") == "1 2 3");
    CHECK(trace("sphere { #declare A = 7; A, 1 }") == "7");
    CHECK(trace("sphere { max(0 #for (I, 1, 5) , I #end ), 1 }") == "5");
    const SceneProgram scene =
        scene_of("#declare Shiny = 1; sphere { 0, 1 pigment { #if (Shiny) rgb 1 #else rgb 0 #end } "
                 "#ifdef (Shiny) finish { phong 1 } #end }");
    CHECK(finish_of(scene).phong == 1);
    CHECK(pigment_of(scene).color.rgb.x == 1);
}

TEST_CASE("directives: #version, #error, #warning and #debug") {
    CHECK(error_of("#version 3.8;") == "this is a scene for POV-Ray 3.8; 3.7 is the newest that Proxima knows");
    CHECK(error_of("#version 3.1;") == "this is a scene for POV-Ray 3.1; 3.5 is the oldest that Proxima knows");
    CHECK(error_of("#error \"no\"") == "no");
    CHECK(evaluate("#debug \"nothing\\n\"").messages == "");
    CHECK(evaluate("#warning \"careful\"").messages.find("warning: careful") != std::string::npos);
    CHECK(number_of("version") == 3.7);
}

TEST_CASE("directives: colors.inc is known without the file") {
    const SceneProgram scene = scene_of("#include \"colors.inc\"\nsphere { 0, 1 pigment { color NeonPink } }");
    check_near(pigment_of(scene).color.rgb, glm::vec3(1.0f, 0.43f, 0.78f), 1e-6);
    CHECK(error_of("#include \"no_such.inc\"") == "there is no file no_such.inc");
}

TEST_CASE("directives: heads that are wrong") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"#if 1 #end", "unexpected '1'"},
        {"#if (<1, 2>) #end", "a condition must be a number"},
        {"#ifdef A #end", "unexpected 'A'"},
        {"#for (1, 2, 3) #end", "unexpected '1'"},
        {"#for (I, 1) #end", "unexpected ')'"},
        {"#for (I, 0, 10, 0) #end", "the step of a loop must not be 0"},
        {"#for (sphere, 0, 10) #end", "'sphere' is a reserved word"},
        {"#switch (1) #case 1 #end", "unexpected '1'"},
        {"#include 5", "unexpected '5'"},
        {"#declare 5 = 6;", "unexpected '5'"},
        {"#declare A 6;", "unexpected '6'"},
        {"#fopen F \"a\" read", "there is no file a"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(error_of(test.text) == test.message);
    }
}
