// SPDX-License-Identifier: Apache-2.0
// colors.inc: its colours, and its conversions between RGB and hue, saturation and lightness or value.
#include "parser/standard/texts.h"

namespace proxima::standard {
namespace {

// clang-format off
/// Red, green, blue; a fourth number is the filter.
constexpr NamedColor colors_inc[] = {
    {"Aquamarine", "0.439216, 0.858824, 0.576471"}, {"BakersChoc", "0.36, 0.2, 0.09"}, {"Black", "0, 0, 0"},
    {"Blue", "0, 0, 1"}, {"BlueViolet", "0.62352, 0.372549, 0.623529"}, {"Brass", "0.71, 0.65, 0.26"},
    {"BrightGold", "0.85, 0.85, 0.1"}, {"Bronze", "0.55, 0.47, 0.14"}, {"Bronze2", "0.65, 0.49, 0.24"},
    {"Brown", "0.647059, 0.164706, 0.164706"}, {"CadetBlue", "0.372549, 0.623529, 0.623529"},
    {"Clear", "1, 1, 1, 1"}, {"CoolCopper", "0.85, 0.53, 0.1"}, {"Copper", "0.72, 0.45, 0.2"},
    {"Coral", "1, 0.498039, 0"}, {"CornflowerBlue", "0.258824, 0.258824, 0.435294"}, {"Cyan", "0, 1, 1"},
    {"DarkBrown", "0.36, 0.25, 0.2"}, {"DarkGreen", "0.184314, 0.309804, 0.184314"},
    {"DarkOliveGreen", "0.309804, 0.309804, 0.184314"}, {"DarkOrchid", "0.6, 0.196078, 0.8"},
    {"DarkPurple", "0.53, 0.12, 0.47"}, {"DarkSlateBlue", "0.119608, 0.137255, 0.556863"},
    {"DarkSlateGray", "0.184314, 0.309804, 0.309804"}, {"DarkSlateGrey", "0.184314, 0.309804, 0.309804"},
    {"DarkTan", "0.59, 0.41, 0.31"}, {"DarkTurquoise", "0.439216, 0.576471, 0.858824"},
    {"DarkWood", "0.52, 0.37, 0.26"}, {"DimGray", "0.329412, 0.329412, 0.329412"},
    {"DimGrey", "0.329412, 0.329412, 0.329412"}, {"DkGreenCopper", "0.29, 0.46, 0.43"},
    {"DustyRose", "0.52, 0.39, 0.39"}, {"Feldspar", "0.82, 0.57, 0.46"},
    {"Firebrick", "0.556863, 0.137255, 0.137255"}, {"Flesh", "0.96, 0.8, 0.69"},
    {"ForestGreen", "0.137255, 0.556863, 0.137255"}, {"Gold", "0.8, 0.498039, 0.196078"},
    {"Goldenrod", "0.858824, 0.858824, 0.439216"}, {"Gray", "0.752941, 0.752941, 0.752941"}, {"Green", "0, 1, 0"},
    {"GreenCopper", "0.32, 0.49, 0.46"}, {"GreenYellow", "0.576471, 0.858824, 0.439216"},
    {"Grey", "0.752941, 0.752941, 0.752941"}, {"HuntersGreen", "0.13, 0.37, 0.31"},
    {"IndianRed", "0.309804, 0.184314, 0.184314"}, {"Khaki", "0.623529, 0.623529, 0.372549"},
    {"Light_Purple", "0.87, 0.58, 0.98"}, {"LightBlue", "0.74902, 0.847059, 0.847059"},
    {"LightGray", "0.658824, 0.658824, 0.658824"}, {"LightGrey", "0.658824, 0.658824, 0.658824"},
    {"LightSteelBlue", "0.560784, 0.560784, 0.737255"}, {"LightWood", "0.91, 0.76, 0.65"},
    {"LimeGreen", "0.196078, 0.8, 0.196078"}, {"Magenta", "1, 0, 1"}, {"MandarinOrange", "0.89, 0.47, 0.2"},
    {"Maroon", "0.556863, 0.137255, 0.419608"}, {"Med_Purple", "0.73, 0.16, 0.96"},
    {"MediumAquamarine", "0.196078, 0.8, 0.6"}, {"MediumBlue", "0.196078, 0.196078, 0.8"},
    {"MediumForestGreen", "0.419608, 0.556863, 0.137255"}, {"MediumGoldenrod", "0.917647, 0.917647, 0.678431"},
    {"MediumOrchid", "0.576471, 0.439216, 0.858824"}, {"MediumSeaGreen", "0.258824, 0.435294, 0.258824"},
    {"MediumSlateBlue", "0.498039, 0, 1"}, {"MediumSpringGreen", "0.498039, 1, 0"},
    {"MediumTurquoise", "0.439216, 0.858824, 0.858824"}, {"MediumVioletRed", "0.858824, 0.439216, 0.576471"},
    {"MediumWood", "0.65, 0.5, 0.39"}, {"Mica", "0, 0, 0"}, {"MidnightBlue", "0.184314, 0.184314, 0.309804"},
    {"Navy", "0.137255, 0.137255, 0.556863"}, {"NavyBlue", "0.137255, 0.137255, 0.556863"},
    {"NeonBlue", "0.3, 0.3, 1"}, {"NeonPink", "1, 0.43, 0.78"}, {"NewMidnightBlue", "0, 0, 0.61"},
    {"NewTan", "0.92, 0.78, 0.62"}, {"OldGold", "0.81, 0.71, 0.23"}, {"Orange", "1, 0.5, 0"},
    {"OrangeRed", "1, 0.25, 0"}, {"Orchid", "0.858824, 0.439216, 0.858824"},
    {"PaleGreen", "0.560784, 0.737255, 0.560784"}, {"Pink", "0.737255, 0.560784, 0.560784"},
    {"Plum", "0.917647, 0.678431, 0.917647"}, {"Quartz", "0.85, 0.85, 0.95"}, {"Red", "1, 0, 0"},
    {"RichBlue", "0.35, 0.35, 0.67"}, {"Salmon", "0.435294, 0.258824, 0.258824"}, {"Scarlet", "0.55, 0.09, 0.09"},
    {"SeaGreen", "0.137255, 0.556863, 0.419608"}, {"SemiSweetChoc", "0.42, 0.26, 0.15"},
    {"Sienna", "0.556863, 0.419608, 0.137255"}, {"Silver", "0.9, 0.91, 0.98"}, {"SkyBlue", "0.196078, 0.6, 0.8"},
    {"SlateBlue", "0, 0.498039, 1"}, {"SpicyPink", "1, 0.11, 0.68"}, {"SpringGreen", "0, 1, 0.498039"},
    {"SteelBlue", "0.137255, 0.419608, 0.556863"}, {"SummerSky", "0.22, 0.69, 0.87"},
    {"Tan", "0.858824, 0.576471, 0.439216"}, {"Thistle", "0.847059, 0.74902, 0.847059"},
    {"Turquoise", "0.678431, 0.917647, 0.917647"}, {"Very_Light_Purple", "0.94, 0.81, 0.99"},
    {"VeryDarkBrown", "0.35, 0.16, 0.14"}, {"Violet", "0.309804, 0.184314, 0.309804"},
    {"VioletRed", "0.8, 0.196078, 0.6"}, {"VLightGray", "0.8, 0.8, 0.8"}, {"VLightGrey", "0.8, 0.8, 0.8"},
    {"Wheat", "0.847059, 0.847059, 0.74902"}, {"White", "1, 1, 1"}, {"Yellow", "1, 1, 0"},
    {"YellowGreen", "0.6, 0.8, 0.196078"},
};
// clang-format on

} // namespace

std::string declare_colors(std::string_view prefix, std::span<const NamedColor> colors) {
    std::string text;
    for (const auto& [name, terms] : colors)
        text += fmt::format("#declare {}{} = {} <{}>;\n", prefix, name,
                            std::ranges::count(terms, ',') == 3 ? "rgbf" : "rgb", terms);
    return text;
}

std::string colors() {
    std::string text = declare_colors("", colors_inc);
    for (int percent = 5; percent < 100; percent += 5)
        text += fmt::format("#declare Gray{0:02} = rgb 0.{0:02};\n", percent);
    return text + R"(
#macro CH2RGB(Hue)
  #local H = mod(Hue, 360);
  #local H = (H < 0 ? H + 360 : H);
  #if (H <= 120)
    #local To = <(120 - H)/60, H/60, 0>;
  #else
    #local To = (H <= 240 ? <0, (240 - H)/60, (H - 120)/60> : <(H - 240)/60, 0, (360 - H)/60>);
  #end
  <min(To.x, 1), min(To.y, 1), min(To.z, 1)>
#end
#macro CRGB2H(Rgb, Largest, Range)
  #local R = Rgb.red;
  #local G = Rgb.green;
  #local B = Rgb.blue;
  #local H = 0;
  #if (Range > 0)
    #if (R = Largest & G != Largest) #local H = H + (G - B)/Range; #end
    #if (G = Largest & B != Largest) #local H = H + 2 + (B - R)/Range; #end
    #if (B = Largest & R != Largest) #local H = H + 4 + (R - G)/Range; #end
  #end
  (H*60)
#end
#macro CHSL2RGB(Hsl)
  #local From = color Hsl;
  #local S = From.green;
  #local L = From.blue;
  #local Pure = 2*S*CH2RGB(From.red) + (1 - S)*<1, 1, 1>;
  #local To = (L < 0.5 ? L*Pure : (1 - L)*Pure + (2*L - 1)*<1, 1, 1>);
  <To.red, To.green, To.blue, From.filter, From.transmit>
#end
#macro CRGB2HSL(Rgb)
  #local From = color Rgb;
  #local Least = min(From.red, From.green, From.blue);
  #local Most = max(From.red, From.green, From.blue);
  #local L = (Least + Most)/2;
  #local S = 0;
  #if (L != 0 & L != 1)
    #local S = (Most - Least)/(L < 0.5 ? L*2 : 2 - L*2);
  #end
  <CRGB2H(<From.red, From.green, From.blue>, Most, Most - Least), S, L, From.filter, From.transmit>
#end
#macro CHSV2RGB(Hsv)
  #local From = color Hsv;
  #local S = From.green;
  #local To = ((1 - S)*<1, 1, 1> + S*CH2RGB(From.red))*From.blue;
  <To.red, To.green, To.blue, From.filter, From.transmit>
#end
#macro CRGB2HSV(Rgb)
  #local From = color Rgb;
  #local Least = min(From.red, From.green, From.blue);
  #local Most = max(From.red, From.green, From.blue);
  #local S = 0;
  #if (Most != 0)
    #local S = (Most - Least)/Most;
  #end
  <CRGB2H(<From.red, From.green, From.blue>, Most, Most - Least), S, Most, From.filter, From.transmit>
#end
)";
}

} // namespace proxima::standard
