// SPDX-License-Identifier: Apache-2.0
#include "parser/value.h"

namespace proxima {

Terms::Terms(std::initializer_list<Varying> terms, int count) : count(count) {
    NodeId ids[5] = {};
    int i = 0;
    for (const Varying& term : terms) {
        value[i] = term.value;
        ids[i++] = term.node;
    }
    const bool any = (ids[0] | ids[1] | ids[2] | ids[3] | ids[4]) != 0;
    if (MotionGraph* const graph = MotionGraph::current(); any && graph)
        nodes = count == 1 ? ids[0] : graph->terms(ids);
}

NodeId Terms::node_of_term(int index) const {
    const MotionGraph* const graph = MotionGraph::current();
    return graph ? graph->term(nodes, index) : 0;
}

/// The terms behind the last one are 0.
void Terms::pad_nodes() {
    NodeId ids[5] = {};
    for (int i = 0; i < count; ++i)
        ids[i] = node_of_term(i);
    if (MotionGraph* const graph = MotionGraph::current())
        nodes = graph->terms(ids);
}

void Surface::inherit(const Surface& outer) {
    if (texture == none)
        texture = outer.texture;
    if (interior == none)
        interior = outer.interior;
    flags |= says_hollow ? outer.flags & ~uint32_t(material_hollow) : outer.flags;
    says_hollow = says_hollow || outer.says_hollow;
}

void Shape::dress_parts() {
    for (auto& part : spheres)
        part.surface.inherit(own);
    for (auto& part : ellipsoids)
        part.surface.inherit(own);
    for (auto& part : planes)
        part.surface.inherit(own);
}

void Shape::append(const Shape& other) {
    const auto append = [](auto& parts, const auto& more) { parts.insert(parts.end(), more.begin(), more.end()); };
    const auto append_nodes = [](auto& nodes, const auto& more, size_t first) {
        for (PartNodes part : more) {
            part.part += uint32_t(first);
            nodes.push_back(part);
        }
    };
    append_nodes(moving_spheres, other.moving_spheres, spheres.size());
    append_nodes(moving_planes, other.moving_planes, planes.size());
    const size_t sphere_count = spheres.size(), ellipsoid_count = ellipsoids.size(), plane_count = planes.size();
    append(spheres, other.spheres);
    append(ellipsoids, other.ellipsoids);
    append(planes, other.planes);
    append(lights, other.lights);
    if (other.chains.empty())
        return;
    const auto shift = [&](auto& parts, size_t first) {
        for (size_t i = first; i < parts.size(); ++i)
            if (parts[i].chain != parts[i].still)
                parts[i].chain += uint32_t(chains.size());
    };
    shift(spheres, sphere_count);
    shift(ellipsoids, ellipsoid_count);
    shift(planes, plane_count);
    append(chains, other.chains);
}

ValueKind kind_of(const Value& value) {
    const Terms* terms = std::get_if<Terms>(&value);
    return {value.index(), terms ? terms->count : 0};
}

const char* value_description(const Value& value) {
    struct Describe {
        const char* operator()(std::monostate) const { return "nothing"; }
        const char* operator()(const Terms& terms) const {
            return terms.count == 1 ? "a number" : terms.count == 5 ? "a color" : "a vector";
        }
        const char* operator()(const std::string&) const { return "a string"; }
        const char* operator()(PigmentRef) const { return "a pigment"; }
        const char* operator()(FinishRef) const { return "a finish"; }
        const char* operator()(InteriorRef) const { return "an interior"; }
        const char* operator()(TextureRef) const { return "a texture"; }
        const char* operator()(const MaterialValue&) const { return "a material"; }
        const char* operator()(const ShapeRef&) const { return "an object"; }
        const char* operator()(ColorMapRef) const { return "a color map"; }
        const char* operator()(PigmentMapRef) const { return "a pigment map"; }
        const char* operator()(const SkyRef&) const { return "a sky sphere"; }
        const char* operator()(const FogRef&) const { return "a fog"; }
        const char* operator()(const CameraRef&) const { return "a camera"; }
        const char* operator()(const TransformRef&) const { return "a transform"; }
        const char* operator()(const MacroRef&) const { return "a macro"; }
        const char* operator()(const ArrayRef&) const { return "an array"; }
        const char* operator()(const DataFileRef&) const { return "an open file"; }
        const char* operator()(const FunctionRef&) const { return "a function"; }
        const char* operator()(const SplineRef&) const { return "a spline"; }
        const char* operator()(Refused) const { return "a name that Proxima refuses"; }
    };
    return std::visit(Describe{}, value);
}

} // namespace proxima
