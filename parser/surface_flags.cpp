// SPDX-License-Identifier: Apache-2.0
#include "parser/surface_flags.h"

#include <algorithm>

namespace proxima {
namespace {

bool nonzero(const glm::vec3& v) {
    return v.x != 0 || v.y != 0 || v.z != 0;
}

bool is_transparent(const PigmentColor& color) {
    return color.filter != 0 || color.transmit != 0;
}

bool lets_light_through(const SceneTables& tables, const Pigment& pigment) {
    if (pigment.kind == PigmentKind::solid)
        return is_transparent(pigment.color);
    if (pigment.kind == PigmentKind::checker)
        return is_transparent(pigment.color) || is_transparent(pigment.second_color);
    const Pattern& pattern = tables.patterns[pigment.pattern];
    const auto first = tables.color_stops.begin() + pattern.first_stop;
    return std::any_of(first, first + pattern.stop_count, [&](const ColorStop& stop) {
        return stop.pigment == ColorStop::no_pigment ? is_transparent(stop.color)
                                                     : lets_light_through(tables, tables.pigments[stop.pigment]);
    });
}

} // namespace

uint32_t surface_flags(const SceneTables& tables, std::span<const Layer> layers) {
    uint32_t flags = 0;
    for (const Layer& layer : layers) {
        const Finish& finish = tables.finishes[layer.finish];
        if (lets_light_through(tables, tables.pigments[layer.pigment]))
            flags |= material_transparent;
        if (nonzero(finish.reflection_min) || nonzero(finish.reflection_max))
            flags |= material_reflective;
    }
    return flags;
}

void mark_surfaces(SceneTables& tables) {
    for (Material& material : tables.materials) {
        const auto layers = std::span(tables.layers).subspan(material.first_layer, material.layer_count);
        material.flags &= ~uint32_t(material_transparent | material_reflective);
        material.flags |= surface_flags(tables, layers);
    }
}

} // namespace proxima
