// SPDX-License-Identifier: Apache-2.0
// woodmaps.inc, and the color maps and gradients of textures.inc. Entries that change nothing are left out: those that
// repeat the one before, and those in a run of one color.
#include "parser/standard/texts.h"

namespace proxima::standard {

std::string woodmaps() {
    return R"(
#declare M_Wood1A = color_map { [0.1 rgb <0.88, 0.6, 0.4>] [0.9 rgb <0.6, 0.3, 0.2>] }
#declare M_Wood1B = color_map {
  [0 rgbt <0.55, 0.32, 0.2, 0.1>] [0.1 rgbt <0.55, 0.32, 0.2, 0.5>] [0.1 rgbt <0.55, 0.35, 0.2, 0.65>]
  [0.2 rgbt <0.88, 0.6, 0.4, 0.975>] [0.3 rgbt <0.6, 0.3, 0.2, 1>] [0.3 rgbt <0.6, 0.3, 0.2, 0.1>]
  [0.4 rgbt <0.6, 0.3, 0.2, 0.5>] [0.4 rgbt <0.6, 0.3, 0.2, 0.65>] [0.9 rgbt <0.88, 0.6, 0.4, 0.975>]
  [1 rgbt <0.55, 0.32, 0.2, 1>]
}
#declare M_Wood2A = color_map {
  [0.1 rgb <0.175, 0.08, 0.06>] [0.1 rgb <0.175, 0.1, 0.08>] [0.9 rgb <0.23, 0.13, 0.09>] [1 rgb <0.175, 0.08, 0.06>]
}
#declare M_Wood2B = color_map {
  [0 rgbt <0.5, 0.3, 0.2, 0.1>] [0.1 rgbt <0.5, 0.3, 0.2, 0.5>] [0.1 rgbt <0.5, 0.3, 0.2, 0.65>]
  [0.9 rgbt <0.5, 0.25, 0.15, 0.975>] [1 rgbt <0.5, 0.3, 0.2, 0>]
}
#declare M_Wood3A = color_map { [0.1 rgb <0.75, 0.65, 0.45>] [0.9 rgb <0.7, 0.55, 0.4>] [1 rgb <0.75, 0.65, 0.45>] }
#declare M_Wood3B = color_map {
  [0 rgbt <0.7, 0.6, 0.4, 0.1>] [0.1 rgbt <0.7, 0.6, 0.4, 0.5>] [0.1 rgbt <0.7, 0.6, 0.4, 0.65>]
  [0.9 rgbt <0.75, 0.7, 0.6, 0.975>] [1 rgbt <0.7, 0.6, 0.4, 1>]
}
#declare M_Wood4A = color_map {
  [0 rgb <0.3, 0.1, 0.15>] [0.3 rgb <0.3, 0.15, 0.15>] [0.6 rgb <0.5, 0.2, 0.15>] [1 rgb <0.3, 0.1, 0.15>]
}
#declare M_Wood4B = color_map {
  [0 rgbt <0.32, 0.15, 0.17, 0>] [0.3 rgbt <0.32, 0.13, 0.15, 0.2>] [0.3 rgbt <0.32, 0.13, 0.13, 0.35>]
  [0.4 rgbt <0.52, 0.25, 0.23, 0.4>] [0.4 rgbt <0.52, 0.25, 0.23, 0.2>] [0.6 rgbt <0.32, 0.13, 0.13, 0.35>]
  [0.6 rgbt <0.32, 0.13, 0.15, 0.5>] [1 rgbt <0.32, 0.15, 0.2, 0>]
}
#declare M_Wood5A = color_map { [0.3 rgb <0.5, 0.35, 0.1>] [0.6 rgb <0.6, 0.45, 0.1>] [1 rgb <0.5, 0.35, 0.1>] }
#declare M_Wood5B = color_map {
  [0 rgbt <0.4, 0.35, 0.1, 1>] [0.1 rgbt <0.4, 0, 0.1, 0.6>] [0.1 rgbt <0.4, 0, 0.1, 0.75>]
  [0.9 rgbt <0.35, 0.4, 0.15, 0.9>] [1 rgbt <0.4, 0.35, 0.1, 1>]
}
#declare M_Wood6A = color_map { [0.3 rgb <0.25, 0.1, 0.1>] [0.6 rgb <0.6, 0.15, 0.1>] [1 rgb <0.25, 0.1, 0.1>] }
#declare M_Wood6B = color_map {
  [0 rgbt <0.25, 0.1, 0.1, 0>] [0.3 rgbt <0.25, 0.1, 0.1, 0.4>] [0.5 rgbt <0.6, 0.15, 0.1, 1>]
  [0.7 rgbt <0.25, 0.1, 0.1, 0.4>] [0.7 rgbt <0.6, 0.15, 0.1, 0.4>] [1 rgbt <0.25, 0.1, 0.1, 0>]
}
#declare M_Wood7A = color_map { [0.1 rgb <0.6, 0.35, 0.2>] [0.9 rgb <0.9, 0.65, 0.3>] [1 rgb <0.6, 0.35, 0.2>] }
#declare M_Wood7B = color_map { [0 rgbt <0.9, 0.65, 0.3, 0>] [0.1 rgbt <0.9, 0.65, 0.3, 0.3>] [1 rgbt 1] }
#declare M_Wood8A = color_map {
  [0.1 rgb <0.45, 0.3, 0.15>] [0.1 rgb <0.55, 0.3, 0.15>] [0.9 rgb <0.2, 0.15, 0.05>] [1 rgb <0.45, 0.3, 0.15>]
}
#declare M_Wood8B = color_map { [0 rgbt <0.6, 0.35, 0.2, 0.3>] [0.5 rgbt <0.6, 0.35, 0.2, 0.8>] [1 rgbt 1] }
#declare M_Wood9A = color_map {
  [0 rgb <1, 0.85, 0.5>] [0.5 rgb <0.6, 0.4, 0.16>] [0.7 rgb <0.6, 0.4, 0.16>] [1 rgb <1, 0.85, 0.5>]
}
#declare M_Wood9B = color_map {
  [0 rgbt <1, 0.7, 0.25, 1>] [0.5 rgbt <0.5, 0.3, 0.06, 0.4>] [0.7 rgbt <0.5, 0.3, 0.06, 0.3>]
  [0.7 rgbt <0.5, 0.3, 0.06, 0.4>] [1 rgbt <1, 0.7, 0.25, 1>]
}
#declare M_Wood10A = color_map {
  [0 rgb <1, 0.85, 0.5>] [0.5 rgb <0.9, 0.7, 0.46>] [0.7 rgb <0.9, 0.7, 0.46>] [1 rgb <1, 0.85, 0.5>]
}
#declare M_Wood10B = color_map {
  [0 rgbt <1, 0.45, 0.1, 0.8>] [0.5 rgbt <0.85, 0.65, 0.4, 0.4>] [0.7 rgbt <0.85, 0.65, 0.4, 0.4>]
  [1 rgbt <1, 0.45, 0.1, 0.8>]
}
#declare M_Wood11A = color_map {
  [0.222 rgb <0.8, 0.67, 0.25>] [0.342 rgb <0.6, 0.34, 0.04>] [0.393 rgb <0.8, 0.67, 0.25>]
  [0.709 rgb <0.8, 0.67, 0.25>] [0.821 rgb <0.53, 0.29, 0.02>] [1 rgb <0.8, 0.67, 0.25>]
}
#declare M_Wood11B = color_map {
  [0 rgbt 1] [0.12 rgbt <0.7, 0.41, 0.11, 0.6>] [0.231 rgbt <0.7, 0.46, 0.11, 0.6>] [0.496 rgbt 1] [0.701 rgbt 1]
  [0.829 rgbt <0.7, 0.46, 0.11, 0.6>] [1 rgbt 1]
}
#declare M_Wood12A = color_map {
  [0 rgb <0.25, 0.1375, 0.0875>] [0.256 rgb <0.2875, 0.15, 0.1125>] [0.393 rgb <0.3, 0.1625, 0.1125>]
  [0.581 rgb <0.25, 0.1375, 0.0875>] [0.726 rgb <0.3125, 0.15, 0.125>] [0.983 rgb <0.2875, 0.15, 0.1>]
  [1 rgb <0.25, 0.1375, 0.0875>]
}
#declare M_Wood12B = color_map {
  [0 rgbt <0.545, 0.349, 0.247, 1>] [0.139 rgbt <0.45, 0.35, 0.32, 0.8>] [0.148 rgbt <0.45, 0.35, 0.32, 0.8>]
  [0.287 rgbt <0.545, 0.349, 0.247, 1>] [0.443 rgbt <0.545, 0.349, 0.247, 1>] [0.626 rgbt <0.45, 0.35, 0.32, 0.8>]
  [0.635 rgbt <0.45, 0.35, 0.32, 0.8>] [0.843 rgbt <0.545, 0.349, 0.247, 1>]
}
#declare M_Wood13A = color_map { M_Wood7A }
#declare M_Wood13B = color_map {
  [0 rgbt 1] [0.4 rgbt <0.9, 0.65, 0.3, 0.3>] [0.4 rgbt <0.9, 0.65, 0.3, 0>] [0.5 rgbt <0.9, 0.65, 0.3, 0.3>]
  [1 rgbt 1]
}
#declare M_Wood14A = color_map { [0.1 rgb <0.8, 0.232, 0.115>] [0.9 rgb <0.45, 0.115, 0.06>] }
#declare M_Wood14B = color_map {
  [0 rgbt <0.7, 0.232, 0.115, 0.5>] [0.1 rgbt <0.7, 0.232, 0.115, 0.7>] [0.15 rgbt <0.35, 0.115, 0.06, 0.9>]
  [0.15 rgbt <0.7, 0.232, 0.115, 0.9>] [0.2 rgbt <0.35, 0.115, 0.06, 0.7>] [1 rgbt <0.35, 0.115, 0.06, 0.5>]
}
#declare M_Wood15A = color_map {
  [0 rgb <0.3528, 0.217, 0.0546>] [0.25 rgb <0.4248, 0.26, 0.072>] [0.4 rgb <0.2735, 0.1665, 0.045>]
  [0.5 rgb <0.3024, 0.186, 0.045>] [0.7 rgb <0.2236, 0.1288, 0.0408>] [0.98 rgb <0.2124, 0.13, 0.0344>]
  [1 rgb <0.3528, 0.217, 0.0546>]
}
#declare M_Wood15B = color_map {
  [0 rgbt <0.404, 0.21, 0.078, 0.2>] [0.25 rgbt <0.431, 0.225, 0.09, 0.8>] [0.4 rgbt <0.447, 0.233, 0.09, 0.2>]
  [0.5 rgbt <0.404, 0.21, 0.075, 0.6>] [0.7 rgbt <0.459, 0.222, 0.102, 0.2>] [0.98 rgbt <0.431, 0.225, 0.086, 0.4>]
  [1 rgbt <0.404, 0.21, 0.078, 0.1>]
}
#declare M_Wood16A = color_map { M_Wood15A }
#declare M_Wood16B = color_map {
  [0 rgbt <0.404, 0.21, 0.078, 0.3>] [0.25 rgbt <0.431, 0.225, 0.09, 0.6>] [0.4 rgbt <0.447, 0.233, 0.09, 0.3>]
  [0.5 rgbt <0.404, 0.21, 0.075, 0.4>] [0.7 rgbt <0.459, 0.222, 0.102, 0.2>] [0.98 rgbt <0.431, 0.225, 0.086, 0.5>]
  [1 rgbt <0.404, 0.21, 0.078, 0.3>]
}
#declare M_Wood17A = color_map {
  [0 rgb <0.63, 0.36, 0.135>] [0.25 rgb <0.525, 0.294, 0.21>] [0.25 rgb <0.525, 0.294, 0.175>]
  [0.4 rgb <0.37, 0.215, 0.15>] [0.4 rgb <0.37, 0.215, 0.1>] [0.5 rgb <0.21, 0.126, 0.045>]
  [0.7 rgb <0.256, 0.184, 0.04>] [0.98 rgb <0.39, 0.252, 0.12>] [1 rgb <0.54, 0.36, 0.135>]
}
#declare M_Wood17B = color_map {
  [0 rgbt <0.4, 0.2, 0.08, 0.1>] [0.25 rgbt <0.44, 0.23, 0.09, 0.2>] [0.4 rgbt <0.45, 0.25, 0.09, 0.3>]
  [0.5 rgbt <0.4, 0.2, 0.08, 0.6>] [0.7 rgbt <0.46, 0.23, 0.1, 0.3>] [0.98 rgbt <0.44, 0.23, 0.09, 0.2>]
  [1 rgbt <0.4, 0.2, 0.08, 0.1>]
}
#declare M_Wood18A = color_map {
  [0 rgb <1, 0.5, 0>] [0.15 rgb <0.5, 0.25, 0>] [0.25 rgb <0.7, 0.315, 0>] [0.25 rgb <0.8, 0.36, 0>]
  [0.28 rgb <0.3, 0.108, 0>] [0.4 rgb <0.4, 0.16, 0>] [0.5 rgb <0.6, 0.24, 0>] [0.5 rgb <0.6, 0.3, 0>]
  [0.7 rgb <0.7, 0.35, 0>] [0.7 rgb <0.7, 0.315, 0>] [0.98 rgb <0.5, 0.225, 0>] [1 rgb <1, 0.5, 0>]
}
#declare M_Wood18B = color_map {
  [0 rgbt <0.5, 0.26, 0.12, 0.3>] [0.25 rgbt <0.54, 0.29, 0.13, 0.4>] [0.4 rgbt <0.55, 0.28, 0.1, 0.6>]
  [0.5 rgbt <0.5, 0.23, 0.15, 1>] [0.7 rgbt <0.56, 0.29, 0.17, 0.6>] [0.98 rgbt <0.54, 0.29, 0.13, 0.4>]
  [1 rgbt <0.5, 0.26, 0.12, 0.3>]
}
#declare M_Wood19A = color_map {
  [0 rgb <0.5, 0.25, 0.125>] [0.4 rgb <1, 0.5, 0.25>] [0.6 rgb <1, 0.5, 0.25>] [1 rgb <0.5, 0.25, 0.125>]
}
#declare M_Wood19B = color_map { [0 rgb <0.35, 0.175, 0.0875>] [0.3 rgb <1, 0.5, 0.25>] [0.3 rgbf 1] }
)";
}

std::string texture_maps() {
    return R"(
#declare Jade_Map = color_map {
  [0 rgb <0.1, 0.6, 0.1>] [0.8 rgb <0, 0.3, 0>] [0.8 rgb <0.1, 0.6, 0.1>] [1 rgb <0, 0.2, 0>]
}
#declare Red_Marble_Map = color_map { [0 rgb <0.8, 0.8, 0.6>] [0.8 rgb <0.8, 0.4, 0.4>] [1 rgb <0.8, 0.2, 0.2>] }
#declare White_Marble_Map = color_map { [0 rgb 0.9] [0.8 rgb 0.5] [1 rgb 0.2] }
#declare Blood_Marble_Map = color_map { [0 rgb 0] [0.8 rgb <0, 0.6, 0.6>] [0.9 rgb <0.6, 0, 0>] [1 rgb 0] }
#declare Blue_Agate_Map = color_map {
  [0.5 rgb <0.3, 0.3, 0.5>] [0.55 rgb <0.2, 0.2, 0.3>] [0.6 rgb <0.25, 0.25, 0.35>] [0.7 rgb <0.15, 0.15, 0.26>]
  [0.8 rgb <0.1, 0.1, 0.2>] [0.9 rgb <0.3, 0.3, 0.5>] [1 rgb <0.1, 0.1, 0.2>]
}
#declare Sapphire_Agate_Map = color_map { [0 rgb <0, 0, 0.9>] [0.3 rgb <0, 0, 0.8>] [1 rgb <0, 0, 0.4>] }
#declare Brown_Agate_Map = color_map {
  [0 rgb 0] [0.5 rgb <0.9, 0.7, 0.6>] [0.6 rgb <0.9, 0.7, 0.4>] [1 rgb <0.7, 0.4, 0.2>]
}
#declare Pink_Granite_Map = color_map {
  [0.4 rgb 0] [0.4 rgb <0.85, 0.85, 0.95>] [0.45 rgb <0.85, 0.85, 0.95>] [0.5 rgb 0.75] [0.55 rgb <0.82, 0.57, 0.46>]
  [0.8 rgb <0.82, 0.57, 0.46>] [1 rgb <1, 0.5, 0>]
}
#declare Blue_Sky_Map = color_map { [0.5 rgb <0.25, 0.25, 0.5>] [0.6 rgb 0.7] [1 rgb 0.3] }
#declare Lightning_CMap1 = color_map {
  [0 rgbf <1, 1, 1, 0>] [0.15 rgbf <0.94, 0.81, 0.99, 0.65>] [0.25 rgbf <0.94, 0.81, 0.99, 0.65>]
  [0.3 rgbf <0.87, 0.58, 0.98, 0.85>] [0.4 rgbf <0.87, 0.58, 0.98, 0.85>] [0.45 rgbf <0.73, 0.16, 0.96, 0.95>]
}
#declare Lightning_CMap2 = color_map {
  [0 rgbf <1, 1, 1, 0>] [0.1 rgbf <0.94, 0.81, 0.99, 0.65>] [0.2 rgbf <0.94, 0.81, 0.99, 0.65>]
  [0.3 rgbf <0.87, 0.58, 0.98, 0.85>] [0.45 rgbf <0.87, 0.58, 0.98, 0.85>] [0.65 rgbf <0.73, 0.16, 0.96, 0.95>]
}

#declare Candy_Cane = pigment {
  gradient x + y color_map { [0.25 rgb x] [0.25 rgb 1] [0.75 rgb 1] [0.75 rgb x] }
}
#declare Peel = pigment {
  gradient x + y
  color_map { [0.25 rgb <1, 0.5, 0>] [0.25 rgbf 1] [0.75 rgbf 1] [0.75 rgb <1, 0.5, 0>] }
}
#declare X_Gradient = pigment { gradient x color_map { [0 rgb x] [0.33 rgb z] [0.66 rgb 1] } }
#declare Y_Gradient = pigment { gradient y color_map { [0 rgb x] [0.33 rgb z] [0.66 rgb y] [1 rgb x] } }
)";
}

} // namespace proxima::standard
