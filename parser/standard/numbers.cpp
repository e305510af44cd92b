// SPDX-License-Identifier: Apache-2.0
// consts.inc, math.inc and transforms.inc: constants, and what macros and functions make of numbers, vectors and
// transforms.
#include "parser/standard/texts.h"

namespace proxima::standard {

std::string consts() {
    std::string text = R"(
#declare e = exp(1);
#declare o = <0, 0, 0>;
#declare xy = <1, 1, 0>;
#declare yz = <0, 1, 1>;
#declare xz = <1, 0, 1>;
)";
    constexpr std::pair<const char*, const char*> numbers[] = {
        {"Plane_Map", "0"},
        {"Sphere_Map", "1"},
        {"Cylinder_Map", "2"},
        {"Torus_Map", "5"},
        {"Bi", "2"},
        {"Norm", "4"},
        {"Uniform_Fog", "1"},
        {"Ground_Fog", "2"},
        {"Hex_Blur1", "7"},
        {"Hex_Blur2", "19"},
        {"Hex_Blur3", "37"},
        {"Quartz_Glass_Dispersion", "1.012"},
        {"Water_Dispersion", "1.007"},
        {"Diamond_Dispersion", "1.035"},
        {"Sapphire_Dispersion", "1.015"},
        {"Flint_Glass_Ior", "1.71"},
        {"Crown_Glass_Ior", "1.51"},
        {"Diamond_Ior", "2.47"},
        {"Water_Ior", "1.33"},
        {"Air_Ior", "1.000292"},
        {"Ice_Ior", "1.31"},
        {"Fluorite_Ior", "1.434"},
        {"Plexiglas_Ior", "1.5"},
        {"Gypsum_Ior", "1.525"},
        {"Salt_Ior", "1.544"},
        {"Quartz_Ior", "1.55"},
        {"Citrine_Ior", "1.55"},
        {"Amethyst_Ior", "1.55"},
        {"Beryl_Ior", "1.575"},
        {"Aquamarine_Ior", "1.575"},
        {"Emerald_Ior", "1.575"},
        {"Topaz_Ior", "1.62"},
        {"Apatite_Ior", "1.635"},
        {"Tourmaline_Ior", "1.65"},
        {"Corundum_Ior", "1.765"},
        {"Ruby_Ior", "1.765"},
        {"Sapphire_Ior", "1.765"},
        {"Quartz_Glass_Ior", "1.458"},
        {"Flint_Glass_Heavy_Ior", "1.8"},
        {"Flint_Glass_Medium_Ior", "1.63"},
        {"Flint_Glass_Light_Ior", "1.6"},
        {"FoV_15", "7.595981"},
        {"FoV_30", "3.732166"},
        {"FoV_45", "2.414293"},
        {"FoV_60", "1.732113"},
        {"FoV_75", "1.303277"},
        {"FoV_90", "1.000046"},
        {"FoV_105", "0.76737"},
        {"FoV_120", "0.577391"},
        {"FoV_135", "0.414254"},
        {"FoV_150", "0.267991"},
        {"FoV_165", "0.131696"},
        {"ISOTROPIC_SCATTERING", "1"},
        {"MIE_HAZY_SCATTERING", "2"},
        {"MIE_MURKY_SCATTERING", "3"},
        {"RAYLEIGH_SCATTERING", "4"},
        {"HENYEY_GREENSTEIN_SCATTERING", "5"},
    };
    for (const auto& [name, value] : numbers)
        text += fmt::format("#declare {} = {};\n", name, value);
    return text;
}

std::string math() {
    const std::string text = R"(
#include "functions.inc"

#declare sind = function(x) { sin(radians(x)) }
#declare cosd = function(x) { cos(radians(x)) }
#declare tand = function(x) { tan(radians(x)) }
#declare asind = function(x) { degrees(asin(x)) }
#declare acosd = function(x) { degrees(acos(x)) }
#declare atand = function(x) { degrees(atan(x)) }
#declare atan2d = function(x, y) { degrees(atan2(x, y)) }
#declare max3 = function(x, y, z) { max(x, y, z) }
#declare min3 = function(x, y, z) { min(x, y, z) }
#declare even = function(x) { select(mod(x, 2), 0, 1, 0) }
#declare odd = function(x) { select(mod(x, 2), 1, 0, 1) }
#declare f_sqr = function(x) { x*x }
#declare sgn = function(x) { select(x, -1, 0, 1) }
#declare clip = function(x, y, z) { min(z, max(x, y)) }
#declare clamp = function(x, y, z) { mod(x - y, z - y) + select(mod(x - y, z - y), z, y) }
#declare adj_range = function(x, y, z) { x*(z - y) + y }
#declare adj_range2 = function(x, y, z, math_new_low, math_new_high) {
  (x - y)/(z - y)*(math_new_high - math_new_low) + math_new_low
}
#macro Interpolate(At, Start, End, A, B, Power)
  (#if (Power != 0)
    A + (B - A)*pow((At - Start)/(End - Start), Power)
  #else
    #local Share = (1 - cos((At - Start)/(End - Start)*pi))*0.5;
    A*(1 - Share) + B*Share
  #end)
#end

#macro VSqr(A) (A*A) #end
#macro VPow(A, Power) <pow(A.x, Power), pow(A.y, Power), pow(A.z, Power)> #end
#macro VPow5D(A, Power)
  <pow(A.x, Power), pow(A.y, Power), pow(A.z, Power), pow(A.filter, Power), pow(A.transmit, Power)>
#end
#macro VEq(A, B) (A.x = B.x & A.y = B.y & A.z = B.z) #end
#macro VEq5D(A, B) (VEq(A, B) & A.filter = B.filter & A.transmit = B.transmit) #end
#macro VZero(A) (A.x = 0 & A.y = 0 & A.z = 0) #end
#macro VZero5D(A) (VZero(A) & A.filter = 0 & A.transmit = 0) #end
#macro VDot5D(A, B) (A.x*B.x + A.y*B.y + A.z*B.z + A.filter*B.filter + A.transmit*B.transmit) #end
#macro VLength5D(A) sqrt(VDot5D(A, A)) #end
#macro VNormalize5D(A) (A/sqrt(VDot5D(A, A))) #end
#macro VCos_Angle(A, B) vdot(vnormalize(A), vnormalize(B)) #end
#macro VAngle(A, B) acos(min(1, VCos_Angle(A, B))) #end
#macro VAngleD(A, B) degrees(VAngle(A, B)) #end
#macro VRotation(A, B, Axis) (VAngle(A, B)*(vdot(Axis, vcross(A, B)) < 0 ? -1 : 1)) #end
#macro VRotationD(A, B, Axis) (VAngleD(A, B)*(vdot(Axis, vcross(A, B)) < 0 ? -1 : 1)) #end
#macro VDist(A, B) vlength(A - B) #end
#macro VPerp_To_Vector(A)
  #local Perp = <0, 0, 0>;
  #if (vlength(A) != 0)
    #local Least = min(abs(A.x), abs(A.y), abs(A.z));
    #local Perp = vnormalize(vcross(A, (abs(A.z) = Least ? z : (abs(A.y) = Least ? y : x))));
  #end
  Perp
#end
#macro VPerp_To_Plane(A, B) (vnormalize(vcross(A, B))) #end
#macro VPerp_Adjust(A, Axis) vnormalize(vcross(vcross(Axis, A), Axis)) #end
#macro VProject_Plane(A, Axis)
  #local Unit = vnormalize(Axis);
  (A - vdot(A, Unit)*Unit)
#end
#macro VProject_Axis(A, Axis) (Axis*vdot(A, Axis)/vdot(Axis, Axis)) #end
#macro VMin(A) min(A.x, A.y, A.z) #end
#macro VMax(A) max(A.x, A.y, A.z) #end
#macro VWith_Len(A, Length) (Length*vnormalize(A)) #end
)";
    return text + gradients() + array_statistics();
}

std::string transforms() {
    return R"(
#include "math.inc"

#macro Matrix_Trans(A, B, C, D)
  transform { matrix <A.x, A.y, A.z, B.x, B.y, B.z, C.x, C.y, C.z, D.x, D.y, D.z> }
#end
#macro Shear_Trans(A, B, C)
  transform { matrix <A.x, A.y, A.z, B.x, B.y, B.z, C.x, C.y, C.z, 0, 0, 0> }
#end
#macro Point_At_Trans(Axis)
  #local Up = vnormalize(Axis);
  #local Side = VPerp_To_Vector(Up);
  #local Front = vcross(Side, Up);
  Shear_Trans(Side, Up, Front)
#end
#macro Axial_Scale_Trans(Axis, Factor)
  transform {
    transform { Point_At_Trans(Axis) inverse }
    scale <1, Factor, 1>
    Point_At_Trans(Axis)
  }
#end
#macro Axis_Rotate_Trans(Axis, Angle)
  #local To_X = vaxis_rotate(x, Axis, Angle);
  #local To_Y = vaxis_rotate(y, Axis, Angle);
  #local To_Z = vaxis_rotate(z, Axis, Angle);
  Shear_Trans(To_X, To_Y, To_Z)
#end
#macro Spline_Trans(Curve, Time, Up, Foresight, Banking)
  #local Here = <0, 0, 0> + Curve(Time);
  #local Ahead = <0, 0, 0> + Curve(Time + Foresight);
  #local Behind = <0, 0, 0> + Curve(Time - Foresight);
  #local Front = vnormalize(Ahead - Here);
  #local Side = VPerp_To_Plane(Up, Front);
  #local Top = VPerp_To_Plane(Front, Side);
  #local Turn = VRotation(VProject_Plane(Ahead - Here, Up), VProject_Plane(Here - Behind, Up), Top);
  transform {
    rotate degrees(atan2(Turn*Banking, 1))*z
    Matrix_Trans(Side, Top, Front, Here)
  }
#end
#macro Rotate_Around_Trans(Angles, Center)
  transform { translate -Center rotate Angles translate Center }
#end
#macro Reorient_Trans(From, To)
  #local A = vnormalize(From);
  #local B = vnormalize(To);
  #local Hinge = vcross(A, B);
  #if (vlength(Hinge) > 0)
    #local Hinge = vnormalize(Hinge);
    #local Side_A = vnormalize(vcross(A, Hinge));
    #local Side_B = vnormalize(vcross(B, Hinge));
    transform {
      matrix <A.x, Hinge.x, Side_A.x, A.y, Hinge.y, Side_A.y, A.z, Hinge.z, Side_A.z, 0, 0, 0>
      matrix <B.x, B.y, B.z, Hinge.x, Hinge.y, Hinge.z, Side_B.x, Side_B.y, Side_B.z, 0, 0, 0>
    }
  #else
    #if (vlength(A - B) = 0)
      transform {}
    #else
      #local Hinge = VPerp_To_Vector(B);
      transform { Axis_Rotate_Trans(Hinge, 180) }
    #end
  #end
#end
)";
}

} // namespace proxima::standard
