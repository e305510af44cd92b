// SPDX-License-Identifier: Apache-2.0
#include "parser/value.h"

namespace proxima {

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
    append(spheres, other.spheres);
    append(ellipsoids, other.ellipsoids);
    append(planes, other.planes);
    append(lights, other.lights);
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
