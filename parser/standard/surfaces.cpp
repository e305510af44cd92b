// SPDX-License-Identifier: Apache-2.0
// finish.inc and textures.inc: the surfaces that are plain colours and finishes.
#include "parser/standard/texts.h"

namespace proxima::standard {

std::string finish() {
    return R"(
#declare Dull = finish { specular 0.5 roughness 0.15 }
#declare Shiny = finish { specular 1 roughness 0.001 }
#declare Glossy = finish { Shiny roughness 0.0001 reflection 0.13 }
#declare Phong_Dull = finish { phong 0.5 phong_size 1 }
#declare Phong_Shiny = finish { phong 1 phong_size 200 }
#declare Phong_Glossy = finish { phong 1 phong_size 300 reflection 0.13 }
#declare Luminous = finish { ambient 1 diffuse 0 }
#declare Mirror = finish { ambient 0 diffuse 0 reflection 1 }
)";
}

std::string textures() {
    std::string text = R"(
#include "finish.inc"

#declare Glass_Interior = interior { ior 1.5 }
#declare Glass_Finish = finish { ambient 0 diffuse 0 specular 1 roughness 0.001 reflection 0.1 }
#declare Glass = texture { pigment { rgbf <1, 1, 1, 0.7> } finish { Glass_Finish } }
#declare Glass2 = texture {
  pigment { rgbf 1 }
  finish { ambient 0 diffuse 0 phong 0.3 phong_size 60 reflection 0.5 }
}
#declare Glass3 = texture {
  pigment { rgbf <0.98, 0.98, 0.98, 0.9> }
  finish { ambient 0.1 diffuse 0.1 phong 1 phong_size 400 specular 0.8 roughness 0.0003 reflection 0.1 }
}
#declare NBglass = texture {
  pigment { rgbf <0.98, 1, 0.99, 0.75> }
  finish { ambient 0.1 diffuse 0.1 specular 1 roughness 0.001 reflection 0.25 }
}
#declare Green_Glass = texture { Glass3 pigment { rgbf <0.8, 1, 0.95, 0.9> } }
#declare NBoldglass = texture { NBglass pigment { rgbf <0.8, 0.9, 0.85, 0.85> } }
#declare NBwinebottle = texture { NBglass pigment { rgbf <0.4, 0.72, 0.4, 0.6> } }
#declare NBbeerbottle = texture { NBglass pigment { rgbf <0.7, 0.5, 0.1, 0.6> } }
#declare Ruby_Glass = texture { NBglass pigment { rgbf <0.9, 0.1, 0.2, 0.8> } }
#declare Dark_Green_Glass = texture { NBglass pigment { rgbf <0.1, 0.7, 0.8, 0.8> } }
#declare Yellow_Glass = texture { NBglass pigment { rgbf <0.8, 0.8, 0.2, 0.8> } }
#declare Orange_Glass = texture { NBglass pigment { rgbf <1, 0.5, 0, 0.8> } }
#declare Vicks_Bottle_Glass = texture { NBglass pigment { rgbf <0.1, 0.15, 0.5, 0.9> } }

#declare Metal = finish {
  ambient 0.2 diffuse 0.7 brilliance 6 phong 0.75 phong_size 80 reflection 0.25 metallic
}
#declare Chrome_Texture = texture {
  pigment { rgb 0.658824 }
  finish { ambient 0.3 diffuse 0.7 brilliance 8 specular 0.8 roughness 0.1 reflection 0.15 }
}
#declare Brass_Texture = texture { pigment { rgb <0.71, 0.65, 0.26> } finish { Metal } }
#declare Gold_Texture = texture { pigment { rgb <0.85, 0.85, 0.1> } finish { Metal } }
#declare Bronze_Texture = texture { pigment { rgb <0.55, 0.47, 0.14> } finish { Metal } }
#declare Copper_Texture = texture { pigment { rgb <0.72, 0.45, 0.2> } finish { Metal } }
#declare Silver_Texture = texture { pigment { rgb <0.9, 0.91, 0.98> } finish { Metal } }
#declare Polished_Chrome = texture {
  pigment { rgb 0.2 }
  finish { ambient 0.1 diffuse 0.7 brilliance 6 phong 0.8 phong_size 120 reflection 0.6 }
}
#declare Polished_Brass = texture {
  pigment { rgb <0.578, 0.422, 0.195> }
  finish { ambient 0.1 diffuse 0.8 brilliance 6 phong 0.8 phong_size 120 reflection 0.4 metallic }
}
#declare New_Brass = texture {
  pigment { rgb <0.7, 0.56, 0.37> }
  finish { ambient 0.35 diffuse 1 brilliance 15 phong 0.41 phong_size 5 }
}

#declare SilverFinish = finish {
  ambient 0.25 diffuse 0.65 brilliance 6 phong 1 phong_size 100 reflection 0.45 metallic
}
#declare Silver1_Colour = rgb <0.94, 0.93, 0.83>;
#declare Silver2_Colour = rgb <0.94, 0.93, 0.86>;
#declare Silver3_Colour = rgb <0.94, 0.93, 0.9>;
#declare Silver1 = texture { pigment { Silver1_Colour } finish { SilverFinish } }
#declare Silver2 = texture { pigment { Silver2_Colour } finish { SilverFinish } }
#declare Silver3 = texture { pigment { Silver3_Colour } finish { SilverFinish } }

#declare Metallic_Finish = finish {
  ambient 0.1 diffuse 0.65 brilliance 1.5 specular 0.85 roughness 0.01 reflection 0.45 metallic
}
#declare Soft_Silver = texture { pigment { Silver1_Colour } finish { Metallic_Finish ambient 0.2 diffuse 0.35 } }
#declare New_Penny = texture { pigment { rgb <0.6, 0.45, 0.4> } finish { Metallic_Finish } }
#declare Tinny_Brass = texture { pigment { rgb <0.7, 0.56, 0.37> } finish { Metallic_Finish } }
#declare Gold_Nugget = texture { pigment { rgb <0.5, 0.35, 0.25> } finish { Metallic_Finish } }
#declare Aluminum = texture { pigment { rgb <0.55, 0.5, 0.45> } finish { Metallic_Finish } }
#declare Bright_Bronze = texture { pigment { rgb <0.36, 0.28, 0.2> } finish { Metallic_Finish } }

#declare Water_Int = interior { ior 1.33 }
)";
    for (const char* metal : {"Chrome", "Brass", "Gold", "Bronze", "Copper", "Silver"})
        text += fmt::format("#declare {0}_Metal = texture {{ {0}_Texture }}\n", metal);
    constexpr std::pair<const char*, const char*> glasses[] = {
        {"Glass", "Glass"},
        {"Glass2", "Glass2"},
        {"Glass3", "Glass3"},
        {"Green_Glass", "Green_Glass"},
        {"NB_Glass", "NBglass"},
        {"NB_Old_Glass", "NBoldglass"},
        {"NB_Winebottle_Glass", "NBwinebottle"},
        {"NB_Beerbottle_Glass", "NBbeerbottle"},
        {"Ruby_Glass", "Ruby_Glass"},
        {"Dark_Green_Glass", "Dark_Green_Glass"},
        {"Yellow_Glass", "Yellow_Glass"},
        {"Orange_Glass", "Orange_Glass"},
        {"Vicks_Bottle_Glass", "Vicks_Bottle_Glass"},
    };
    for (const auto& [material, texture] : glasses)
        text += fmt::format("#declare M_{} = material {{ texture {{ {} }} interior {{ Glass_Interior }} }}\n", material,
                            texture);
    return text + texture_maps();
}

} // namespace proxima::standard
