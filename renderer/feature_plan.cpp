// SPDX-License-Identifier: Apache-2.0
#include "renderer/feature_plan.h"
#include "renderer/scene_needs.h"

#include <algorithm>
#include <fmt/format.h>

namespace proxima {
namespace {

template <class Records, class Predicate> size_t count_if(const Records& records, const Predicate& predicate) {
    return size_t(std::ranges::count_if(records, predicate));
}

size_t with_flag(const SceneTables& scene, uint32_t flags) {
    return count_if(scene.materials, [=](const Material& material) { return (material.flags & flags) != 0; });
}

/// "needed: 2 of 7 materials", or that it is not.
std::string of(size_t some, size_t all, const char* what) {
    return some == 0 ? "left out" : fmt::format("needed: {} of {} {}", some, all, what);
}

bool is_exponential(const SceneTables& scene, const Finish& finish) {
    return !scene.materials.empty() && finish.reflection_exponent != 1 &&
           (finish.reflection_max != glm::vec3(0.0f) || finish.reflection_min != glm::vec3(0.0f));
}

std::string decision(const SceneTables& scene, const SceneNeeds& needs) {
    const char* shapes = scene.ellipsoids.empty() ? "spheres" : "spheres and ellipsoids";
    switch (needs.features) {
    case Features::opaque:
        return fmt::format("the kernels for {} whose paths all end at their first surface, under plain lights", shapes);
    case Features::mirrors:
        return "the kernel for opaque surfaces and single mirrors, under plain lights";
    case Features::furnished:
        return fmt::format("the kernel for opaque {} with patterns, a sky and lights of all kinds but areas", shapes);
    case Features::all:
        break;
    }
    return fmt::format("the kernel with everything; {} {} may wait for each pixel, in {} {} at once",
                       needs.stack_entries, needs.stack_entries == 1 ? "path" : "paths", needs.interior_capacity,
                       needs.interior_capacity == 1 ? "interior" : "interiors");
}

} // namespace

PlanSection feature_plan(const SceneProgram& scene, const Animation& animation) {
    const SceneNeeds needs = needs_of(scene, scene.spheres.size());
    PlanSection section{.name = "features", .decision = decision(scene, needs), .values = {}};
    const auto add = [&](const char* name, std::string value) { section.values.emplace_back(name, std::move(value)); };
    const size_t materials = scene.materials.size(), lights = scene.lights.size();
    const auto of_materials = [&](uint32_t flags) { return of(with_flag(scene, flags), materials, "materials"); };

    add("reflection", of_materials(material_reflective));
    add("reflection_exponent", of(count_if(scene.finishes, [&](const Finish& f) { return is_exponential(scene, f); }),
                                  scene.finishes.size(), "finishes"));
    add("transparency", of_materials(material_transparent));
    add("tinted_shadows", of(count_if(scene.materials,
                                      [](const Material& m) {
                                          return (m.flags & (material_transparent | material_no_shadow)) ==
                                                 material_transparent;
                                      }),
                             materials, "materials"));
    const bool transparent = with_flag(scene, material_transparent) > 0;
    const auto interiors = [&](const auto& predicate) {
        return of(transparent ? count_if(scene.interiors, predicate) : 0, scene.interiors.size(), "interiors");
    };
    add("refraction", interiors([](const Interior& i) { return i.ior != 1; }));
    add("fading_interiors", interiors([](const Interior& i) { return i.fade_power > 0 && i.fade_distance > 0; }));
    add("patterns", of(count_if(scene.pigments, [](const Pigment& p) { return has_color_map(p.kind); }),
                       scene.pigments.size(), "pigments"));
    add("lights_with_direction",
        of(count_if(scene.lights, [](const Light<double>& l) { return !l.is_plain(); }), lights, "lights"));
    add("area_lights",
        of(count_if(scene.lights, [](const Light<double>& l) { return l.area != Light<double>::no_area; }), lights,
           "lights"));
    add("hidden_from_rays", of_materials(material_no_image | material_no_reflection));
    add("lit_from_both_sides", of_materials(material_double_illuminate));
    add("sky_sphere", scene.sky.pigments.empty() ? "left out" : "needed");
    add("fog", scene.fogs.empty() ? "left out" : "needed");
    add("ellipsoids", of(scene.ellipsoids.size(), scene.ellipsoids.size() + scene.spheres.size(), "round shapes"));
    add("motion", of(scene.motion.moving_spheres(), scene.spheres.size(), "spheres"));
    add("motion_blur", animation.shutter.samples > 1 && scene.depends_on_time
                           ? fmt::format("needed: {} moments a frame", animation.shutter.samples)
                           : "left out");
    return section;
}

} // namespace proxima
