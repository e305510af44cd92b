// SPDX-License-Identifier: Apache-2.0
// The small files: shapes that are spheres and planes, strings, messages, and the files that include others.
#include "parser/standard/texts.h"

namespace proxima::standard {
namespace {

/// The beginning of a file that needs a name of another, which it does not include.
std::string after(const char* file, const char* name) {
    return fmt::format("#ifndef ({0}) #error \"the name {0} is needed here: include {1} before this file\" #end\n",
                       name, file);
}

} // namespace

std::string shapes_old() {
    return R"(
#declare Sphere = sphere { 0, 1 }
#declare Ellipsoid = sphere { 0, 1 }
#declare Plane_YZ = plane { x, 0 }
#declare Plane_XZ = plane { y, 0 }
#declare Plane_XY = plane { z, 0 }
)";
}

std::string shapes() {
    return R"(
#include "shapes_old.inc"
#include "consts.inc"
#include "transforms.inc"
#include "strings.inc"
#include "math.inc"

#declare Align_Left = 1;
#declare Align_Right = 2;
#declare Align_Center = 3;
#macro Spheroid(Center, Radius) sphere { 0, 1 scale Radius translate Center } #end
)";
}

std::string strings() {
    return R"(
#macro Str(A) str(A, 0, -1) #end
#macro Vstr2D(A, Length, Digits) concat("<", vstr(2, A, ",", Length, Digits), ">") #end
#macro Vstr(A, Length, Digits) concat("<", vstr(3, A, ",", Length, Digits), ">") #end
#macro VStr2D(A) Vstr2D(A, 0, -1) #end
#macro VStr(A) Vstr(A, 0, -1) #end
#macro CRGBStr(A, Length, Digits)
  concat("color rgb <   ", vstr(3, A, ", ", Length, Digits), ">")
#end
#macro CRGBFTStr(A, Length, Digits)
  concat("color rgbft < ", vstr(5, A, ", ", Length, Digits), ">")
#end
#macro Triangle_Str(A, B, C) concat("triangle {", VStr(A), ",", VStr(B), ",", VStr(C), "}") #end
#macro Smooth_Triangle_Str(A, NA, B, NB, C, NC)
  concat("smooth_triangle {", VStr(A), ",", VStr(NA), ",", VStr(B), ",", VStr(NB), ",", VStr(C), ",", VStr(NC), "}")
#end
)";
}

std::string debug() {
    return R"(
#declare DEBUG_MCR = yes;
#declare DEBUG = yes;
#macro Debug_Inc_Stack() #declare View_POV_Include_Stack = 1; #end
#macro Set_Debug(Flag) #declare DEBUG = Flag; #end
#macro Debug_Message(Text) #if (DEBUG) #debug Text #end #end
#macro Debug(Condition, Text) #if (Condition) #debug Text #end #end
#macro Warning(Condition, Text) #if (Condition) #warning Text #end #end
#macro Error(Condition, Text) #if (Condition) #error Text #end #end
)";
}

std::string stdinc() {
    return R"(
#include "colors.inc"
#include "shapes.inc"
#include "transforms.inc"
#include "consts.inc"
#include "functions.inc"
#include "math.inc"
#include "rand.inc"
)";
}

std::string logo() {
    return "#include \"shapes.inc\"\n";
}

std::string shapes2() {
    return after("shapes.inc", "Cone_Y");
}

std::string shapesq() {
    return after("shapes.inc", "Cylinder_Z");
}

std::string shapes3() {
    return "#include \"shapes.inc\"\n";
}

std::string skies() {
    return after("colors.inc", "Clear");
}

std::string stoneold() {
    return "#include \"stones1.inc\"\n";
}

std::string stones() {
    return "#include \"stones1.inc\"\n#include \"stones2.inc\"\n";
}

std::string stones1() {
    constexpr NamedColor colors[] = {
        {"g1", "0.26, 0.41, 0.31"},
        {"g2", "0.27, 0.34, 0.26"},
        {"g3", "0.13, 0.29, 0.28"},
        {"g4", "0.03, 0.18, 0.08"},
    };
    return after("colors.inc", "White") + declare_colors("", colors);
}

std::string stones2() {
    return after("colors.inc", "Clear");
}

std::string woods() {
    return "#include \"woodmaps.inc\"\n";
}

std::string stdcam() {
    return R"(
camera { location <-2, 1.75, -5> look_at <-0.75, -0.5, 0> right x*1.3333 angle 70 }
light_source { <20, 20, -25>, rgb 1 }
plane { y, 0 pigment { Plum } }
)";
}

std::string stage1() {
    return R"(
#include "colors.inc"
#include "textures.inc"
#include "shapes.inc"

#declare Camera1 = camera { location <0, 0, -60> direction <0, 0, 10> look_at 0 }
camera { Camera1 }
light_source { <1000, 1000, -2000>, White }
plane { z, 1.01 pigment { checker White, rgb <1, 0.8, 0.8> } hollow }
)";
}

} // namespace proxima::standard
