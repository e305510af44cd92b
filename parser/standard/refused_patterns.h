// SPDX-License-Identifier: Apache-2.0
// Names of the files of textures that need patterns which Proxima does not have.
#pragma once
#include "parser/standard_includes.h"

namespace proxima::standard {

// clang-format off
inline constexpr RefusedNames skies_refused[] = {
    {"bozo",
     "P_Cloud1 P_Cloud3 S_Cloud4 S_Cloud5 T_Cloud1 O_Cloud1 T_Cloud2 T_Cloud3 O_Cloud2"},
    {"wrinkles",
     "P_Cloud2 P_Cloud4 S_Cloud1 S_Cloud2 S_Cloud3"},
};

inline constexpr RefusedNames stars_refused[] = {
    {"granite",
     "Starfield1 Starfield2 Starfield3 Starfield4 Starfield5 Starfield6"},
};

inline constexpr RefusedNames stoneold_refused[] = {
    {"granite",
     "Grnt0 Grnt1 Grnt2 Grnt3 Grnt4 Grnt5 Grnt6 Grnt7 Grnt8 Grnt9 Grnt10 Grnt11 Grnt12 Grnt13 Grnt14 Grnt15 "
     "Grnt16 Grnt17 Grnt18 Grnt19 Grnt20 Grnt21 Grnt22 Grnt26 Grnt27 Grnt0a Grnt1a Grnt2a Crack2 Stone1 Stone2 "
     "Stone3 Stone4 Stone6 Stone7 Stone8 Stone9 Stone10 Stone11 Stone14 Stone15 Stone16 Stone18 Stone19 "
     "Stone20 Stone21 Stone22"},
    {"marble",
     "Grnt23 Grnt24 Grnt25 Grnt28 Grnt29 Crack1 Crack3 Crack4 Stone5 Stone12 Stone13 Stone17 Stone23 Stone24"},
};

inline constexpr RefusedNames stones1_refused[] = {
    {"granite",
     "T_Grnt0 T_Grnt1 T_Grnt2 T_Grnt3 T_Grnt4 T_Grnt5 T_Grnt6 T_Grnt7 T_Grnt8 T_Grnt9 T_Grnt10 T_Grnt11 "
     "T_Grnt12 T_Grnt13 T_Grnt14 T_Grnt15 T_Grnt16 T_Grnt17 T_Grnt18 T_Grnt19 T_Grnt20 g1 g2 g3 g4 T_Grnt21 "
     "T_Grnt22 T_Grnt26 T_Grnt27 T_Grnt0a T_Grnt1a T_Grnt2a T_Grnt3a T_Grnt4a T_Grnt5a T_Grnt6a T_Grnt7a "
     "T_Grnt8a T_Grnt9a T_Grnt10a T_Grnt11a T_Grnt12a T_Grnt13a T_Grnt14a T_Grnt15a T_Grnt16a T_Grnt17a "
     "T_Grnt18a T_Grnt19a T_Grnt20a T_Grnt21a T_Grnt22a T_Grnt23a T_Grnt24a T_Crack2 T_Stone1 T_Stone2 "
     "T_Stone3 T_Stone4 T_Stone6 T_Stone7 T_Stone8 T_Stone9 T_Stone10 T_Stone11 T_Stone14 T_Stone15 T_Stone16 "
     "T_Stone18 T_Stone19 T_Stone20 T_Stone21 T_Stone22"},
    {"marble",
     "T_Grnt23 T_Grnt24 T_Grnt25 T_Grnt28 T_Grnt29 T_Crack1 T_Crack3 T_Crack4 T_Stone5 T_Stone12 T_Stone13 "
     "T_Stone17 T_Stone23 T_Stone24"},
};

inline constexpr RefusedNames stones2_refused[] = {
    {"crackle",
     "T_Stone25 T_Stone27 T_Stone30 T_Stone31 T_Stone32 T_Stone33 T_Stone34 T_Stone35"},
    {"granite",
     "T_Stone26 T_Stone29 T_Stone36 T_Stone37 T_Stone38 T_Stone39 T_Stone40 T_Stone42 T_Stone43 T_Stone44"},
    {"agate",
     "T_Stone28"},
    {"marble",
     "T_Stone41"},
};

inline constexpr RefusedNames textures_refused[] = {
    {"marble",
     "Jade Red_Marble White_Marble Blood_Marble Lightning1"},
    {"agate",
     "Blue_Agate Sapphire_Agate Brown_Agate Blue_Sky2"},
    {"granite",
     "Pink_Granite PinkAlabaster Blue_Sky3 Brass_Valley Rust Rusty_Iron Cork Lightning2 Starfield"},
    {"bozo",
     "Blue_Sky Bright_Blue_Sky Blood_Sky Apocalypse Clouds FBM_Clouds Shadow_Clouds Sandalwood"},
    {"wood",
     "Cherry_Wood Pine_Wood Dark_Wood Tan_Wood White_Wood Tom_Wood DMFWood1 DMFWood2 DMFWood3 DMFWood4 "
     "DMFWood5 DMFWood6 DMFLightOak DMFDarkOak EMBWood1 Yellow_Pine Rosewood"},
    {"waves",
     "Spun_Brass"},
    {"bumps",
     "Brushed_Aluminum"},
    {"ripples",
     "Water M_Water"},
    {"pigment_pattern",
     "Hex_Tiles_Ptrn Star_Ptrn"},
    {"warp",
     "Irregular_Bricks_Ptrn Tiles_Ptrn"},
};

inline constexpr RefusedNames woods_refused[] = {
    {"wood",
     "P_WoodGrain1A P_WoodGrain1B P_WoodGrain2A P_WoodGrain2B P_WoodGrain3A P_WoodGrain3B P_WoodGrain4A "
     "P_WoodGrain5A P_WoodGrain5B P_WoodGrain6A P_WoodGrain6B P_WoodGrain7A P_WoodGrain8A P_WoodGrain8B "
     "P_WoodGrain9A P_WoodGrain9B P_WoodGrain10A P_WoodGrain10B P_WoodGrain11A P_WoodGrain11B P_WoodGrain12B "
     "P_WoodGrain13A P_WoodGrain13B P_WoodGrain14A P_WoodGrain14B P_WoodGrain15B P_WoodGrain16B P_WoodGrain17A "
     "P_WoodGrain17B P_WoodGrain18A P_WoodGrain18B P_WoodGrain19A T_Wood1 T_Wood2 T_Wood3 T_Wood4 T_Wood5 "
     "T_Wood6 T_Wood7 T_Wood8 T_Wood9 T_Wood10 T_Wood11 T_Wood12 T_Wood13 T_Wood14 T_Wood15 T_Wood16 T_Wood17 "
     "T_Wood18 T_Wood19 T_Wood20 T_Wood21 T_Wood22 T_Wood23 T_Wood24 T_Wood25 T_Wood26 T_Wood27 T_Wood28 "
     "T_Wood29 T_Wood30 T_Wood31 T_Wood32 T_Wood33 T_Wood34 T_Wood35"},
    {"bozo",
     "P_WoodGrain4B P_WoodGrain7B P_WoodGrain12A P_WoodGrain15A P_WoodGrain16A P_WoodGrain19B"},
};

// clang-format on

} // namespace proxima::standard
