// SPDX-License-Identifier: Apache-2.0
// Which kernels a scene needs, and how much they must remember.
#pragma once
#include "kernels/trace.h"
#include "parser/scene_program.h"

#include <algorithm>

namespace proxima {

struct SceneNeeds {
    Features features = Features::opaque;
    uint32_t stack_entries = 0;     ///< paths that may wait at once
    uint32_t interior_capacity = 0; ///< primitives that a ray may be inside
};

inline bool has_material(const SceneTables& scene, uint32_t flags) {
    return std::any_of(scene.materials.begin(), scene.materials.end(),
                       [&](const Material& m) { return (m.flags & flags) != 0; });
}

/// Whether a scene has only what the kernels for paths that end can do: see Features.
inline bool is_simple(const SceneTables& scene) {
    return scene.fogs.empty() && !has_material(scene, material_double_illuminate) &&
           std::all_of(scene.lights.begin(), scene.lights.end(),
                       [](const Light<double>& l) { return l.area == Light<double>::no_area; });
}

/// Whether a scene has only what all kernels can do.
inline bool is_plain(const SceneTables& scene) {
    return is_simple(scene) && scene.sky.pigments.empty() &&
           !has_material(scene, material_no_image | material_no_reflection) &&
           std::all_of(
               scene.pigments.begin(), scene.pigments.end(),
               [](const Pigment& p) { return p.kind == PigmentKind::solid || p.kind == PigmentKind::checker; }) &&
           std::all_of(scene.lights.begin(), scene.lights.end(), [](const Light<double>& l) { return l.is_plain(); });
}

inline SceneNeeds needs_of(const SceneTables& scene, size_t spheres) {
    SceneNeeds needs;
    uint32_t most_rays = 0;
    bool transparent = false, branches = false, has_exponent = false, reflective = false;
    for (const Material& material : scene.materials) {
        uint32_t rays = (material.flags & material_transparent) ? 1 : 0;
        transparent |= rays != 0;
        if (material.flags & material_reflective) {
            uint32_t mirrors = 0;
            for (uint32_t i = 0; i < material.layer_count; ++i) {
                const Finish& finish = scene.finishes[scene.layers[material.first_layer + i].finish];
                const bool reflects =
                    finish.reflection_max != glm::vec3(0.0f) || finish.reflection_min != glm::vec3(0.0f);
                mirrors += reflects;
                has_exponent |= reflects && finish.reflection_exponent != 1;
            }
            reflective = true;
            branches |= mirrors > 1;
            rays += mirrors;
        }
        most_rays = std::max(most_rays, rays);
    }
    if (!transparent && !branches && !has_exponent && is_plain(scene)) {
        needs.features = reflective ? Features::mirrors : Features::opaque;
        return needs;
    }
    if (!transparent && !reflective && is_simple(scene)) {
        needs.features = Features::furnished;
        return needs;
    }
    needs.features = Features::all;
    const uint32_t ways = std::max(1u, most_rays);
    const uint32_t waiting = ways - (has_exponent ? 0 : 1); // one goes on; a mark takes a place as well
    needs.stack_entries = std::max(1u, waiting) * scene.max_trace_level;
    const size_t primitives = spheres + scene.ellipsoids.size() + scene.planes.size();
    needs.interior_capacity = uint32_t(std::min<size_t>(primitives, InteriorList::capacity));
    return needs;
}

} // namespace proxima
