// SPDX-License-Identifier: Apache-2.0
// #macro: arguments by name and by value, and calls in every place. Values of POV-Ray 3.7.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

double value_after(const std::string& text, const std::string& expression) {
    const SceneProgram scene = scene_of(text + "\nsphere { (" + expression + ")*x, 1 }");
    return scene.spheres.empty() ? NAN : scene.spheres.back().center.x;
}

} // namespace

TEST_CASE("macros: an argument that is a name is that name, any other is a value") {
    const std::string increase = "#macro Increase(P) #declare P = P + 1; #end #declare A = 1;";
    CHECK(value_after(increase + "Increase(A)", "A") == 2);
    CHECK(value_after(increase + "Increase((A))", "A") == 1);
    CHECK(value_after(increase + "Increase(A + 0)", "A") == 1);
    CHECK(value_after("#macro Increase(P) #local P = P + 1; #end #declare A = 1; Increase(A)", "A") == 2);
    const std::string swap =
        "#macro Swap(A, B) #local T = A; #declare A = B; #declare B = T; #end #declare P = 1; #declare Q = 2;";
    CHECK(value_after(swap + "Swap(P, Q)", "10*P + Q") == 21);
    CHECK(value_after("#macro Outer(A) Inner(A) #end #macro Inner(B) #declare B = 7; #end #declare Z = 1; Outer(Z)",
                      "Z") == 7);
    CHECK(value_after("#macro Same(A) #declare A = A + 1; #end #declare A = 1; Same(A)", "A") == 2);
}

TEST_CASE("macros: a call stands for the macro's tokens") {
    const std::string two = "#macro Two(X) X*2 #end";
    CHECK(value_after(two, "Two(3) + 1") == 7);
    CHECK(value_after(two, "-Two(3 + 1) + 1") == -7);
    CHECK(value_after("#macro Cube(X) <X, X, X> #end", "Cube(2).y") == 2);
    CHECK(value_after("#macro Pair() 1, 2 #end #declare V = <Pair(), 3>;", "V.z") == 3);
    CHECK(value_after("#macro Seven() 7 #end", "Seven()") == 7);
    CHECK(value_after("#macro Square(A) #local R = A*A; R #end", "Square(Square(2)) + Square(3)") == 25);
    CHECK(value_after("#macro Square(A) #local R = A*A; R #end #declare Z = Square(3);", "Z") == 9);
    CHECK(value_after("#macro Factorial(N) #if (N > 1) N*Factorial(N - 1) #else 1 #end #end", "Factorial(5)") == 120);
    CHECK(scene_of("#macro Open() sphere { #end Open() <1, 2, 3>, 1 }").spheres.size() == 1);
    CHECK(scene_of("#macro Paint() pigment { rgb 1 } #end sphere { 0, 1 Paint() } #declare T = texture { Paint() };")
              .spheres.size() == 1);
    CHECK(scene_of("#macro Ball(X) sphere { X*x, 1 } #end union { #for (I, 1, 3) Ball(I) #end }").spheres.size() == 3);
    CHECK(scene_of("#macro Put(O) object { O } #end Put(sphere { <1, 2, 3>, 1 }) #declare B = Put(sphere { 0, 1 }) B")
              .spheres.size() == 2);
}

TEST_CASE("macros: names in them are local, those of their callers are visible") {
    CHECK(error_of("#macro M() #local L = 1; #end M() sphere { L, 1 }") == "'L' is not declared");
    CHECK(error_of("#macro M() #for (I, 1, 2) #end #end M() sphere { I, 1 }") == "'I' is not declared");
    CHECK(value_after("#macro M() #declare G = 3; #end M()", "G") == 3);
    CHECK(value_after("#macro M() Caller #end #macro N() #local Caller = 5; M() #end", "N()") == 5);
    CHECK(value_after("#macro M() #local S = 1; #declare S = S + 1; S #end", "M()") == 2);
}

TEST_CASE("macros: time is noticed through a parameter") {
    CHECK(scene_of("#macro M(A) sphere { A, 1 } #end M(frame_number)").depends_on_time);
    CHECK(scene_of("#macro M(A) sphere { A, 1 } #end M(clock)").depends_on_time);
}

TEST_CASE("macros: a directive ends the value of a #declare there too") {
    CHECK(error_of("#macro F(X) #if (X) 1 #else 2 #end #end #declare A = F(1);") == "this #declare lacks its ';'");
    CHECK(error_of("#macro F(X) #if (X) (1) #else (2) #end #end sphere { F(1), 1 }") == "");
}

TEST_CASE("macros: mistakes") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"#macro M(A) #end M()", "'M' takes 1 arguments, here are 0"},
        {"#macro M(A) #end M(1, 2)", "unexpected '2'"},
        {"#macro M() #end M", "unexpected 'M', which is a macro"},
        {"#macro M() #end N()", "'N' is not declared"},
        {"#macro M #end", "unexpected '#end'"},
        {"#macro M(x) #end", "'x' is a reserved word"},
        {"#macro sphere() #end", "'sphere' is a reserved word"},
        {"#macro M(A) #end M(1 = 1)", "unexpected '='"},
        {"#macro M(A) #end M(Unknown)", "'Unknown' is not declared"},
        {"#macro M() M() #end M()", "macros call each other more than 10000 deep"},
        {"#macro M(A) union { M(A + 1) } #end M(0)", "this is nested more than 200 deep"},
        {"#declare M = 1; #macro M() #end", "'M' is a number already"},
        {"#macro M() #end #declare M = 1;", "'M' is a macro already"},
        {"#macro M()", "this directive has no #end"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(error_of(test.text) == test.message);
    }
}
