// SPDX-License-Identifier: Apache-2.0
// The reserved words of POV-Ray 3.7's scene language. Those that Proxima understands have a name here; the others are
// known too, because no identifier may be spelled like them, and are refused with advice (word_advice).
#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace proxima {

// clang-format off
// X(enumerator, spelling). An enumerator ends in _ where its spelling is a word of C++.
#define PROXIMA_WORDS(X) \
    /* objects and items */ \
    X(sphere, "sphere") X(plane, "plane") X(union_, "union") X(light_source, "light_source") \
    X(object, "object") X(camera, "camera") X(background, "background") X(sky_sphere, "sky_sphere") X(fog, "fog") \
    X(global_settings, "global_settings") \
    /* surfaces */ \
    X(texture, "texture") X(pigment, "pigment") X(finish, "finish") X(interior, "interior") \
    X(material, "material") X(checker, "checker") X(quick_color, "quick_color") X(quick_colour, "quick_colour") \
    X(ambient, "ambient") X(diffuse, "diffuse") X(albedo, "albedo") X(emission, "emission") \
    X(brilliance, "brilliance") X(phong, "phong") X(phong_size, "phong_size") X(specular, "specular") \
    X(roughness, "roughness") X(metallic, "metallic") X(reflection, "reflection") \
    X(reflection_exponent, "reflection_exponent") X(exponent, "exponent") X(falloff, "falloff") \
    X(fresnel, "fresnel") X(conserve_energy, "conserve_energy") X(ior, "ior") X(fade_distance, "fade_distance") \
    X(fade_power, "fade_power") X(fade_color, "fade_color") X(fade_colour, "fade_colour") X(crand, "crand") \
    X(caustics, "caustics") \
    /* patterns, then what stands in a pigment that has one */ \
    X(gradient, "gradient") X(radial, "radial") X(spherical, "spherical") X(planar, "planar") \
    X(cylindrical, "cylindrical") X(boxed, "boxed") X(onion, "onion") X(leopard, "leopard") \
    X(color_map, "color_map") X(colour_map, "colour_map") X(pigment_map, "pigment_map") X(frequency, "frequency") X(phase, "phase") \
    X(ramp_wave, "ramp_wave") X(sine_wave, "sine_wave") X(triangle_wave, "triangle_wave") \
    X(scallop_wave, "scallop_wave") X(cubic_wave, "cubic_wave") X(poly_wave, "poly_wave") \
    /* object modifiers */ \
    X(no_shadow, "no_shadow") X(no_image, "no_image") X(no_reflection, "no_reflection") \
    X(double_illuminate, "double_illuminate") X(hollow, "hollow") X(split_union, "split_union") X(translate, "translate") \
    X(rotate, "rotate") X(scale, "scale") X(matrix, "matrix") X(transform, "transform") X(inverse, "inverse") \
    /* camera and lights */ \
    X(location, "location") X(look_at, "look_at") X(angle, "angle") X(right, "right") X(up, "up") X(sky, "sky") \
    X(direction, "direction") X(perspective, "perspective") X(orthographic, "orthographic") \
    X(shadowless, "shadowless") X(spotlight, "spotlight") X(cylinder, "cylinder") X(parallel, "parallel") \
    X(point_at, "point_at") X(radius, "radius") X(tightness, "tightness") X(area_light, "area_light") \
    X(adaptive, "adaptive") X(circular, "circular") X(orient, "orient") X(jitter, "jitter") \
    X(looks_like, "looks_like") X(media_attenuation, "media_attenuation") X(media_interaction, "media_interaction") \
    /* fog */ \
    X(fog_type, "fog_type") X(fog_offset, "fog_offset") X(fog_alt, "fog_alt") X(distance, "distance") \
    /* global settings */ \
    X(assumed_gamma, "assumed_gamma") X(ambient_light, "ambient_light") X(max_trace_level, "max_trace_level") \
    X(adc_bailout, "adc_bailout") X(charset, "charset") X(max_intersections, "max_intersections") \
    X(number_of_waves, "number_of_waves") X(noise_generator, "noise_generator") X(mm_per_unit, "mm_per_unit") \
    X(ascii, "ascii") X(utf8, "utf8") \
    /* values */ \
    X(array, "array") X(append, "append") X(function, "function") X(spline, "spline") \
    X(linear_spline, "linear_spline") X(quadratic_spline, "quadratic_spline") X(cubic_spline, "cubic_spline") \
    X(natural_spline, "natural_spline") \
    /* colours */ \
    X(color, "color") X(colour, "colour") X(rgb, "rgb") X(rgbf, "rgbf") X(rgbt, "rgbt") X(rgbft, "rgbft") \
    X(srgb, "srgb") X(srgbf, "srgbf") X(srgbt, "srgbt") X(srgbft, "srgbft") X(red, "red") X(green, "green") \
    X(blue, "blue") X(filter, "filter") X(transmit, "transmit") X(gray, "gray") \
    /* numbers, and functions that give numbers and vectors: from x to val */ \
    X(x, "x") X(y, "y") X(z, "z") X(t, "t") X(u, "u") X(v, "v") X(pi, "pi") X(clock, "clock") \
    X(clock_on, "clock_on") X(now, "now") X(version, "version") X(true_, "true") X(false_, "false") \
    X(yes, "yes") X(no, "no") X(on, "on") X(off, "off") X(abs, "abs") X(acos, "acos") X(acosh, "acosh") \
    X(asin, "asin") X(asinh, "asinh") X(atan, "atan") X(atan2, "atan2") X(atanh, "atanh") X(ceil, "ceil") \
    X(cos, "cos") X(cosh, "cosh") X(degrees, "degrees") X(div, "div") X(exp, "exp") X(floor, "floor") \
    X(int_, "int") X(ln, "ln") X(log, "log") X(max, "max") X(min, "min") X(mod, "mod") X(pow, "pow") \
    X(radians, "radians") X(rand, "rand") X(seed, "seed") X(select, "select") X(sin, "sin") X(sinh, "sinh") \
    X(sqrt, "sqrt") X(tan, "tan") X(tanh, "tanh") X(bitwise_and, "bitwise_and") \
    X(bitwise_or, "bitwise_or") X(bitwise_xor, "bitwise_xor") X(defined, "defined") X(dimensions, "dimensions") X(dimension_size, "dimension_size") X(vdot, "vdot") \
    X(vlength, "vlength") X(vcross, "vcross") X(vnormalize, "vnormalize") X(vrotate, "vrotate") \
    X(vaxis_rotate, "vaxis_rotate") X(asc, "asc") X(strcmp, "strcmp") X(strlen, "strlen") X(file_exists, "file_exists") X(val, "val") \
    /* functions that give strings: from str to strlwr */ \
    X(str, "str") X(vstr, "vstr") X(concat, "concat") X(chr, "chr") X(substr, "substr") X(strupr, "strupr") \
    X(strlwr, "strlwr") \
    /* directives that are reserved words too */ \
    X(break_, "break") X(case_, "case") X(debug, "debug") X(declare, "declare") X(default_, "default") \
    X(else_, "else") X(elseif, "elseif") X(end, "end") X(error, "error") X(fclose, "fclose") X(fopen, "fopen") \
    X(for_, "for") X(if_, "if") X(ifdef, "ifdef") X(ifndef, "ifndef") X(include, "include") X(local, "local") \
    X(macro, "macro") X(range, "range") X(read, "read") X(render, "render") X(statistics, "statistics") \
    X(switch_, "switch") X(undef, "undef") X(warning, "warning") X(while_, "while") X(write, "write")
// clang-format on

/// The words with a meaning in Proxima, numbered from 0.
enum class Word : uint16_t {
#define PROXIMA_ENUMERATOR(name, spelling) name,
    PROXIMA_WORDS(PROXIMA_ENUMERATOR)
#undef PROXIMA_ENUMERATOR
        first_unsupported, ///< this and all words after it are only refused
};

/// Every reserved word's spelling, in the order of its number.
std::span<const std::string_view> reserved_words();

/// What to use instead of a word that Proxima does not have, or "".
std::string_view word_advice(std::string_view spelling);

} // namespace proxima
