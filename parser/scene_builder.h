// SPDX-License-Identifier: Apache-2.0
// Builds a SceneProgram: takes objects and surfaces one by one, stores equal surfaces once.
#pragma once
#include "parser/intern_table.h"
#include "parser/scene_program.h"
#include "parser/token.h"
#include "parser/value.h"

#include <span>
#include <vector>

namespace proxima {

/// A pigment with its map from the world, as the evaluator changes it.
struct PigmentValue {
    Pigment pigment;
    Affine<double> pattern_from_world; ///< of patterns
    Pattern pattern;                   ///< of those with a colour map
};

class SceneBuilder {
public:
    SceneBuilder();

    SceneProgram& program() { return program_; }

    uint32_t add_pigment(const PigmentValue& value);
    ColorMapRef add_color_map(std::span<const ColorStop> stops);
    uint32_t add_finish(const Finish& finish) { return finishes_.intern(program_.finishes, finish); }
    uint32_t add_interior(const Interior& interior) { return interiors_.intern(program_.interiors, interior); }
    /// Layers from the lowest to the top one.
    uint32_t add_texture(std::span<const Layer> layers);

    PigmentValue pigment(uint32_t index) const;
    bool has_pigment_map(const Pattern& pattern) const;
    /// How deep pigment maps stand in each other in a pigment; 0 without one.
    int map_depth(uint32_t pigment) const;
    const Finish& finish(uint32_t index) const { return program_.finishes[index]; }
    const Interior& interior(uint32_t index) const { return program_.interiors[index]; }
    std::vector<Layer> texture(uint32_t index) const;

    /// The pigment or texture moved with its object; `inverse` maps the moved world back.
    uint32_t transform_pigment(uint32_t index, const Affine<double>& inverse);
    uint32_t transform_texture(uint32_t index, const Affine<double>& inverse);

    /// A surface without a texture wears `default_texture`.
    uint32_t material(const Surface& surface, uint32_t default_texture);

    void reserve_spheres(size_t count);
    /// A sphere whose surface is a texture or nothing.
    void add_sphere(const Sphere<double>& sphere, const Surface& surface, uint32_t default_texture);
    void add_shape(const Shape& shape, uint32_t default_texture);

    SceneProgram finish_program() { return std::move(program_); }

private:
    /// A texture is a layer over another texture, or over nothing: so equal ones are found whatever their height.
    struct Texture {
        uint32_t below;
        Layer top;
    };
    /// Where the layers of a texture that is in use stand in the program.
    struct LayerRange {
        uint32_t first = Surface::none;
        uint32_t count = 0;
        uint32_t flags = 0;
    };

    bool patterned(uint32_t texture) const;
    bool lets_light_through(const Pigment& pigment) const;
    std::span<const ColorStop> stops_of(const Pattern& pattern) const;
    void add_light(const LightSource& source);
    const LayerRange& layer_range(uint32_t texture);

    SceneProgram program_;
    std::vector<Texture> textures_;
    std::vector<LayerRange> layer_ranges_; // of textures_
    InternTable<Texture> texture_table_;
    InternTable<Pigment> pigments_;
    InternTable<Pattern> patterns_;
    InternTable<Finish> finishes_;
    InternTable<Interior> interiors_;
    InternTable<Material> materials_;
    InternTable<Affine<double>> transforms_;
    uint32_t last_texture_ = Surface::none; // of add_sphere
    uint32_t last_material_ = 0;
};

/// Maps a shape, with its textures, forward by `map`; `inverse` is its inverse.
void transform_shape(Shape& shape, const Affine<double>& map, const Affine<double>& inverse, SceneBuilder& builder);

} // namespace proxima
