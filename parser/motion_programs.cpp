// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_programs.h"

#include "parser/scene_program.h"
#include "parser/surface_flags.h"

#include <cstring>

namespace proxima {
namespace {

/// The bytes of a field.
std::byte* bytes_of(SceneTables& tables, const MotionField& field) {
    const auto in = [&](auto& records) { return reinterpret_cast<std::byte*>(&records[field.index]) + field.offset; };
    switch (field.table) {
    case MotionField::Table::ellipsoids:
        return in(tables.ellipsoids);
    case MotionField::Table::planes:
        return in(tables.planes);
    case MotionField::Table::pigments:
        return in(tables.pigments);
    case MotionField::Table::patterns:
        return in(tables.patterns);
    case MotionField::Table::color_stops:
        return in(tables.color_stops);
    case MotionField::Table::finishes:
        return in(tables.finishes);
    case MotionField::Table::interiors:
        return in(tables.interiors);
    case MotionField::Table::transforms:
        return in(tables.transforms);
    case MotionField::Table::lights:
        return in(tables.lights);
    case MotionField::Table::area_lights:
        return in(tables.area_lights);
    case MotionField::Table::fogs:
        return in(tables.fogs);
    case MotionField::Table::camera:
        return reinterpret_cast<std::byte*>(&tables.camera) + field.offset;
    case MotionField::Table::scene:
    case MotionField::Table::guard:
        break;
    }
    return reinterpret_cast<std::byte*>(&tables) + field.offset;
}

/// Evaluates all instances of programs for single numbers; `store(target, value)` takes what is finite.
template <class Store>
bool evaluate_numbers(const MotionCode& code, std::span<const double> splines, const MotionTime& time, Store store) {
    const MotionView view = code.view(splines);
    bool finite = true;
    for (const MotionProgram& program : code.programs)
        for (uint32_t instance = 0; instance < program.instances; ++instance) {
            double result[1] = {};
            finite &= evaluate<true>(view, program, instance, time, result);
            store(code.targets[program.first_instance + instance], result[0]);
        }
    return finite;
}

} // namespace

bool evaluate_uniforms(const MotionPrograms& motion, const MotionTime& time, std::span<double> shared) {
    return evaluate_numbers(motion.uniforms, motion.splines, time,
                            [&](uint32_t target, double value) { shared[target] = value; });
}

bool move_fields(SceneTables& tables, const MotionPrograms& motion, const MotionTime& time) {
    const bool finite = evaluate_numbers(motion.numbers, motion.splines, time, [&](uint32_t target, double value) {
        const MotionField& field = motion.fields[target];
        if (field.table == MotionField::Table::guard)
            return;
        std::byte* const bytes = bytes_of(tables, field);
        const float single = float(value);
        if (field.type == MotionField::Type::float32)
            std::memcpy(bytes, &single, sizeof single);
        else
            std::memcpy(bytes, &value, sizeof value);
    });
    if (!motion.fields.empty())
        mark_surfaces(tables);
    return finite;
}

bool is_defined(const MotionPrograms& motion, const MotionTime& time) {
    const auto drop = [](uint32_t, double) {};
    return evaluate_numbers(motion.uniforms, motion.splines, time, drop) &&
           evaluate_numbers(motion.numbers, motion.splines, time, drop);
}

bool move_spheres(std::span<Sphere<double>> spheres, const MotionPrograms& motion, const MotionTime& time) {
    std::vector<double> shared = motion.spheres.shared;
    bool good = evaluate_uniforms(motion, time, shared);
    MotionView view = motion.spheres.view(motion.splines);
    view.shared = shared;
    for (const MotionProgram& program : view.programs)
        for (uint32_t instance = 0; instance < program.instances; ++instance) {
            double results[4] = {};
            good &= evaluate<true>(view, program, instance, time, results);
            good &= results[3] > 0;
            spheres[view.targets[program.first_instance + instance]] = {{results[0], results[1], results[2]},
                                                                        results[3]};
        }
    return good;
}

bool move(SceneProgram& scene, const MotionTime& time) {
    const bool spheres = move_spheres(scene.spheres, scene.motion, time);
    return move_fields(scene, scene.motion, time) && spheres;
}

} // namespace proxima
