// SPDX-License-Identifier: Apache-2.0
#include "parser/scene_builder.h"

#include "parser/affine_math.h"
#include "parser/area_weights.h"

#include <algorithm>
#include <cmath>

namespace proxima {
namespace {

bool nonzero(const glm::vec3& v) {
    return v.x != 0 || v.y != 0 || v.z != 0;
}

bool is_transparent(const PigmentColor& color) {
    return color.filter != 0 || color.transmit != 0;
}

/// Whether a map keeps spheres spheres; then `factor` is what it does to lengths.
bool is_similarity(const Affine<double>& map, double& factor) {
    const Mat3<double>& m = map.linear;
    const double xx = glm::dot(m[0], m[0]), yy = glm::dot(m[1], m[1]), zz = glm::dot(m[2], m[2]);
    const double slack = 1e-12 * xx;
    factor = std::sqrt(xx);
    return std::abs(xx - yy) <= slack && std::abs(xx - zz) <= slack && std::abs(glm::dot(m[0], m[1])) <= slack &&
           std::abs(glm::dot(m[0], m[2])) <= slack && std::abs(glm::dot(m[1], m[2])) <= slack;
}

Affine<double> unit_sphere_map(const Sphere<double>& sphere) {
    return {Mat3<double>(sphere.radius), sphere.center};
}

} // namespace

SceneBuilder::SceneBuilder() {
    add_interior(Interior{});
} // interior 0 is everyone's default

uint32_t SceneBuilder::add_pigment(const PigmentValue& value) {
    Pigment pigment = value.pigment;
    pigment.transform = Pigment::no_transform;
    if (has_color_map(pigment.kind))
        pigment.pattern = patterns_.intern(program_.patterns, value.pattern);
    const Affine<double> identity;
    if (pigment.kind != PigmentKind::solid &&
        (value.pattern_from_world.linear != identity.linear || value.pattern_from_world.offset != identity.offset))
        pigment.transform = transforms_.intern(program_.transforms, value.pattern_from_world);
    return pigments_.intern(program_.pigments, pigment);
}

PigmentValue SceneBuilder::pigment(uint32_t index) const {
    PigmentValue value{program_.pigments[index], {}, {}};
    if (has_color_map(value.pigment.kind))
        value.pattern = program_.patterns[value.pigment.pattern];
    if (value.pigment.transform != Pigment::no_transform)
        value.pattern_from_world = program_.transforms[value.pigment.transform];
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

uint32_t SceneBuilder::transform_pigment(uint32_t index, const Affine<double>& inverse) {
    if (program_.pigments[index].kind == PigmentKind::solid)
        return index;
    PigmentValue value = pigment(index);
    value.pattern_from_world = compose(value.pattern_from_world, inverse);
    return add_pigment(value);
}

uint32_t SceneBuilder::transform_texture(uint32_t index, const Affine<double>& inverse) {
    if (!patterned(index))
        return index;
    std::vector<Layer> layers = texture(index);
    for (Layer& layer : layers)
        layer.pigment = transform_pigment(layer.pigment, inverse);
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
    for (const Layer& layer : layers) {
        const Pigment& pigment = program_.pigments[layer.pigment];
        const Finish& finish = program_.finishes[layer.finish];
        if (lets_light_through(pigment))
            range.flags |= material_transparent;
        if (nonzero(finish.reflection_min) || nonzero(finish.reflection_max))
            range.flags |= material_reflective;
    }
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

bool SceneBuilder::lets_light_through(const Pigment& pigment) const {
    if (pigment.kind == PigmentKind::solid)
        return is_transparent(pigment.color);
    if (pigment.kind == PigmentKind::checker)
        return is_transparent(pigment.color) || is_transparent(pigment.second_color);
    return std::ranges::any_of(stops_of(program_.patterns[pigment.pattern]), [&](const ColorStop& stop) {
        return stop.pigment == ColorStop::no_pigment ? is_transparent(stop.color)
                                                     : lets_light_through(program_.pigments[stop.pigment]);
    });
}

ColorMapRef SceneBuilder::add_color_map(std::span<const ColorStop> stops) {
    const ColorMapRef map{uint32_t(program_.color_stops.size()), uint32_t(stops.size())};
    program_.color_stops.insert(program_.color_stops.end(), stops.begin(), stops.end());
    return map;
}

void SceneBuilder::add_light(const LightSource& source) {
    Light<double> light = source.light;
    const Vec3<double> way = light.point_at - light.position;
    if (const double length = glm::length(way); length > 0)
        light.direction = way / length;
    if (source.area) {
        AreaLight<double> area = *source.area;
        area.first_sample = uint32_t(program_.area_samples.size());
        if (area.adaptive == AreaLight<double>::every_place)
            append_area_samples(program_.area_samples, area.columns, area.rows);
        area.sample_count = uint32_t(program_.area_samples.size()) - area.first_sample;
        light.area = uint32_t(program_.area_lights.size());
        program_.area_lights.push_back(area);
    }
    program_.lights.push_back(light);
}

void SceneBuilder::reserve_spheres(size_t count) {
    program_.spheres.reserve(count);
    program_.sphere_materials.reserve(count);
}

void SceneBuilder::add_sphere(const Sphere<double>& sphere, const Surface& surface, uint32_t default_texture) {
    const uint32_t texture = surface.texture == Surface::none ? default_texture : surface.texture;
    if (texture != last_texture_) {
        last_texture_ = texture;
        last_material_ = material({.texture = texture}, default_texture);
    }
    program_.spheres.push_back(sphere);
    program_.sphere_materials.push_back(last_material_);
}

void SceneBuilder::add_shape(const Shape& shape, uint32_t default_texture) {
    for (const auto& [sphere, surface] : shape.spheres) {
        program_.spheres.push_back(sphere);
        program_.sphere_materials.push_back(material(surface, default_texture));
    }
    for (const auto& [map, surface] : shape.ellipsoids) {
        const Mat3<double> inverse = glm::inverse(map.linear);
        program_.ellipsoids.push_back({{inverse, -(inverse * map.offset)}, map, material(surface, default_texture)});
    }
    for (const auto& [plane, surface] : shape.planes)
        program_.planes.push_back({plane.normal, plane.distance, material(surface, default_texture)});
    for (const LightSource& light : shape.lights)
        add_light(light);
}

void transform_shape(Shape& shape, const Affine<double>& map, const Affine<double>& inverse, SceneBuilder& builder) {
    const auto move_surface = [&](Surface& surface) {
        if (surface.texture != Surface::none)
            surface.texture = builder.transform_texture(surface.texture, inverse);
    };
    for (auto& [ellipsoid, surface] : shape.ellipsoids) {
        ellipsoid = compose(map, ellipsoid);
        move_surface(surface);
    }
    for (auto& [plane, surface] : shape.planes) {
        // dot(n, q) = d with q = inverse(p): the normal goes back through the transposed inverse.
        const Vec3<double> normal = inverse.normal_to_source(plane.normal);
        const double length = glm::length(normal);
        plane.distance = (plane.distance - glm::dot(plane.normal, inverse.offset)) / length;
        plane.normal = normal / length;
        move_surface(surface);
    }
    move_surface(shape.own);
    for (LightSource& source : shape.lights) {
        source.light.position = map.point(source.light.position);
        source.light.point_at = map.point(source.light.point_at);
        if (source.area) {
            source.area->axis1 = map.direction(source.area->axis1);
            source.area->axis2 = map.direction(source.area->axis2);
        }
    }
    double factor = 1;
    const bool similarity = is_similarity(map, factor);
    for (auto& [sphere, surface] : shape.spheres) {
        move_surface(surface);
        if (similarity)
            sphere = {map.point(sphere.center), sphere.radius * factor};
        else
            shape.ellipsoids.push_back({compose(map, unit_sphere_map(sphere)), surface});
    }
    if (!similarity)
        shape.spheres.clear();
}

} // namespace proxima
