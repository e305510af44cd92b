// SPDX-License-Identifier: Apache-2.0
// Surfaces as POV-Ray 3.7 defines them, in the form that the kernels read: small float records that refer to each
// other by index. A material is a stack of layers over an interior; a layer is a pigment with a finish.
// All colours are in the scene's working space (linear Rec.709 when assumed_gamma is 1).
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// A colour as a pigment has it. `filter` lets light through tinted, `transmit` untinted; both in [0, 1] normally.
struct PigmentColor {
    glm::vec3 rgb{0.0f};
    float filter = 0.0f;
    float transmit = 0.0f;
};

enum class PigmentKind : uint32_t {
    solid,
    checker,
    // These make a number of a point, for a colour map. POV-Ray's gradient along an axis is the one along x of a space
    // in which x is that axis.
    gradient,
    radial,
    spherical,
    planar,
    cylindrical,
    boxed,
    onion,
    leopard,
};

constexpr bool has_color_map(PigmentKind kind) {
    return kind >= PigmentKind::gradient;
}

enum class Wave : uint32_t { ramp, sine, triangle, scallop, cubic, poly };

/// How a pattern's number becomes a place in its colour map: stops [first_stop, first_stop + stop_count).
struct Pattern {
    Wave wave = Wave::ramp;
    float frequency = 1.0f;
    float phase = 0.0f;
    float exponent = 1.0f; ///< of Wave::poly
    uint32_t first_stop = 0;
    uint32_t stop_count = 0;
};

/// A colour map is a list of these, by rising value; colours in between are mixed. A pigment map's have pigments, which
/// are evaluated at the point of the pattern's space.
struct ColorStop {
    static constexpr uint32_t no_pigment = 0xffffffffu;

    float value = 0.0f;
    PigmentColor color;
    uint32_t pigment = no_pigment; ///< in place of the colour
};

inline constexpr int pigment_map_depth = 2; ///< of pigment maps in each other

/// A colour, a pattern of two, or a pattern with a colour map. Patterns are evaluated at `transforms[transform]`
/// applied to the hit point (the map world -> pattern space).
struct Pigment {
    static constexpr uint32_t no_transform = 0xffffffffu;

    PigmentKind kind = PigmentKind::solid;
    uint32_t transform = no_transform;
    uint32_t pattern = 0;        ///< index of its Pattern, when it has a colour map
    PigmentColor color{};        ///< the colour, or the pattern's first one
    PigmentColor second_color{}; ///< the checker's second colour
};

/// How a surface reflects. Defaults are POV-Ray's. Albedo spellings are already folded into the amounts.
struct Finish {
    glm::vec3 ambient{0.1f};
    glm::vec3 emission{0.0f};
    float diffuse = 0.6f;
    float brilliance = 1.0f;
    float phong = 0.0f;
    float phong_size = 40.0f;
    float specular = 0.0f;
    float inverse_roughness = 20.0f; ///< 1 / roughness
    float metallic = 0.0f;
    glm::vec3 reflection_min{0.0f};
    glm::vec3 reflection_max{0.0f};
    float reflection_falloff = 1.0f;
    float reflection_exponent = 1.0f;
    float reflection_metallic = 0.0f;
    uint32_t fresnel = 0;         ///< boolean: reflection by the Fresnel equation
    uint32_t conserve_energy = 0; ///< boolean
};

/// What is inside an object. Light in it fades by distance when both fade_power and fade_distance are positive.
struct Interior {
    float ior = 1.0f;
    float fade_distance = 0.0f;
    float fade_power = 0.0f;
    glm::vec3 fade_color{0.0f};
};

struct Layer {
    uint32_t pigment = 0;
    uint32_t finish = 0;
};

/// Bits of Material::flags.
enum MaterialFlag : uint32_t {
    material_transparent = 1u << 0, ///< some pigment of it has filter or transmit other than 0
    material_reflective = 1u << 1,  ///< some finish of it has a reflection other than 0
    material_no_shadow = 1u << 2,
    material_no_image = 1u << 3,      ///< seen by no ray from the camera, bent or not
    material_no_reflection = 1u << 4, ///< seen by no ray that was mirrored
    material_double_illuminate = 1u << 5,
    material_hollow = 1u << 6, ///< fog is inside too
};

/// The layers [first_layer, first_layer + layer_count) from the lowest to the top one, and what is inside.
struct Material {
    uint32_t first_layer = 0;
    uint32_t layer_count = 1;
    uint32_t interior = 0;
    uint32_t flags = 0;
};

} // namespace proxima
