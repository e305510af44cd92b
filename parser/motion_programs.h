// SPDX-License-Identifier: Apache-2.0
// The part of a scene that follows from the time of the frame: programs for its moving spheres, and for any other
// number of a SceneProgram that moves.
#pragma once
#include "kernels/motion.h"

#include <cstdint>
#include <vector>

namespace proxima {

struct SceneTables;
struct SceneProgram;

/// A number in SceneTables: `offset` bytes into record `index` of one of its arrays, or into its only one.
struct MotionField {
    enum class Table : uint8_t {
        ellipsoids,
        planes,
        pigments,
        patterns,
        color_stops,
        finishes,
        interiors,
        transforms,
        lights,
        area_lights,
        fogs,
        camera,
        scene, ///< SceneTables itself: background and the like
    };
    enum class Type : uint8_t { float32, float64 };

    Table table = Table::scene;
    Type type = Type::float64;
    uint32_t index = 0;
    uint32_t offset = 0;
};

/// The arrays behind a MotionView. Programs of one target stand together, those of spheres first, and each array holds
/// what belongs to them in their order.
struct MotionPrograms {
    std::vector<MotionProgram> programs;
    std::vector<MotionInstruction> instructions;
    std::vector<uint8_t> outputs;
    std::vector<double> shared;
    std::vector<double> constants;
    std::vector<uint32_t> targets; ///< of spheres: their ids
    std::vector<MotionField> fields;
    uint32_t sphere_programs = 0;
    uint32_t moving_spheres = 0; ///< the instances of the first `sphere_programs` programs

    bool empty() const { return programs.empty(); }
    MotionView view() const { return {programs, instructions, outputs, shared, constants, targets}; }
};

/// The programs of fields alone, without what belongs to spheres.
MotionPrograms field_programs(const MotionPrograms& all);

/// Sets the numbers that are fields to what they are at `time`. False when one is not finite on the way.
bool move_fields(SceneTables& tables, const MotionPrograms& motion, const MotionTime& time);

/// Moves the spheres that are targets. False as above, or when a radius is not above 0.
bool move_spheres(std::span<Sphere<double>> spheres, const MotionPrograms& motion, const MotionTime& time);

/// Both: the scene of another frame. When it is false the script has to be evaluated for that frame.
bool move(SceneProgram& scene, const MotionTime& time);

} // namespace proxima
