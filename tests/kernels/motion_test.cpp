// SPDX-License-Identifier: Apache-2.0
#include "kernels/motion.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <doctest/doctest.h>

#include "parser/motion_programs.h"
#include "parser/scene_program.h"

using namespace proxima;

namespace {

/// The result of a program of one instance.
struct Machine {
    MotionCode motion;
    Machine(std::vector<MotionInstruction> instructions, uint8_t output) {
        motion.instructions = std::move(instructions);
        motion.outputs = {output};
        motion.shared = {10, 20};
        motion.constants = {1, 2, 3, 4, 5, 6}; // three of each of two instances
        motion.targets = {0, 1};
        motion.programs = {{.target = MotionTarget::number,
                            .instructions = uint32_t(motion.instructions.size()),
                            .instances = 2,
                            .own_constants = 3}};
    }
    double operator()(uint32_t instance, bool expected_finite = true) const {
        double result = 0;
        CHECK(evaluate<true>(motion.view({}), motion.programs[0], instance, {7, 8, 9}, &result) == expected_finite);
        return result;
    }
};

} // namespace

TEST_CASE("motion: operands are registers, times, shared constants and own ones") {
    CHECK(Machine({}, MotionOperand::clock)(0) == 7);
    CHECK(Machine({}, MotionOperand::frame_number)(0) == 8);
    CHECK(Machine({}, MotionOperand::clock_delta)(0) == 9);
    CHECK(Machine({}, MotionOperand::first_shared + 1)(1) == 20);
    CHECK(Machine({}, MotionOperand::first_own + 2)(0) == 5);
    CHECK(Machine({}, MotionOperand::first_own + 2)(1) == 6);
    CHECK(Machine({{MotionOp::subtract, 63, MotionOperand::clock, MotionOperand::first_own}}, 63)(1) == 5);
}

TEST_CASE("motion: pick takes its right operand where the left one is not zero") {
    const auto picked = [](MotionOp test) {
        return Machine({{MotionOp::copy, 1, MotionOperand::first_shared, 0},
                        {test, 2, MotionOperand::clock, MotionOperand::first_own},
                        {MotionOp::pick, 1, 2, MotionOperand::first_own}},
                       1)(0);
    };
    CHECK(picked(MotionOp::greater) == 1);
    CHECK(picked(MotionOp::less) == 10);
}

TEST_CASE("motion: a number on the way that is not finite is told, even if it goes nowhere") {
    const std::vector<MotionInstruction> root{{MotionOp::negate, 0, MotionOperand::clock, 0},
                                              {MotionOp::sqrt, 0, 0, 0}};
    Machine(root, 0)(0, false);
    CHECK(Machine(root, MotionOperand::clock)(0, false) == 7);
}

TEST_CASE("motion: fields are set in their own width") {
    SceneProgram scene;
    scene.planes.resize(2);
    MotionCode& code = scene.motion.numbers;
    code.instructions = {{MotionOp::divide, 0, MotionOperand::clock, MotionOperand::first_own}};
    code.outputs = {0};
    code.constants = {3, 7};
    code.targets = {0, 1};
    code.programs = {{.target = MotionTarget::number, .instructions = 1, .instances = 2, .own_constants = 1}};
    scene.motion.fields = {
        {MotionField::Table::planes, MotionField::Type::float64, 1, offsetof(Plane<double>, distance)},
        {MotionField::Table::scene, MotionField::Type::float32, 0,
         uint32_t(offsetof(SceneTables, background) + sizeof(float))}};
    CHECK(move_fields(scene, scene.motion, {1, 0, 0}));
    CHECK(scene.planes[1].distance == 1.0 / 3.0);
    CHECK(scene.background.y == float(1.0 / 7.0));
}

TEST_CASE("motion: a guard is no number, and says when it does not hold") {
    SceneProgram scene;
    MotionCode& code = scene.motion.numbers;
    code.instructions = {{MotionOp::divide, 0, MotionOperand::first_shared, MotionOperand::clock}};
    code.outputs = {0};
    code.shared = {1};
    code.targets = {0};
    code.programs = {{.target = MotionTarget::number, .instructions = 1, .instances = 1}};
    scene.motion.fields = {{MotionField::Table::guard, MotionField::Type::float64, 0, 0}};
    CHECK(move(scene, {1, 0, 0}));
    CHECK(!move(scene, {0, 0, 0}));
}
