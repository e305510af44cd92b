// SPDX-License-Identifier: Apache-2.0
// The part of a scene that follows from the time of the frame: programs for its moving spheres, and for any other
// number of a SceneProgram that moves.
#pragma once
#include "kernels/motion.h"

#include <cstdint>
#include <string>
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
        guard, ///< no number: something that must be finite for the programs to say what the script says
    };
    enum class Type : uint8_t { float32, float64 };

    Table table = Table::scene;
    Type type = Type::float64;
    uint32_t index = 0;
    uint32_t offset = 0;
};

/// Programs of one target, and the arrays behind their MotionView: each holds what belongs to them in their order.
struct MotionCode {
    std::vector<MotionProgram> programs;
    std::vector<MotionInstruction> instructions;
    std::vector<uint8_t> outputs;
    std::vector<double> shared;
    std::vector<double> constants;
    std::vector<uint32_t> targets;

    bool empty() const { return programs.empty(); }
    MotionView view(std::span<const double> splines) const {
        return {programs, instructions, outputs, shared, constants, targets, splines};
    }
};

struct MotionPrograms {
    MotionCode spheres; ///< targets: ids of spheres
    /// What all instances of a program have in common and follows from the time is computed once a frame: targets are
    /// indices into spheres.shared.
    MotionCode uniforms;
    MotionCode numbers; ///< targets: indices into `fields`
    std::vector<MotionField> fields;
    std::vector<double> splines; ///< the tables that all of them look into

    bool empty() const { return spheres.empty() && numbers.empty(); }
    size_t moving_spheres() const { return spheres.targets.size(); }
};

/// The place of the script that makes motion programs impossible.
struct MotionObstacle {
    std::string file;
    uint32_t line = 0;
    uint32_t column = 0;
    std::string word;   ///< what looks at a number that follows from the time
    std::string reason; ///< a sentence
};

/// Ends an evaluation that needs motion programs.
struct MotionImpossible {
    MotionObstacle obstacle;
};

/// Computes what the instances of the programs for spheres share at `time`, into a copy of spheres.shared. False when
/// a number on the way is not finite.
bool evaluate_uniforms(const MotionPrograms& motion, const MotionTime& time, std::span<double> shared);

/// Sets the numbers that are fields to what they are at `time`. False as above.
bool move_fields(SceneTables& tables, const MotionPrograms& motion, const MotionTime& time);

/// Whether all numbers but those of single spheres are finite at `time`, and all guards hold: what can be known without
/// the spheres.
bool is_defined(const MotionPrograms& motion, const MotionTime& time);

/// Moves the spheres that are targets. False as above, or when a radius is not above 0.
bool move_spheres(std::span<Sphere<double>> spheres, const MotionPrograms& motion, const MotionTime& time);

/// Both: the scene of another frame. When it is false the script has to be evaluated for that frame.
bool move(SceneProgram& scene, const MotionTime& time);

} // namespace proxima
