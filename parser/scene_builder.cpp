// SPDX-License-Identifier: Apache-2.0
#include "parser/scene_builder.h"

#include "parser/area_weights.h"
#include "parser/motion_compiler.h"
#include "parser/shape_transform.h"
#include "parser/surface_flags.h"

#include <algorithm>
#include <cmath>

namespace proxima {
namespace {

/// The transforms of a chain, the first one first.
std::vector<const MotionChain*> links_of(const MotionChain* chain) {
    std::vector<const MotionChain*> links;
    for (; chain; chain = chain->before.get())
        links.push_back(chain);
    std::reverse(links.begin(), links.end());
    return links;
}

Vec3<Varying> with_nodes(const Vec3<double>& v, NodeId nodes, const MotionGraph& graph) {
    if (!nodes)
        return Vec3<Varying>(v);
    return {{v.x, graph.term(nodes, 0)}, {v.y, graph.term(nodes, 1)}, {v.z, graph.term(nodes, 2)}};
}

} // namespace

SceneBuilder::SceneBuilder(MotionGraph& graph) : graph_(graph) {
    add_interior(Interior{});
} // interior 0 is everyone's default

uint32_t SceneBuilder::add_pigment(const PigmentValue& value) {
    Moving<Pigment> moving = value.pigment;
    Pigment& pigment = moving.record;
    pigment.transform = Pigment::no_transform;
    if (has_color_map(pigment.kind))
        pigment.pattern = patterns_.add(program_.patterns, value.pattern);
    if (pigment.kind != PigmentKind::solid) {
        const Affine<double> map = value_of(value.pattern_from_world), identity;
        if (moves(value.pattern_from_world)) {
            Moving<Affine<double>> transform;
            transform.set(transform.record, value.pattern_from_world);
            pigment.transform = transforms_.add(program_.transforms, transform);
        } else if (map.linear != identity.linear || map.offset != identity.offset) {
            pigment.transform = transforms_.add(program_.transforms, map);
        }
    }
    return pigments_.add(program_.pigments, moving);
}

PigmentValue SceneBuilder::pigment(uint32_t index) const {
    PigmentValue value;
    value.pigment = pigments_.get(program_.pigments, index);
    if (has_color_map(value.pigment->kind))
        value.pattern = patterns_.get(program_.patterns, value.pigment->pattern);
    if (const uint32_t place = value.pigment->transform; place != Pigment::no_transform) {
        const Moving<Affine<double>> transform = transforms_.get(program_.transforms, place);
        value.pattern_from_world = transform.get(transform.record);
    }
    return value;
}

std::span<const ColorStop> SceneBuilder::stops_of(const Pattern& pattern) const {
    return std::span(program_.color_stops).subspan(pattern.first_stop, pattern.stop_count);
}

bool SceneBuilder::has_pigment_map(const Pattern& pattern) const {
    return pattern.stop_count > 0 && stops_of(pattern)[0].pigment != ColorStop::no_pigment;
}

int SceneBuilder::map_depth(uint32_t index) const {
    const Pigment& pigment = program_.pigments[index];
    if (!has_color_map(pigment.kind) || !has_pigment_map(program_.patterns[pigment.pattern]))
        return 0;
    int depth = 0;
    for (const ColorStop& stop : stops_of(program_.patterns[pigment.pattern]))
        depth = std::max(depth, map_depth(stop.pigment));
    return depth + 1;
}

uint32_t SceneBuilder::add_texture(std::span<const Layer> layers) {
    uint32_t texture = Surface::none;
    for (const Layer& layer : layers)
        texture = texture_table_.intern(textures_, {texture, layer});
    return texture;
}

std::vector<Layer> SceneBuilder::texture(uint32_t index) const {
    std::vector<Layer> layers;
    for (; index != Surface::none; index = textures_[index].below)
        layers.push_back(textures_[index].top);
    std::reverse(layers.begin(), layers.end());
    return layers;
}

bool SceneBuilder::patterned(uint32_t texture) const {
    for (; texture != Surface::none; texture = textures_[texture].below)
        if (program_.pigments[textures_[texture].top.pigment].kind != PigmentKind::solid)
            return true;
    return false;
}

uint32_t SceneBuilder::transform_pigment(uint32_t index, const Transform& transform) {
    if (program_.pigments[index].kind == PigmentKind::solid || transform.is_identity)
        return index;
    PigmentValue value = pigment(index);
    value.pattern_from_world = compose(value.pattern_from_world, transform.with_nodes().inverse);
    return add_pigment(value);
}

uint32_t SceneBuilder::transform_texture(uint32_t index, const Transform& transform) {
    if (!patterned(index))
        return index;
    std::vector<Layer> layers = texture(index);
    for (Layer& layer : layers)
        layer.pigment = transform_pigment(layer.pigment, transform);
    return add_texture(layers);
}

const SceneBuilder::LayerRange& SceneBuilder::layer_range(uint32_t index) {
    layer_ranges_.resize(std::max(layer_ranges_.size(), textures_.size()));
    LayerRange& range = layer_ranges_[index];
    if (range.first != Surface::none)
        return range;
    const std::vector<Layer> layers = texture(index);
    range.first = uint32_t(program_.layers.size());
    range.count = uint32_t(layers.size());
    range.flags = surface_flags(program_, layers);
    program_.layers.insert(program_.layers.end(), layers.begin(), layers.end());
    return range;
}

uint32_t SceneBuilder::material(const Surface& surface, uint32_t default_texture) {
    const LayerRange& range = layer_range(surface.texture == Surface::none ? default_texture : surface.texture);
    Material material;
    material.first_layer = range.first;
    material.layer_count = range.count;
    material.interior = surface.interior == Surface::none ? 0 : surface.interior;
    material.flags = range.flags | surface.flags;
    return materials_.intern(program_.materials, material);
}

ColorMapRef SceneBuilder::add_color_map(std::span<const Moving<ColorStop>> stops) {
    const ColorMapRef map{uint32_t(program_.color_stops.size()), uint32_t(stops.size())};
    for (const Moving<ColorStop>& stop : stops) {
        add_fields(MotionField::Table::color_stops, program_.color_stops.size(), stop.nodes);
        program_.color_stops.push_back(stop.record);
    }
    return map;
}

void SceneBuilder::add_light(const LightSource& source) {
    Moving<Light<double>> light = source.light;
    const Vec3<Varying> way = light.get(light->point_at) - light.get(light->position);
    const Varying length = glm::length(way);
    if (decide(apply(MotionOp::greater, length, 0)))
        light.set(light.record.direction, way / length);
    if (source.area) {
        AreaLight<double> area = source.area->record;
        area.first_sample = uint32_t(program_.area_samples.size());
        if (area.adaptive == AreaLight<double>::every_place)
            append_area_samples(program_.area_samples, area.columns, area.rows);
        area.sample_count = uint32_t(program_.area_samples.size()) - area.first_sample;
        light.record.area = uint32_t(program_.area_lights.size());
        add_fields(MotionField::Table::area_lights, program_.area_lights.size(), source.area->nodes);
        program_.area_lights.push_back(area);
    }
    add_fields(MotionField::Table::lights, program_.lights.size(), light.nodes);
    program_.lights.push_back(light.record);
}

void SceneBuilder::set_camera(const Camera<Varying>& camera) {
    Moving<Camera<double>> moving;
    moving.record.kind = camera.kind;
    moving.set(moving.record.location, camera.location);
    moving.set(moving.record.direction, camera.direction);
    moving.set(moving.record.right, camera.right);
    moving.set(moving.record.up, camera.up);
    program_.camera = moving.record;
    camera_nodes_ = moving.nodes;
}

void SceneBuilder::set_sky(const Moving<SkySphere>& sky) {
    program_.sky = sky.record;
    for (int i = 0; i < 3; ++i) {
        const NodeId node = sky.nodes.at(offset_of(&sky.record, &sky.record.emission[i]));
        set(program_.sky.emission[i], Varying(double(sky->emission[i]), node));
    }
}

void SceneBuilder::add_fog(const Moving<Fog<double>>& fog) {
    add_fields(MotionField::Table::fogs, program_.fogs.size(), fog.nodes);
    program_.fogs.push_back(fog.record);
}

void SceneBuilder::reserve_spheres(size_t count) {
    program_.spheres.reserve(count);
    program_.sphere_materials.reserve(count);
}

void SceneBuilder::add_sphere(const Sphere<double>& sphere, const PartNodes& nodes, const Surface& surface,
                              uint32_t default_texture) {
    const uint32_t texture = surface.texture == Surface::none ? default_texture : surface.texture;
    if (texture != last_texture_) {
        last_texture_ = texture;
        last_material_ = material({.texture = texture}, default_texture);
    }
    if ((nodes.vector | nodes.number) != 0)
        return add_sphere_program({with_nodes(sphere.center, nodes.vector, graph_), {sphere.radius, nodes.number}},
                                  last_material_);
    program_.spheres.push_back(sphere);
    program_.sphere_materials.push_back(last_material_);
}

void SceneBuilder::add_sphere_program(const Sphere<Varying>& sphere, uint32_t material) {
    const Varying results[] = {sphere.center.x, sphere.center.y, sphere.center.z, sphere.radius};
    if (graph_.records() && !motion_failed_ && (moves(sphere.center) || sphere.radius.node))
        motion_failed_ = !shapes_.add(graph_, MotionTarget::sphere, uint32_t(program_.spheres.size()), results);
    program_.spheres.push_back({value_of(sphere.center), sphere.radius.value});
    program_.sphere_materials.push_back(material);
}

/// A sphere at the end of its transforms: a sphere, or an ellipsoid from the first one on that squeezes it. False if it
/// has numbers that are not finite now.
bool SceneBuilder::add_moving_sphere(const Sphere<Varying>& sphere, const MotionChain* chain, uint32_t material) {
    Sphere<Varying> moved = sphere;
    bool round = true;
    Affine<Varying> map;
    for (const MotionChain* link : links_of(chain)) {
        const Affine<Varying> step = link->transform.with_nodes().map;
        if (round && link->keeps_spheres) {
            moved = {step.point(moved.center), moved.radius * glm::length(step.linear[0])};
            continue;
        }
        map = compose(step, round ? unit_sphere_map(moved) : map);
        round = false;
    }
    if (!round)
        return add_ellipsoid(map, material);
    add_sphere_program(moved, material);
    return is_finite(program_.spheres.back());
}

bool SceneBuilder::add_ellipsoid(const Affine<Varying>& map, uint32_t material) {
    const Mat3<Varying> inverse = glm::inverse(map.linear);
    Moving<Ellipsoid<double>> ellipsoid;
    ellipsoid.set(ellipsoid.record.object_from_world, Affine<Varying>{inverse, -(inverse * map.offset)});
    ellipsoid.set(ellipsoid.record.world_from_object, map);
    ellipsoid.record.material = material;
    add_fields(MotionField::Table::ellipsoids, program_.ellipsoids.size(), ellipsoid.nodes);
    program_.ellipsoids.push_back(ellipsoid.record);
    return is_finite(ellipsoid->world_from_object) && is_finite(ellipsoid->object_from_world);
}

bool SceneBuilder::add_shape(const Shape& shape, uint32_t default_texture) {
    const auto chain_of = [&](const auto& part) {
        return part.chain == part.still ? nullptr : shape.chains[part.chain].get();
    };
    bool finite = true;
    PartNodesReader sphere_nodes(shape.moving_spheres), plane_nodes(shape.moving_planes);
    for (size_t i = 0; i < shape.spheres.size(); ++i) {
        const auto& part = shape.spheres[i];
        const uint32_t material = this->material(part.surface, default_texture);
        const PartNodes nodes = sphere_nodes.of(i);
        const MotionChain* const chain = chain_of(part);
        if (!chain && (nodes.vector | nodes.number) == 0) {
            program_.spheres.push_back(part.geometry);
            program_.sphere_materials.push_back(material);
            finite = finite && is_finite(part.geometry);
            continue;
        }
        const MotionGraph::Scratch scratch(graph_);
        finite &= add_moving_sphere(
            {with_nodes(part.geometry.center, nodes.vector, graph_), {part.geometry.radius, nodes.number}}, chain,
            material);
    }
    for (const auto& part : shape.ellipsoids) {
        const uint32_t material = this->material(part.surface, default_texture);
        const MotionGraph::Scratch scratch(graph_);
        Affine<Varying> map = varying(part.geometry);
        for (const MotionChain* link : links_of(chain_of(part)))
            map = compose(link->transform.with_nodes().map, map);
        finite &= add_ellipsoid(map, material);
    }
    for (size_t i = 0; i < shape.planes.size(); ++i) {
        const auto& part = shape.planes[i];
        const MotionGraph::Scratch scratch(graph_);
        const PartNodes nodes = plane_nodes.of(i);
        Plane<Varying> plane{with_nodes(part.geometry.normal, nodes.vector, graph_),
                             {part.geometry.distance, nodes.number}};
        for (const MotionChain* link : links_of(chain_of(part)))
            plane = moved(plane, link->transform.with_nodes().inverse);
        Moving<Plane<double>> record;
        record.set(record.record.normal, plane.normal);
        record.set(record.record.distance, plane.distance);
        record.record.material = material(part.surface, default_texture);
        add_fields(MotionField::Table::planes, program_.planes.size(), record.nodes);
        program_.planes.push_back(record.record);
        finite = finite && is_finite(record->normal) && std::isfinite(record->distance);
    }
    for (const LightSource& light : shape.lights)
        add_light(light);
    return finite;
}

void SceneBuilder::add_field(const MotionField& field, NodeId node) {
    if (!graph_.records() || motion_failed_ || !node)
        return;
    const Varying result[] = {{0, node}};
    motion_failed_ =
        fields_.size() >= most_fields || !shapes_.add(graph_, MotionTarget::number, uint32_t(fields_.size()), result);
    fields_.push_back(field);
}

void SceneBuilder::add_fields(MotionField::Table table, size_t index, const FieldNodes& nodes) {
    for (const FieldNode& node : nodes)
        add_field({table, node.type, uint32_t(index), node.offset}, node.node);
}

/// A guard is finite as long as its condition holds.
void SceneBuilder::add_guards() {
    for (const NodeId guard : graph_.guards()) {
        const MotionGraph::Scratch scratch(graph_);
        add_field({MotionField::Table::guard, MotionField::Type::float64, 0, 0},
                  graph_.operation(MotionOp::divide, 1, {0, guard}));
    }
}

void SceneBuilder::mark_nodes() const {
    pigments_.mark(graph_);
    patterns_.mark(graph_);
    finishes_.mark(graph_);
    interiors_.mark(graph_);
    transforms_.mark(graph_);
    scene_nodes_.mark(graph_);
    camera_nodes_.mark(graph_);
}

SceneProgram SceneBuilder::finish_program() {
    using Table = MotionField::Table;
    const auto add_table = [&](Table table, const auto& records) {
        for (const auto& [index, nodes] : records.moving())
            add_fields(table, index, nodes);
    };
    add_table(Table::pigments, pigments_);
    add_table(Table::patterns, patterns_);
    add_table(Table::finishes, finishes_);
    add_table(Table::interiors, interiors_);
    add_table(Table::transforms, transforms_);
    add_fields(Table::camera, 0, camera_nodes_);
    add_fields(Table::scene, 0, scene_nodes_);
    add_guards();
    for (const MotionShape& shape : shapes_.all())
        motion_failed_ = motion_failed_ || !compile(shape, program_.motion);
    program_.motion.fields = std::move(fields_);
    program_.motion.splines = std::move(graph_.splines());
    if (motion_failed_ || !graph_.records())
        program_.motion = {};
    return std::move(program_);
}

} // namespace proxima
