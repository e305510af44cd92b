// SPDX-License-Identifier: Apache-2.0
// Motion programs: how numbers of a scene follow from the frame's time. A program is byte-code for a machine of 64
// registers; all things whose expressions have one shape are its instances and differ in their constants alone.
#pragma once
#include "kernels/geometry.h"
#include "kernels/motion_ops.h"
#include "kernels/spline_value.h"

#include <span>

namespace proxima {

/// The time of a frame, as the scene language names it.
struct MotionTime {
    double clock = 0;
    double frame_number = 0;
    double clock_delta = 0;

    friend bool operator==(const MotionTime&, const MotionTime&) = default;
};

/// What an operand's byte means: a register, a part of MotionTime, a constant of the program or one of the instance.
struct MotionOperand {
    static constexpr uint8_t registers = 64;
    static constexpr uint8_t clock = 64;
    static constexpr uint8_t frame_number = 65;
    static constexpr uint8_t clock_delta = 66;
    static constexpr uint8_t first_shared = 67; ///< a constant of the program
    static constexpr uint8_t shared_count = 61;
    static constexpr uint8_t first_own = 128; ///< a constant of the instance
    static constexpr uint8_t own_count = 128;
};

struct MotionInstruction {
    MotionOp op = MotionOp::copy;
    uint8_t result = 0; ///< a register
    uint8_t left = 0;   ///< an operand
    uint8_t right = 0;  ///< an operand; 0 where the operation has but one
};

/// What the results of a program are.
enum class MotionTarget : uint8_t {
    sphere, ///< 4: centre and radius of the sphere targets[instance]
    number, ///< 1: what targets[instance] says, see MotionPrograms
};

/// Ranges of the arrays of MotionView. Constant k of instance i stands at constants[first_constant + k * instances +
/// i].
struct MotionProgram {
    MotionTarget target = MotionTarget::sphere;
    uint32_t first_instruction = 0;
    uint32_t instructions = 0;
    uint32_t first_output = 0; ///< operands, as many as the target has results
    uint32_t first_shared = 0;
    uint32_t first_instance = 0; ///< into `targets`
    uint32_t instances = 0;
    uint32_t own_constants = 0; ///< of each instance
    uint64_t first_constant = 0;
};

HD constexpr uint32_t result_count(MotionTarget target) {
    return target == MotionTarget::sphere ? 4 : 1;
}

struct MotionView {
    std::span<const MotionProgram> programs;
    std::span<const MotionInstruction> instructions;
    std::span<const uint8_t> outputs;
    std::span<const double> shared;
    std::span<const double> constants;
    std::span<const uint32_t> targets;
    std::span<const double> splines; ///< tables of all programs, see SplineTerm
};

HD constexpr SplineKind spline_kind(MotionOp op) {
    return SplineKind(uint8_t(op) - uint8_t(MotionOp::linear_spline));
}
/// The operation of splines of a kind.
HD constexpr MotionOp spline_op(SplineKind kind) {
    return MotionOp(uint8_t(MotionOp::linear_spline) + uint8_t(kind));
}

/// Where a program keeps its numbers. Not cleared: it writes each of them before it reads it.
struct Registers {
    double values[MotionOperand::registers];
    HD Registers() {}
};

/// Evaluates one instance of a program into results[0 ... result_count). False when a number on the way is not finite:
/// then the script itself has to say what the frame is. `with_splines`: some program of the view has splines; they take
/// registers, which the others would wait for.
template <bool with_splines>
HD bool evaluate(const MotionView& motion, const MotionProgram& program, uint32_t instance, const MotionTime& time,
                 double* results) {
    Registers registers;
    const auto operand = [&](uint8_t code) {
        if (code < MotionOperand::registers)
            return registers.values[code];
        if (code >= MotionOperand::first_own)
            return motion.constants[program.first_constant +
                                    uint64_t(code - MotionOperand::first_own) * program.instances + instance];
        if (code >= MotionOperand::first_shared)
            return motion.shared[program.first_shared + (code - MotionOperand::first_shared)];
        return code == MotionOperand::clock          ? time.clock
               : code == MotionOperand::frame_number ? time.frame_number
                                                     : time.clock_delta;
    };
    bool finite = true;
    for (uint32_t i = 0; i < program.instructions; ++i) {
        const MotionInstruction instruction = motion.instructions[program.first_instruction + i];
        const double left = operand(instruction.left);
        if (instruction.op == MotionOp::pick) {
            if (left != 0)
                registers.values[instruction.result] = operand(instruction.right);
            continue;
        }
        const double right = operand(instruction.right);
        double result;
        if (with_splines && is_spline(instruction.op))
            result = SplineTerm(motion.splines, uint64_t(left)).at(right, spline_kind(instruction.op));
        else
            result = apply(instruction.op, left, right);
        finite &= magnitude(result) < infinity<double>;
        registers.values[instruction.result] = result;
    }
    for (uint32_t k = 0; k < result_count(program.target); ++k)
        results[k] = operand(motion.outputs[program.first_output + k]);
    return finite;
}

/// Puts every moving sphere where it is at `time`. One call for each instance of the programs whose target is spheres;
/// `exact` is empty or the same spheres in double.
template <class Real, bool with_splines> struct MoveSpheres {
    MotionView motion;
    MotionTime time;
    std::span<Sphere<Real>> spheres;
    std::span<Sphere<double>> exact;
    std::span<uint32_t> failures; ///< one counter: spheres that met a number which is not finite, or have no radius

    HD void operator()(uint32_t instance) const {
        const MotionProgram& program = motion.programs[program_of(instance)];
        double sphere[result_count(MotionTarget::sphere)];
        const bool finite = evaluate<with_splines>(motion, program, instance - program.first_instance, time, sphere);
        if (!finite || !(sphere[3] > 0))
            atomic_add(failures.data(), 1);
        const uint32_t place = motion.targets[instance];
        const double radius = sphere[3];
        spheres[place] = {Vec3<Real>(Real(sphere[0]), Real(sphere[1]), Real(sphere[2])), Real(radius)};
        if (!exact.empty())
            exact[place] = {Vec3<double>(sphere[0], sphere[1], sphere[2]), radius};
    }

    /// The last program that begins at or before `instance`.
    HD uint32_t program_of(uint32_t instance) const {
        uint32_t low = 0, high = uint32_t(motion.programs.size());
        while (high - low > 1) {
            const uint32_t middle = (low + high) / 2;
            (motion.programs[middle].first_instance <= instance ? low : high) = middle;
        }
        return low;
    }
};

} // namespace proxima
