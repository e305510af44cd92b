// SPDX-License-Identifier: Apache-2.0
// Builds a SceneProgram: takes objects and surfaces one by one, stores equal surfaces once, and gathers what moves.
#pragma once
#include "parser/motion_shapes.h"
#include "parser/moving_table.h"
#include "parser/scene_program.h"
#include "parser/token.h"
#include "parser/value.h"

#include <span>
#include <vector>

namespace proxima {

/// A pigment with its map from the world, as the evaluator changes it.
struct PigmentValue {
    Moving<Pigment> pigment;
    Affine<Varying> pattern_from_world{Mat3<Varying>(1.0), Vec3<Varying>(0.0)}; ///< of patterns
    Moving<Pattern> pattern;                                                    ///< of those with a colour map
};

class SceneBuilder {
public:
    explicit SceneBuilder(MotionGraph& graph);

    SceneProgram& program() { return program_; }

    uint32_t add_pigment(const PigmentValue& value);
    ColorMapRef add_color_map(std::span<const Moving<ColorStop>> stops);
    uint32_t add_finish(const Moving<Finish>& finish) { return finishes_.add(program_.finishes, finish); }
    uint32_t add_interior(const Moving<Interior>& interior) { return interiors_.add(program_.interiors, interior); }
    /// Layers from the lowest to the top one.
    uint32_t add_texture(std::span<const Layer> layers);

    PigmentValue pigment(uint32_t index) const;
    bool has_pigment_map(const Pattern& pattern) const;
    /// How deep pigment maps stand in each other in a pigment; 0 without one.
    int map_depth(uint32_t pigment) const;
    Moving<Finish> finish(uint32_t index) const { return finishes_.get(program_.finishes, index); }
    Moving<Interior> interior(uint32_t index) const { return interiors_.get(program_.interiors, index); }
    std::vector<Layer> texture(uint32_t index) const;

    /// The pigment or texture moved with its object.
    uint32_t transform_pigment(uint32_t index, const Transform& transform);
    uint32_t transform_texture(uint32_t index, const Transform& transform);

    /// A surface without a texture wears `default_texture`.
    uint32_t material(const Surface& surface, uint32_t default_texture);

    void reserve_spheres(size_t count);
    /// A sphere whose surface is a texture or nothing; with the nodes of its centre and radius.
    void add_sphere(const Sphere<double>& sphere, const PartNodes& nodes, const Surface& surface,
                    uint32_t default_texture);
    /// False if a part of it has numbers that are not finite, as its transforms left them.
    [[nodiscard]] bool add_shape(const Shape& shape, uint32_t default_texture);
    void set_camera(const Camera<Varying>& camera);
    void set_sky(const Moving<SkySphere>& sky);
    void add_fog(const Moving<Fog<double>>& fog);
    /// Sets a number or vector of the program that stands in none of its arrays.
    template <class Place, class Value> void set(Place& place, const Value& value) {
        scene_nodes_.put(static_cast<const SceneTables*>(&program_), place, value);
    }

    /// What moves became too long or too much for motion programs.
    bool motion_failed() const { return motion_failed_; }
    /// Marks the nodes that are still needed.
    void mark_nodes() const;
    /// With motion programs if the graph still records and nothing failed.
    SceneProgram finish_program();

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

    static constexpr size_t most_fields = 1'000'000; ///< a host evaluates them one by one

    bool patterned(uint32_t texture) const;
    std::span<const ColorStop> stops_of(const Pattern& pattern) const;
    void add_light(const LightSource& source);
    const LayerRange& layer_range(uint32_t texture);
    bool add_moving_sphere(const Sphere<Varying>& sphere, const MotionChain* chain, uint32_t material);
    void add_sphere_program(const Sphere<Varying>& sphere, uint32_t material);
    bool add_ellipsoid(const Affine<Varying>& map, uint32_t material);
    void add_field(const MotionField& field, NodeId node);
    void add_fields(MotionField::Table table, size_t index, const FieldNodes& nodes);
    void add_guards();

    MotionGraph& graph_;
    SceneProgram program_;
    std::vector<Texture> textures_;
    std::vector<LayerRange> layer_ranges_; // of textures_
    InternTable<Texture> texture_table_;
    MovingTable<Pigment> pigments_;
    MovingTable<Pattern> patterns_;
    MovingTable<Finish> finishes_;
    MovingTable<Interior> interiors_;
    MovingTable<Affine<double>> transforms_;
    InternTable<Material> materials_;
    uint32_t last_texture_ = Surface::none; // of add_sphere
    uint32_t last_material_ = 0;

    MotionShapes shapes_;
    std::vector<MotionField> fields_;
    FieldNodes scene_nodes_;
    FieldNodes camera_nodes_;
    bool motion_failed_ = false;
};

} // namespace proxima
