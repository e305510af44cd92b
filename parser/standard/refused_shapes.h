// SPDX-License-Identifier: Apache-2.0
// Names of the files of shapes, functions and macros that need what Proxima does not have.
#pragma once
#include "parser/standard_includes.h"

namespace proxima::standard {

// clang-format off
inline constexpr RefusedNames arrays_refused[] = {
    {"write",
     "ARRAYS_WriteDF3"},
};

inline constexpr RefusedNames chars_refused[] = {
    {"box",
     "char_A char_F char_E char_G char_H char_I char_K char_L char_M char_N char_O char_Q char_R char_T char_U "
     "char_V char_W char_X char_Y char_Z char_Dash char_Plus char_0 char_1 char_4 char_7 char_Num char_Hat "
     "char_Astr char_LSqu char_RSqu"},
    {"cylinder",
     "char_P char_B char_C char_D char_J char_S char_2 char_3 char_5 char_6 char_8 char_9 char_ExclPt "
     "char_AtSign char_Dol char_Perc char_Amps char_LPar char_RPar"},
};

inline constexpr RefusedNames functions_refused[] = {
    {"function",
     "f_algbr_cyl1 f_algbr_cyl2 f_algbr_cyl3 f_algbr_cyl4 f_bicorn f_bifolia f_blob f_blob2 f_boy_surface "
     "f_comma f_cross_ellipsoids f_crossed_trough f_cubic_saddle f_cushion f_devils_curve f_devils_curve_2d "
     "f_dupin_cyclid f_ellipsoid f_enneper f_flange_cover f_folium_surface f_folium_surface_2d f_glob f_heart "
     "f_helical_torus f_helix1 f_helix2 f_hex_x f_hex_y f_hetero_mf f_hunt_surface f_hyperbolic_torus "
     "f_isect_ellipsoids f_kampyle_of_eudoxus f_kampyle_of_eudoxus_2d f_klein_bottle f_kummer_surface_v1 "
     "f_kummer_surface_v2 f_lemniscate_of_gerono f_lemniscate_of_gerono_2d f_mesh1 f_mitre f_nodal_cubic f_odd "
     "f_ovals_of_cassini f_paraboloid f_parabolic_torus f_ph f_pillow f_piriform f_piriform_2d f_poly4 "
     "f_polytubes f_quantum f_quartic_paraboloid f_quartic_saddle f_quartic_cylinder f_r f_ridge f_ridged_mf "
     "f_rounded_box f_sphere f_spikes f_spikes_2d f_spiral f_steiners_roman f_strophoid f_strophoid_2d "
     "f_superellipsoid f_th f_torus f_torus2 f_torus_gumdrop f_umbrella f_witch_of_agnesi f_witch_of_agnesi_2d "
     "f_noise3d f_snoise3d f_noise_generator eval_pigment f_agate f_boxed f_bozo f_brick f_bumps f_checker "
     "f_crackle f_cylindrical f_dents f_gradientX f_gradientY f_gradientZ f_granite f_hexagon f_leopard "
     "f_mandel f_marble f_onion f_planar f_radial f_ripples f_spherical f_spiral1 f_spiral2 f_spotted f_waves "
     "f_wood f_wrinkles f_sine_wave f_scallop_wave"},
};

inline constexpr RefusedNames glass_refused[] = {
    {"dispersion",
     "I_Glass_Dispersion1 I_Glass_Dispersion2"},
    {"caustics",
     "I_Glass_Caustics1 I_Glass_Caustics2"},
};

inline constexpr RefusedNames logo_refused[] = {
    {"cone",
     "Povray_Logo Povray_Logo_Bevel"},
    {"prism",
     "Povray_Logo_Prism"},
};

inline constexpr RefusedNames rand_refused[] = {
    {"inside",
     "VRand_In_Obj"},
};

inline constexpr RefusedNames shapes_refused[] = {
    {"trace",
     "Isect IsectN"},
    {"min_extent",
     "Extents Center_Object Align_Object"},
    {"text",
     "Bevelled_Text Text_Space Text_Width Circle_Text Circle_Text_Valigned"},
    {"difference",
     "Wedge"},
    {"isosurface",
     "Supertorus"},
    {"cone",
     "Supercone Connect_Spheres Round_Cone_Union Round_Cone2_Union Round_Cone2 Round_Cone3_Union Round_Cone3"},
    {"cylinder",
     "Wire_Box_Union Wire_Box Round_Box Round_Cylinder_Union"},
    {"merge",
     "Wire_Box_Merge Round_Box_Merge Round_Cylinder_Merge Round_Cone_Merge Round_Cone2_Merge Round_Cone3_Merge"},
    {"box",
     "Round_Box_Union"},
    {"torus",
     "Round_Cylinder Round_Cone"},
    {"triangle",
     "Quad"},
    {"smooth_triangle",
     "Smooth_Quad"},
    {"mesh2",
     "HF_Square HF_Sphere HF_Cylinder HF_Torus"},
    {"mesh2",
     "HFCreate_"},
};

inline constexpr RefusedNames shapes2_refused[] = {
    {"intersection",
     "Tetrahedron Octahedron Dodecahedron Icosahedron HalfCone_Y Hexagon Rhomboid"},
    {"triangle",
     "Pyramid Square_X Square_Y Square_Z"},
    {"box",
     "Pyramid2"},
};

inline constexpr RefusedNames shapes3_refused[] = {
    {"box",
     "Segment_of_Object Egg_Shape Egg"},
    {"cylinder",
     "Segment_of_CylinderRing"},
    {"torus",
     "Segment_of_Torus Ring_Sphere Rounded_Tube Rounded_Tube_AB Round_Cylinder_Tube Round_Conic_Torus "
     "Round_Conic_Prism Half_Hollowed_Rounded_Cylinder1 Half_Hollowed_Rounded_Cylinder2"},
    {"prism",
     "Round_N_Tube_Polygon Pyramid_N Pyramid_N_AB Column_N Column_N_AB Facetted_Sphere Facetted_Egg_Shape "
     "Facetted_Egg Round_Pyramid_N_in Round_Pyramid_N_out"},
};

inline constexpr RefusedNames shapes_old_refused[] = {
    {"quadric",
     "Cylinder_X Cylinder_Y Cylinder_Z QCone_X QCone_Y QCone_Z Paraboloid_X Paraboloid_Y Paraboloid_Z "
     "Hyperboloid Hyperboloid_Y"},
    {"cone",
     "Cone_X Cone_Y Cone_Z"},
    {"box",
     "UnitBox Cube"},
    {"cylinder",
     "Disk_X Disk_Y Disk_Z"},
};

inline constexpr RefusedNames shapesq_refused[] = {
    {"quartic",
     "Bicorn Crossed_Trough"},
    {"cubic",
     "Cubic_Cylinder"},
    {"poly",
     "Cubic_Saddle_1 Devils_Curve Folium Glob_5 Twin_Glob Hyperbolic_Torus_40_12 Lemniscate Quartic_Loop_1 "
     "Monkey_Saddle Parabolic_Torus_40_12 Piriform Quartic_Paraboloid Quartic_Cylinder Steiner_Surface "
     "Torus_40_12 Witch_Hat Sinsurf"},
    {"quadric",
     "Helix Helix_1"},
};

inline constexpr RefusedNames strings_refused[] = {
    {"write",
     "Parse_String"},
};

inline constexpr RefusedNames transforms_refused[] = {
    {"min_extent",
     "Center_Trans Align_Trans"},
    {"function { transform }",
     "vtransform vinv_transform"},
};

// clang-format on

} // namespace proxima::standard
