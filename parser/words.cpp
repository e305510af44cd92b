// SPDX-License-Identifier: Apache-2.0
#include "parser/words.h"

#include <algorithm>
#include <iterator>

namespace proxima {
namespace {

constexpr std::string_view words[] = {
#define PROXIMA_SPELLING(name, spelling) spelling,
    PROXIMA_WORDS(PROXIMA_SPELLING)
#undef PROXIMA_SPELLING
    // Reserved by POV-Ray 3.7 and refused by Proxima.
    // clang-format off
    "aa_level", "aa_threshold", "absorption", "accuracy", "agate", "agate_turb", "all", "all_intersections",
    "alpha", "altitude", "always_sample", "anisotropy", "aoi", "aperture", "arc_angle", "area_illumination",
    "autostop", "average", "b_spline", "bezier_spline", "bicubic_patch", "black_hole", "blob", "blur_samples",
    "bokeh", "bounded_by", "box", "bozo", "brick", "brick_size", "brightness", "bump_map", "bump_size", "bumps",
    "cells", "clipped_by", "collect", "component", "composite", "cone", "confidence", "conic_sweep",
    "contained_by", "control0", "control1", "coords", "count", "crackle", "cube", "cubic",
    "cutaway_textures", "datetime", "density", "density_file", "density_map", "dents", "deprecated", "df3",
    "difference", "disc", "dispersion", "dispersion_samples", "dist_exp", "dtag", "eccentricity", "error_bound",
    "evaluate", "expand_thresholds", "exr", "exterior", "extinction", "face_indices", "facets", "falloff_angle",
    "fisheye", "flatness", "flip", "focal_point", "form", "gamma", "gather", "gif", "global_lights",
    "granite", "gray_threshold", "hdr", "height_field", "hexagon", "hf_gray_16", "hierarchy", "hypercomplex",
    "iff", "image_map", "image_pattern", "importance", "inside", "inside_vector", "interior_texture", "internal",
    "interpolate", "intersection", "intervals", "irid", "irid_wavelength", "isosurface", "jpeg", "julia",
    "julia_fractal", "lambda", "lathe", "light_group", "linear_sweep", "load_file",
    "low_error_factor", "magnet", "major_radius", "mandel", "map_type", "marble", "material_map", "max_extent",
    "max_gradient", "max_iteration", "max_sample", "max_trace", "maximum_reuse", "media", "merge", "mesh", "mesh2",
    "mesh_camera", "method", "metric", "min_extent", "minimum_reuse", "mortar", "nearest_count",
    "no_bump_scale", "no_radiosity", "normal", "normal_indices", "normal_map", "normal_vectors", "number_of_sides",
    "number_of_tiles", "octaves", "offset", "omega", "omnimax", "once", "open", "orientation", "ovus", "panoramic",
    "parametric", "pass_through", "pattern", "pavement", "pgm", "photons", "pigment_pattern", "png",
    "poly", "polygon", "polynomial", "pot", "ppm", "precision", "precompute", "premultiplied", "pretrace_end",
    "pretrace_start", "prism", "prod", "projected_through", "pwr", "quadric", "quartic",
    "quaternion", "quilted", "radiosity", "rainbow", "ratio", "reciprocal", "recursion_limit", "refraction",
    "repeat", "ripples", "samples", "save_file", "scattering", "sint16be", "sint16le", "sint32be", "sint32le",
    "sint8", "size", "slice", "slope", "slope_map", "smooth", "smooth_triangle", "solid", "sor", "spacing",
    "sphere_sweep", "spiral1", "spiral2", "spotted", "sqr", "square", "steps", "strength", "sturm",
    "subsurface", "sum", "superellipsoid", "sys", "target", "text", "texture_list", "texture_map", "tga",
    "thickness", "threshold", "tiff", "tile2", "tiles", "tiling", "tolerance", "toroidal", "torus", "trace",
    "translucency", "triangle", "triangular", "ttf", "turb_depth", "turbulence", "type", "u_steps", "uint16be",
    "uint16le", "uint8", "ultra_wide_angle", "use_alpha", "use_color", "use_colour", "use_index", "uv_indices",
    "uv_mapping", "uv_vectors", "v_steps", "variance", "vertex_vectors", "vturbulence", "warp", "water_level",
    "waves", "width", "wood", "wrinkles", "xyz",
    // clang-format on
};

struct Advice {
    std::string_view word;
    std::string_view advice;
};

constexpr std::string_view shapes = "use spheres and planes: they are the only shapes";
constexpr std::string_view patterns =
    "use a color, checker, gradient, radial, spherical, planar, cylindrical, boxed, onion or leopard";
constexpr std::string_view solids = "use union: there is no constructive solid geometry";
constexpr std::string_view bumps = "leave it out: surfaces are smooth";
constexpr std::string_view indirect = "leave it out and raise ambient: light comes from light sources alone";

constexpr Advice advices[] = {
    {"absorption", "leave it out: there is no participating medium"},
    {"agate", patterns},
    {"aperture", "leave it out: all is in focus"},
    {"area_illumination", "leave it out: only the shadows of an area light are soft"},
    {"average", patterns},
    {"bicubic_patch", shapes},
    {"blob", shapes},
    {"blur_samples", "leave it out: all is in focus"},
    {"bounded_by", "leave it out: bounds are found without it"},
    {"box", shapes},
    {"bozo", patterns},
    {"brick", patterns},
    {"bump_map", bumps},
    {"bumps", bumps},
    {"cells", patterns},
    {"clipped_by", solids},
    {"cone", shapes},
    {"conic_sweep", shapes},
    {"crackle", patterns},
    {"cubic", shapes},
    {"cylinder", shapes},
    {"density", "leave it out: there is no participating medium"},
    {"density_file", patterns},
    {"dents", bumps},
    {"difference", solids},
    {"disc", shapes},
    {"dispersion", "leave it out: light has no wavelengths"},
    {"facets", patterns},
    {"fisheye", "use perspective or orthographic"},
    {"focal_point", "leave it out: all is in focus"},
    {"function", "a function gives numbers to expressions: no pattern or shape is made of one"},
    {"function { transform }", "use vrotate, * and +"},
    {"granite", patterns},
    {"height_field", shapes},
    {"hexagon", patterns},
    {"image_map", patterns},
    {"image_pattern", patterns},
    {"inside", "compute it with numbers: a scene cannot ask about its objects"},
    {"intersection", solids},
    {"irid", "leave it out: light has no wavelengths"},
    {"isosurface", shapes},
    {"julia", patterns},
    {"julia_fractal", shapes},
    {"lambda", "leave it out: patterns are not disturbed"},
    {"lathe", shapes},
    {"light_group", "write the light source and the objects on their own"},
    {"magnet", patterns},
    {"mandel", patterns},
    {"marble", patterns},
    {"material_map", patterns},
    {"max_extent", "compute it with numbers: a scene cannot ask about its objects"},
    {"media", "leave it out: there is no participating medium"},
    {"merge", solids},
    {"mesh", shapes},
    {"mesh2", shapes},
    {"mesh_camera", "use perspective or orthographic"},
    {"min_extent", "compute it with numbers: a scene cannot ask about its objects"},
    {"normal", bumps},
    {"normal_map", bumps},
    {"octaves", "leave it out: patterns are not disturbed"},
    {"omega", "leave it out: patterns are not disturbed"},
    {"omnimax", "use perspective or orthographic"},
    {"ovus", shapes},
    {"panoramic", "use perspective or orthographic"},
    {"parametric", shapes},
    {"pavement", patterns},
    {"photons", indirect},
    {"pigment_pattern", patterns},
    {"poly", shapes},
    {"polygon", shapes},
    {"prism", shapes},
    {"projected_through", "write the light source and the objects on their own"},
    {"quadric", shapes},
    {"quartic", shapes},
    {"quilted", patterns},
    {"radiosity", indirect},
    {"rainbow", "use background"},
    {"ripples", bumps},
    {"scattering", "leave it out: there is no participating medium"},
    {"slope", patterns},
    {"slope_map", bumps},
    {"smooth_triangle", shapes},
    {"sor", shapes},
    {"sphere_sweep", shapes},
    {"spiral1", patterns},
    {"spiral2", patterns},
    {"spotted", patterns},
    {"sqr", "write the product out"},
    {"square", patterns},
    {"subsurface", indirect},
    {"superellipsoid", shapes},
    {"text", shapes},
    {"texture_list", patterns},
    {"texture_map", patterns},
    {"tiling", patterns},
    {"torus", shapes},
    {"trace", "compute it with numbers: a scene cannot ask about its objects"},
    {"triangle", shapes},
    {"triangular", patterns},
    {"turbulence", "leave it out: patterns are not disturbed"},
    {"ultra_wide_angle", "use perspective or orthographic"},
    {"warp", "leave it out: patterns are not disturbed"},
    {"waves", bumps},
    {"wood", patterns},
    {"wrinkles", bumps},
};

} // namespace

std::span<const std::string_view> reserved_words() {
    return words;
}

std::string_view word_advice(std::string_view spelling) {
    const auto found = std::ranges::find(advices, spelling, &Advice::word);
    return found == std::end(advices) ? std::string_view() : found->advice;
}

} // namespace proxima
