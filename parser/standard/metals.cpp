// SPDX-License-Identifier: Apache-2.0
// golds.inc and metals.inc: families of textures, each of five colours (1 to 5) in five finishes (A to E).
#include "parser/standard/texts.h"

namespace proxima::standard {
namespace {

/// `#declare T_Metal_1A = ...` to `T_Metal_5E`
std::string textures_of(const char* metal) {
    std::string text;
    for (char color = '1'; color <= '5'; ++color)
        for (char finish = 'A'; finish <= 'E'; ++finish)
            text +=
                fmt::format("#declare T_{0}_{1}{2} = texture {{ pigment {{ P_{0}{1} }} finish {{ F_Metal{2} }} }}\n",
                            metal, color, finish);
    return text;
}

/// The gold finish of one letter. What is neither reflected nor ambient is diffuse.
std::string gold_finish(char letter, double reflection, double ambient, double specular, int roughness) {
    const int number = letter - 'A' + 1;
    return fmt::format(R"(
#declare R_Gold{0} = P_Gold{1}*{2} + <0.25, 0.25, 0.25>;
#declare A_Gold{0} = P_Gold{1}*{3} + <0.1, 0.1, 0.1>;
#declare D_Gold{0} = max(0, 1 - (((R_Gold{0}.red + R_Gold{0}.green + R_Gold{0}.blue)/3) +
                                 ((A_Gold{0}.red + A_Gold{0}.green + A_Gold{0}.blue)/3)));
#declare F_Metal{0} = finish {{
  ambient A_Gold{0} diffuse D_Gold{0} brilliance {4} specular {5} roughness 1/{6} reflection R_Gold{0} metallic M
}}
)",
                       letter, number, reflection, ambient, number + 1, specular, roughness);
}

} // namespace

std::string golds() {
    std::string text = R"(
#declare M = 1;
#declare GoldBase = <1, 0.875, 0.575>;
)";
    // The paler the gold, the less is taken from its green and blue.
    for (int number = 1; number <= 5; ++number)
        text +=
            fmt::format("#declare CVect{0} = GoldBase - <0, {1:.2f}, {2:.2f}>;\n#declare P_Gold{0} = rgb CVect{0};\n",
                        number, 0.05 * (5 - number), 0.1 * (5 - number));
    text += gold_finish('A', 0.3, 0.12, 0.2, 20);
    text += gold_finish('B', 0.35, 0.1, 0.3, 60);
    text += gold_finish('C', 0.4, 0.08, 0.6, 80);
    text += gold_finish('D', 0.45, 0.05, 0.7, 100);
    text += gold_finish('E', 0.5, 0.02, 0.8, 120);
    text += textures_of("Gold");
    for (int number = 0; number < 25; ++number)
        text += fmt::format("#declare T{:02} = texture {{ T_Gold_{}{} }}\n", number + 1, number / 5 + 1,
                            char('A' + number % 5));
    return text;
}

std::string metals() {
    std::string text = R"(
#include "golds.inc"

#declare P_Brass1 = rgb <0.3, 0.2, 0.1>;
#declare P_Brass2 = rgb <0.5, 0.35, 0.25>;
#declare P_Brass3 = rgb <0.58, 0.42, 0.2>;
#declare P_Brass4 = rgb <0.65, 0.5, 0.25>;
#declare P_Brass5 = rgb <0.7, 0.55, 0.4>;
#declare P_Copper1 = rgb <0.4, 0.2, 0.15>;
#declare P_Copper2 = rgb <0.5, 0.25, 0.15>;
#declare P_Copper3 = rgb <0.6, 0.3, 0.15>;
#declare P_Copper4 = rgb <0.7, 0.25, 0.15>;
#declare P_Copper5 = rgb <0.65, 0.35, 0.15>;
#declare P_Chrome1 = rgb 0.2;
#declare P_Chrome2 = rgb <0.39, 0.41, 0.43>;
#declare P_Chrome3 = rgb 0.5;
#declare P_Chrome4 = rgb 0.75;
#declare P_Chrome5 = rgb 0.95;
#declare P_Silver1 = rgb <0.94, 0.93, 0.8>;
#declare P_Silver2 = rgb <0.94, 0.93, 0.85>;
#declare P_Silver3 = rgb <0.94, 0.93, 0.9>;
#declare P_Silver4 = rgb <0.95, 0.91, 0.91>;
#declare P_Silver5 = rgb <0.91, 0.95, 0.91>;

#declare F_MetalA = finish {
  ambient 0.35 diffuse 0.3 brilliance 2 specular 0.8 roughness 1/20 reflection 0.1 metallic
}
#declare F_MetalB = finish {
  ambient 0.3 diffuse 0.4 brilliance 3 specular 0.7 roughness 1/60 reflection 0.25 metallic
}
#declare F_MetalC = finish {
  ambient 0.25 diffuse 0.5 brilliance 4 specular 0.8 roughness 1/80 reflection 0.5 metallic
}
#declare F_MetalD = finish {
  ambient 0.15 diffuse 0.6 brilliance 5 specular 0.8 roughness 1/100 reflection 0.65 metallic
}
#declare F_MetalE = finish {
  ambient 0.1 diffuse 0.7 brilliance 6 specular 0.8 roughness 1/120 reflection 0.8 metallic
}
)";
    for (const char* metal : {"Brass", "Copper", "Chrome", "Silver"})
        text += textures_of(metal);
    return text;
}

} // namespace proxima::standard
