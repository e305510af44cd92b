// SPDX-License-Identifier: Apache-2.0
// glass_old.inc and glass.inc: colours, finishes, interiors and textures of glass.
#include "parser/standard/texts.h"

namespace proxima::standard {
namespace {

// clang-format off
constexpr NamedColor glass_colors[] = {
    {"Glass_Old", "0.8, 0.9, 0.85, 0.85"}, {"Glass_Winebottle", "0.4, 0.72, 0.4, 0.6"},
    {"Glass_Beerbottle", "0.7, 0.5, 0.1, 0.6"}, {"Glass_Ruby", "0.9, 0.1, 0.2, 0.8"},
    {"Glass_Green", "0.8, 1, 0.95, 0.9"}, {"Glass_Dark_Green", "0.1, 0.7, 0.8, 0.8"},
    {"Glass_Yellow", "0.8, 0.8, 0.2, 0.8"}, {"Glass_Orange", "1, 0.5, 0, 0.8"},
    {"Glass_Vicksbottle", "0.1, 0.15, 0.5, 0.9"}, {"Glass_Clear", "1, 1, 1, 1"},
    {"Glass_General", "0.97, 0.99, 0.98, 0.9"}, {"Glass_Bluish", "0.9, 0.94, 1, 0.8"},
    {"Winebottle", "0.4, 0.72, 0.4"}, {"Beerbottle", "0.7, 0.5, 0.1"}, {"Ruby", "0.9, 0.1, 0.2"},
    {"Green", "0.8, 1, 0.95"}, {"Dark_Green", "0.1, 0.7, 0.8"}, {"Yellow", "0.8, 0.8, 0.2"},
    {"Orange", "1, 0.5, 0"}, {"Vicksbottle", "0.1, 0.15, 0.5"}, {"Red_01", "0.85, 0.1, 0.2"},
    {"Red_02", "0.85, 0.35, 0.1"}, {"Red_03", "0.75, 0.2, 0.25"}, {"Red_04", "0.5, 0.1, 0.1"},
    {"Green_01", "0.1, 0.85, 0.2"}, {"Green_02", "0.35, 0.85, 0.1"}, {"Green_03", "0.2, 0.75, 0.25"},
    {"Green_04", "0.1, 0.5, 0.1"}, {"Blue_01", "0.35, 0.42, 0.85"}, {"Blue_02", "0.35, 0.65, 0.85"},
    {"Blue_03", "0.35, 0.4, 0.75"}, {"Blue_04", "0.1, 0.1, 0.5"}, {"Yellow_01", "0.85, 0.85, 0.2"},
    {"Yellow_02", "0.75, 0.78, 0.1"}, {"Yellow_03", "0.78, 0.75, 0.1"}, {"Yellow_04", "0.5, 0.5, 0.1"},
    {"Amethyst_01", "0.4392, 0.1765, 0.3137"}, {"Amethyst_02", "0.5843, 0.3686, 0.4941"},
    {"Amethyst_03", "0.698, 0.5059, 0.6157"}, {"Amethyst_04", "0.9059, 0.7176, 0.8471"},
    {"Amethyst_05", "0.8902, 0.4549, 0.7059"}, {"Amethyst_06", "0.498, 0.2902, 0.4235"},
    {"Apatite_01", "0.0549, 0.3451, 0.4314"}, {"Apatite_02", "0.2941, 0.5765, 0.5647"},
    {"Apatite_03", "0.5176, 0.7333, 0.702"}, {"Apatite_04", "0.3412, 0.5961, 0.4118"},
    {"Apatite_05", "0.3647, 0.8196, 0.7451"}, {"Aquamarine_01", "0.5333, 0.6157, 0.6196"},
    {"Aquamarine_02", "0.6627, 0.702, 0.7255"}, {"Aquamarine_03", "0.7412, 0.8235, 0.8431"},
    {"Aquamarine_04", "0.6039, 0.7216, 0.7882"}, {"Aquamarine_05", "0.5804, 0.7098, 0.7765"},
    {"Aquamarine_06", "0.7255, 0.851, 0.9176"}, {"Azurite_01", "0.2863, 0.3569, 0.7216"},
    {"Azurite_02", "0.5333, 0.6549, 0.9059"}, {"Azurite_03", "0.302, 0.3529, 0.6314"},
    {"Azurite_04", "0.1137, 0.1569, 0.4471"}, {"Citrine_01", "0.302, 0.2314, 0.1529"},
    {"Citrine_02", "0.4667, 0.3804, 0.298"}, {"Citrine_03", "0.502, 0.4118, 0.3529"},
    {"Emerald_01", "0.0471, 0.4, 0.2549"}, {"Emerald_02", "0.2157, 0.6353, 0.4902"},
    {"Emerald_03", "0.3216, 0.6627, 0.5961"}, {"Emerald_04", "0.1843, 0.4549, 0.3843"},
    {"Emerald_05", "0.2863, 0.6431, 0.4431"}, {"Emerald_06", "0.2353, 0.5922, 0.3804"},
    {"Emerald_07", "0.4392, 0.7725, 0.5804"}, {"Fluorite_01", "0.5098, 0.3294, 0.4039"},
    {"Fluorite_02", "0.302, 0.1569, 0.2431"}, {"Fluorite_03", "0.5098, 0.2902, 0.2745"},
    {"Fluorite_04", "0.5373, 0.3098, 0.0902"}, {"Fluorite_05", "0.702, 0.5529, 0.7294"},
    {"Fluorite_06", "0.4745, 0.2627, 0.4824"}, {"Fluorite_07", "0.2314, 0.0784, 0.2902"},
    {"Fluorite_08", "0.5804, 0.6235, 0.6745"}, {"Fluorite_09", "0.4392, 0.4745, 0.5333"},
    {"Gypsum_01", "0.902, 0.8824, 0.7882"}, {"Gypsum_02", "0.8039, 0.8667, 0.8157"},
    {"Gypsum_03", "0.7098, 0.6863, 0.6"}, {"Gypsum_04", "0.8275, 0.8078, 0.5765"},
    {"Gypsum_05", "0.8196, 0.7373, 0.5294"}, {"Gypsum_06", "0.5961, 0.4941, 0.302"},
    {"Ruby_01", "0.498, 0.0824, 0.2275"}, {"Ruby_02", "0.6235, 0.149, 0.3137"},
    {"Ruby_03", "0.7412, 0.3294, 0.4745"}, {"Ruby_04", "0.8039, 0.2039, 0.5569"},
    {"Ruby_05", "0.5882, 0.1255, 0.4784"}, {"Sapphire_01", "0.2118, 0.302, 0.498"},
    {"Sapphire_02", "0.0588, 0.2, 0.5569"}, {"Sapphire_03", "0.0392, 0.2353, 0.5686"},
    {"Topaz_01", "0.7333, 0.7451, 0.698"}, {"Topaz_02", "0.5922, 0.6196, 0.5922"},
    {"Topaz_03", "0.5922, 0.6157, 0.651"}, {"Tourmaline_01", "0.3725, 0.4235, 0.2941"},
    {"Tourmaline_02", "0.2745, 0.349, 0.2235"}, {"Tourmaline_03", "0.2627, 0.2549, 0.1451"},
    {"Tourmaline_04", "0.1333, 0.4706, 0.3412"}, {"Tourmaline_05", "0.0627, 0.298, 0.2118"},
    {"Tourmaline_06", "0.0196, 0.2706, 0.1961"}, {"Amber_01", "0.3725, 0.4235, 0.2941"},
    {"Amber_02", "0.8941, 0.6863, 0.2902"}, {"Amber_03", "0.7412, 0.4235, 0.2588"},
    {"Amber_04", "0.7059, 0.3961, 0.1216"}, {"Amber_05", "0.5647, 0.2392, 0.0745"},
    {"Amber_06", "0.8157, 0.6549, 0.2392"}, {"Amber_07", "0.9882, 0.6941, 0.0431"},
    {"Amber_08", "0.8549, 0.4706, 0.1294"}, {"Amber_09", "0.5294, 0.2431, 0.1529"},
};
// clang-format on

} // namespace

std::string glass_old() {
    std::string text = R"(
#declare I_Glass = interior { ior 1.5 }
#declare F_Glass1 = finish { ambient 0 diffuse 0 specular 1 roughness 0.001 reflection 0.1 }
#declare F_Glass2 = finish { ambient 0 diffuse 0 phong 0.3 phong_size 60 reflection 0.5 }
#declare F_Glass3 = finish {
  ambient 0.1 diffuse 0.1 phong 1 phong_size 400 specular 0.8 roughness 0.003 reflection 0.1
}
#declare F_Glass4 = finish { ambient 0.1 diffuse 0.1 specular 1 roughness 0.001 reflection 0.25 }
)";
    struct Glass {
        const char* name;
        const char* color;
        int finish;
    };
    constexpr Glass glasses[] = {
        {"Glass1", "1, 1, 1, 0.7", 1},
        {"Glass2", "1, 1, 1, 1", 2},
        {"Glass3", "0.98, 0.98, 0.98, 0.9", 3},
        {"Glass4", "0.98, 1, 0.99, 0.75", 4},
        {"Old_Glass", "0.8, 0.9, 0.85, 0.85", 4},
        {"Winebottle_Glass", "0.4, 0.72, 0.4, 0.6", 4},
        {"Beerbottle_Glass", "0.7, 0.5, 0.1, 0.6", 4},
        {"Ruby_Glass", "0.9, 0.1, 0.2, 0.8", 4},
        {"Green_Glass", "0.8, 1, 0.95, 0.9", 3},
        {"Dark_Green_Glass", "0.1, 0.7, 0.8, 0.8", 4},
        {"Yellow_Glass", "0.8, 0.8, 0.2, 0.8", 4},
        {"Orange_Glass", "1, 0.5, 0, 0.8", 4},
        {"Vicksbottle_Glass", "0.1, 0.15, 0.5, 0.9", 4},
    };
    for (const Glass& glass : glasses)
        text += fmt::format("#declare T_{} = texture {{ pigment {{ rgbf <{}> }} finish {{ F_Glass{} }} }}\n",
                            glass.name, glass.color, glass.finish);
    return text;
}

std::string glass() {
    return R"(
#include "glass_old.inc"
#include "consts.inc"

#declare F_Glass5 = finish {
  ambient 0 diffuse 0 specular 0.7 roughness 0.001 reflection { 0.2, 1 fresnel } conserve_energy
}
#declare F_Glass6 = finish {
  ambient 0 diffuse 0.1 brilliance 5 specular 0.6 roughness 0.002 reflection { 0.1, 1 fresnel } conserve_energy
}
#declare F_Glass7 = finish {
  ambient 0 diffuse 0 specular 0.9 roughness 0.001 reflection { 0, 1 fresnel } conserve_energy
}
#declare F_Glass8 = finish {
  ambient 0 diffuse 0.15 brilliance 4 specular 0.6 roughness 0.005 reflection { 0.2, 1 fresnel } conserve_energy
}
#declare F_Glass9 = finish {
  ambient 0 diffuse 0 specular 0.8 roughness 0.001 reflection { 0.05, 1 } conserve_energy
}
#declare F_Glass10 = finish {
  ambient 0 diffuse 0.1 specular 0.6 roughness 0.002 reflection { 0.05, 1 } conserve_energy
}

#macro I_Glass_Sqr(Reach) ior 1.5 fade_distance Reach fade_power 2 #end
#macro I_Glass_Exp(Reach) ior 1.5 fade_distance Reach fade_power 1001 #end
#declare I_Glass1 = interior { I_Glass_Sqr(1) }
#declare I_Glass2 = interior { I_Glass_Exp(0.5) }
#declare I_Glass3 = interior { I_Glass_Exp(1) }
#declare I_Glass4 = interior { I_Glass_Exp(2) }
#declare I_Glass_Fade_Sqr1 = interior { I_Glass1 }
#declare I_Glass_Fade_Exp1 = interior { I_Glass2 }
#declare I_Glass_Fade_Exp2 = interior { I_Glass3 }
#declare I_Glass_Fade_Exp3 = interior { I_Glass4 }
)" + declare_colors("Col_", glass_colors);
}

} // namespace proxima::standard
