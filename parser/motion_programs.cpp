// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_programs.h"

#include "parser/scene_program.h"

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
        break;
    }
    return reinterpret_cast<std::byte*>(&tables) + field.offset;
}

template <class T> std::vector<T> tail(const std::vector<T>& all, size_t first) {
    return {all.begin() + std::ptrdiff_t(first), all.end()};
}

} // namespace

MotionPrograms field_programs(const MotionPrograms& all) {
    MotionPrograms result;
    result.programs = tail(all.programs, all.sphere_programs);
    if (result.programs.empty())
        return result;
    const MotionProgram first = result.programs.front();
    for (MotionProgram& program : result.programs) {
        program.first_instruction -= first.first_instruction;
        program.first_output -= first.first_output;
        program.first_shared -= first.first_shared;
        program.first_instance -= first.first_instance;
        program.first_constant -= first.first_constant;
    }
    result.instructions = tail(all.instructions, first.first_instruction);
    result.outputs = tail(all.outputs, first.first_output);
    result.shared = tail(all.shared, first.first_shared);
    result.constants = tail(all.constants, first.first_constant);
    result.targets = tail(all.targets, first.first_instance);
    result.fields = all.fields;
    return result;
}

bool move_fields(SceneTables& tables, const MotionPrograms& motion, const MotionTime& time) {
    const MotionView view = motion.view();
    bool finite = true;
    for (size_t p = motion.sphere_programs; p < motion.programs.size(); ++p) {
        const MotionProgram& program = motion.programs[p];
        for (uint32_t instance = 0; instance < program.instances; ++instance) {
            double results[4] = {};
            finite &= evaluate(view, program, instance, time, results);
            const double result = results[0];
            const MotionField& field = motion.fields[motion.targets[program.first_instance + instance]];
            std::byte* const bytes = bytes_of(tables, field);
            const float single = float(result);
            if (field.type == MotionField::Type::float32)
                std::memcpy(bytes, &single, sizeof single);
            else
                std::memcpy(bytes, &result, sizeof result);
        }
    }
    return finite;
}

bool move_spheres(std::span<Sphere<double>> spheres, const MotionPrograms& motion, const MotionTime& time) {
    const MotionView view = motion.view();
    bool finite = true;
    for (size_t p = 0; p < motion.sphere_programs; ++p) {
        const MotionProgram& program = motion.programs[p];
        for (uint32_t instance = 0; instance < program.instances; ++instance) {
            double results[4] = {};
            finite &= evaluate(view, program, instance, time, results);
            spheres[motion.targets[program.first_instance + instance]] = {{results[0], results[1], results[2]},
                                                                          results[3]};
        }
    }
    return finite;
}

bool move(SceneProgram& scene, const MotionTime& time) {
    const bool spheres = move_spheres(scene.spheres, scene.motion, time);
    return move_fields(scene, scene.motion, time) && spheres;
}

} // namespace proxima
