// SPDX-License-Identifier: Apache-2.0
// Arrays. Values and refusals of POV-Ray 3.7.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

double value_after(const std::string& text, const std::string& expression) {
    const SceneProgram scene = scene_of(text + "\nsphere { (" + expression + ")*x, 1 }");
    return scene.spheres.empty() ? NAN : scene.spheres.back().center.x;
}

const std::string three = "#declare A = array[3] { 1, 2, 3 }";
const std::string matrix = "#declare M = array[2][3] { { 1, 2, 3 }, { 4, 5, 6 } }";

} // namespace

TEST_CASE("arrays: elements are declared one by one or in braces") {
    CHECK(value_after(three, "A[0] + 10*A[1] + 100*A[2]") == 321);
    CHECK(value_after("#declare A = array[2]; #declare A[1] = 7; #declare A[0] = A[1] + 1;", "A[0]*A[1]") == 56);
    CHECK(value_after("#declare A = array[3] { 1 2 3, }", "A[2]") == 3);
    CHECK(value_after(matrix, "M[1][0]*10 + M[0][2]") == 43);
    CHECK(value_after("#declare A = array [ 1.9 ] { 5 }", "A [ 0.9 ]") == 5);
    CHECK(value_after(three, "A[A[A[0]] - 1]") == 2);
    CHECK(value_after("#declare A = array[2] { <1, 2, 3>, <4, 5, 6> }", "A[0].y*A[1].z") == 12);
    CHECK(value_after("#declare A = array[2]; #for (I, 0, 1) #declare A[I] = array[I + 1]; #end #declare A[1][1] = 4;",
                      "A[1][1] + dimension_size(A[1], 1)") == 6);
    CHECK(value_after("#macro Two() array[2] { 5, 6 } #end #declare A = Two()", "A[1]") == 6);
}

TEST_CASE("arrays: they hold values of every kind, one kind each") {
    CHECK(pigment_of(scene_of("#declare T = array[2] { texture { pigment { rgb 0 } }, texture { pigment { rgb 1 } } }\n"
                              "sphere { 0, 1 texture { T[1] } }"))
              .color.rgb == glm::vec3(1));
    CHECK(scene_of("#declare O = array[2] { sphere { 0, 1 }, plane { y, 1 } } O[0] object { O[1] translate y }")
              .planes.size() == 1);
    CHECK(scene_of("#declare C = array[1] { rgbt <1, 2, 3, 4> } sphere { 0, 1 pigment { C[0] } }").spheres.size() == 1);
    CHECK(evaluate("#declare S = array[2] { \"a\", \"b\" } #error concat(S[0], S[1])").messages.find("ab") !=
          std::string::npos);
    CHECK(scene_of("#declare T = array[1] { transform { translate 2*x } } sphere { 0, 1 transform { T[0] } }")
              .spheres[0]
              .center.x == 2);
    CHECK(error_of("#declare A = array[2] { 1, \"a\" }") == "this element is a string");
    CHECK(error_of("#declare A = array[2]; #declare A[0] = <1, 2>; #declare A[1] = <1, 2, 3>;") ==
          "this element is a vector of 3 terms");
    CHECK(error_of(three + "#declare A[0] = A;") == "this element is an array");
}

TEST_CASE("arrays: a copy is one of its own, a parameter is the caller's") {
    CHECK(value_after(three + "#declare B = A; #declare B[0] = 9;", "A[0] + 10*B[0]") == 91);
    CHECK(value_after("#declare A = array[1] { array[1] { 1 } } #declare B = A; #declare B[0][0] = 2;",
                      "A[0][0] + 10*B[0][0]") == 21);
    CHECK(value_after(three + "#macro Set(P) #declare P[1] = 8; #end Set(A)", "A[1]") == 8);
    CHECK(value_after(three + "#macro Set(P) #local P[1] = 8; #end Set(A)", "A[1]") == 8);
    CHECK(value_after(three + "#macro Set(P) #declare P = P + 5; #end Set(A[2])", "A[2]") == 8);
    CHECK(value_after(three + "#macro Set(P) #declare P = 5; #end #macro Outer(Q) Set(Q[2]) #end Outer(A)", "A[2]") ==
          5);
    CHECK(value_after(three + "#macro Set(P) #declare P = 5; #end Set(A[2] + 0)", "A[2]") == 3);
    CHECK(value_after("#macro Sum(P) P[0] + P[1] #end", "Sum(array[2] { 3, 4 })") == 7);
    CHECK(error_of(three + "#macro M() #local A[0] = 7; #end M()") ==
          "#local cannot change 'A', which is declared elsewhere");
    CHECK(error_of(
              "#declare A = array[2] { 1, 2 } #macro M(P) #declare A = array[1] { 3 } sphere { P, 1 } #end M(A[1])") ==
          "the element that this parameter stood for is gone");
}

TEST_CASE("arrays: their sizes and which elements have a value") {
    CHECK(value_after(matrix, "dimensions(M)*100 + dimension_size(M, 1)*10 + dimension_size(M, 2)") == 223);
    CHECK(value_after(matrix, "dimension_size(M, 0) + dimension_size(M, 3)") == 0);
    CHECK(value_after("#declare A = array[2]; #declare A[0] = 1;",
                      "defined(A) + 10*defined(A[0]) + 100*defined(A[1])") == 11);
    CHECK(value_after(three + "#undef A[1] #ifdef (A[1]) #declare R = 1; #else #declare R = 2; #end", "R") == 2);
    CHECK(error_of("#declare A = array[2]; sphere { A[0], 1 }") == "this element of the array has no value yet");
    CHECK(error_of("#declare A = array[2]; #undef A[0]") == "this element of the array has no value yet");
    CHECK(error_of("#declare A = 3; sphere { dimensions(A), 1 }") == "unexpected 'A', which is a number");
}

TEST_CASE("arrays: subscripts and sizes that are wrong") {
    CHECK(error_of(three + "sphere { A[3], 1 }") == "the subscript 3 is out of range");
    CHECK(error_of(three + "sphere { A[-0.5], 1 }") == "the subscript -0.5 is negative");
    CHECK(error_of(three + "#declare A[3] = 1;") == "the subscript 3 is out of range");
    CHECK(error_of(three + "#ifdef (A[3]) #end") == "the subscript 3 is out of range");
    CHECK(error_of(matrix + "sphere { M[0], 1 }") == "unexpected ','");
    CHECK(error_of(three + "sphere { A[0][0], 1 }") == "unexpected '['");
    CHECK(error_of(three + "sphere { A, 1 }") == "unexpected 'A', which is an array");
    CHECK(error_of("#declare A = 5; #declare A[0] = 1;") == "'A' is no array");
    CHECK(error_of("#declare A = array[0];") == "an array has at least 1 element, not 0");
    CHECK(error_of("#declare A = array[1][1][1][1][1][1];") == "an array has at most 5 dimensions");
    CHECK(error_of("#declare A = array[1e12];") == "an array has at most 100000000 elements");
    CHECK(error_of("#declare A = array { 1 }") == "unexpected '{'");
}

TEST_CASE("arrays: initializers that are wrong") {
    CHECK(error_of("#declare A = array[3] { 1, 2 }") == "this initializer has 2 values and needs 3");
    CHECK(error_of("#declare A = array[1] { 1, 2 }") == "unexpected '2'");
    CHECK(error_of("#declare A = array[1][1] { 1 }") == "unexpected '1'");
    const std::string begins = "a value in an initializer must not begin with a directive or a macro";
    CHECK(error_of("#declare A = array[2] { 1, #if (1) 2 #end }") == begins);
    CHECK(error_of("#macro M() 1 #end #declare A = array[1] { M() }") == begins);
}

TEST_CASE("arrays: neither their depth nor a change while they are read does harm") {
    CHECK(error_of("#declare A = array[1]; #for (I, 1, 1000) #declare B = array[1]; #declare B[0] = A; "
                   "#declare A = B; #end") == "arrays stand in each other more than 100 deep");
    CHECK(value_after("#declare A = array[2] { 1, 2 } #macro Shrink() #declare A = array[1] { 7 } 1 #end",
                      "A[Shrink()]") == 2);
    CHECK(scene_of("#declare A = array[2] { sphere { 0, 1 }, sphere { 0, 2 } } #macro Shrink() #declare A = 7; 1 #end "
                   "A[Shrink()]")
              .spheres[0]
              .radius == 2);
    CHECK(error_of("#declare A = array[2] { 1, 2 } #macro Shrink() #declare A = array[1] { 7 } 1 #end "
                   "#declare A[1] = Shrink();") == "the array changed while the value of its element was found");
}
