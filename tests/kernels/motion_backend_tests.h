// SPDX-License-Identifier: Apache-2.0
// What every backend must do with a scene that moves. Included behind backend_tests.h.
#pragma once
#include "parser/motion_programs.h"

#include <cmath>
#include <limits>

namespace proxima::test {

constexpr uint8_t own(uint32_t k) {
    return uint8_t(MotionOperand::first_own + k);
}
constexpr uint8_t shared(uint32_t k) {
    return uint8_t(MotionOperand::first_shared + k);
}

/// Adds a program; `constants` are those of each instance in turn.
inline void add_program(MotionCode& motion, MotionTarget target, const std::vector<MotionInstruction>& instructions,
                        const std::vector<uint8_t>& outputs, const std::vector<double>& shared_constants,
                        const std::vector<uint32_t>& targets, const std::vector<std::vector<double>>& constants) {
    MotionProgram program{.target = target};
    program.first_instruction = uint32_t(motion.instructions.size());
    program.instructions = uint32_t(instructions.size());
    program.first_output = uint32_t(motion.outputs.size());
    program.first_shared = uint32_t(motion.shared.size());
    program.first_instance = uint32_t(motion.targets.size());
    program.instances = uint32_t(targets.size());
    program.own_constants = uint32_t(constants.front().size());
    program.first_constant = motion.constants.size();
    motion.instructions.insert(motion.instructions.end(), instructions.begin(), instructions.end());
    motion.outputs.insert(motion.outputs.end(), outputs.begin(), outputs.end());
    motion.shared.insert(motion.shared.end(), shared_constants.begin(), shared_constants.end());
    motion.targets.insert(motion.targets.end(), targets.begin(), targets.end());
    for (uint32_t k = 0; k < program.own_constants; ++k)
        for (const std::vector<double>& instance : constants)
            motion.constants.push_back(instance[k]);
    motion.programs.push_back(program);
}

/// A random scene in which every third sphere rises with the clock and every fifth of the others swells with the root
/// of it; the light moves as well.
inline SceneProgram moving_scene(uint32_t seed, const RandomSceneSpec& spec) {
    SceneProgram scene = random_scene(seed, spec);
    std::vector<uint32_t> rising, swelling;
    std::vector<std::vector<double>> risers, swellers;
    for (uint32_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere<double>& s = scene.spheres[i];
        if (i % 3 == 0) {
            rising.push_back(i);
            risers.push_back({s.center.x, s.center.y, s.center.z, s.radius});
        } else if (i % 5 == 0) {
            swelling.push_back(i);
            swellers.push_back({s.center.x, s.center.y, s.center.z, s.radius});
        }
    }
    add_program(scene.motion.spheres, MotionTarget::sphere,
                {{MotionOp::multiply, 0, MotionOperand::clock, shared(0)}, {MotionOp::add, 1, own(1), 0}},
                {own(0), 1, own(2), own(3)}, {0.25}, rising, risers);
    add_program(scene.motion.spheres, MotionTarget::sphere,
                {{MotionOp::sqrt, 0, MotionOperand::clock, 0}, {MotionOp::multiply, 0, 0, own(3)}},
                {own(0), own(1), own(2), 0}, {}, swelling, swellers);
    scene.motion.fields.push_back({MotionField::Table::lights, MotionField::Type::float64, 0,
                                   uint32_t(offsetof(Light<double>, position) + sizeof(double))});
    add_program(scene.motion.numbers, MotionTarget::number,
                {{MotionOp::add, 0, MotionOperand::frame_number, shared(0)}}, {0}, {3}, {0}, {{}});
    return scene;
}

/// A random scene in which spheres and the light rise along a natural spline through 0, 1 and 0 at the times 0, 1, 2.
inline SceneProgram scene_on_spline(uint32_t seed, const RandomSceneSpec& spec) {
    SceneProgram scene = random_scene(seed, spec);
    scene.motion.splines = {0, 1, 2, 3, 3, 0, 1, 0, 0, -3, 0};
    std::vector<uint32_t> all;
    std::vector<std::vector<double>> own_constants;
    for (uint32_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere<double>& s = scene.spheres[i];
        all.push_back(i);
        own_constants.push_back({s.center.x, s.center.y, s.center.z, s.radius});
    }
    const MotionInstruction height{MotionOp::natural_spline, 0, shared(0), MotionOperand::clock};
    add_program(scene.motion.spheres, MotionTarget::sphere, {height, {MotionOp::add, 0, own(1), 0}},
                {own(0), 0, own(2), own(3)}, {3}, all, own_constants);
    scene.motion.fields.push_back({MotionField::Table::lights, MotionField::Type::float64, 0,
                                   uint32_t(offsetof(Light<double>, position) + sizeof(double))});
    add_program(scene.motion.numbers, MotionTarget::number, {height}, {0}, {3}, {0}, {{}});
    return scene;
}

/// The same scene at a time, computed here.
inline SceneProgram moved(const SceneProgram& scene, const MotionTime& time) {
    SceneProgram result = scene;
    result.motion = {};
    for (uint32_t i = 0; i < scene.spheres.size(); ++i) {
        if (i % 3 == 0)
            result.spheres[i].center.y += time.clock * 0.25;
        else if (i % 5 == 0)
            result.spheres[i].radius *= std::sqrt(time.clock);
    }
    result.lights[0].position.y = time.frame_number + 3;
    return result;
}

} // namespace proxima::test

TEST_CASE_TEMPLATE("motion: a moved scene is the bits of the scene that stands there", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (const RandomSceneSpec& spec :
             {RandomSceneSpec{.spheres = 400}, RandomSceneSpec{.spheres = 20000, .radius = 0.03},
              RandomSceneSpec{.spheres = 300, .mirrors = true, .glass = true}}) {
            const SceneProgram scene = moving_scene(11, spec);
            FrameSettings settings;
            settings.width = 80;
            settings.height = 60;
            settings.precision = precision;
            renderer->set_scene(scene, precision);
            for (const MotionTime& time : {MotionTime{1, 3, 0.5}, MotionTime{0.3, 1, 0.5}, MotionTime{1, 3, 0.5}}) {
                Image image;
                const FrameStatistics statistics = renderer->render(settings, {&time, 1}, image);
                CHECK(statistics.motion_ms > 0);
                CHECK(same_bits(image, render(*make_renderer<Backend>(), moved(scene, time), settings)));
            }
        }
}

TEST_CASE_TEMPLATE("motion: spheres and lights on a spline are where it is", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = scene_on_spline(3, {.spheres = 500});
    FrameSettings settings;
    settings.width = 60;
    settings.height = 45;
    renderer->set_scene(scene, settings.precision);
    const double heights[][2] = {{-1, 0}, {0.5, 0.6875}, {1, 1}, {1.5, 0.6875}, {9, 0}};
    for (const auto& [clock, height] : heights) {
        CAPTURE(clock);
        SceneProgram there = scene;
        there.motion = {};
        for (Sphere<double>& sphere : there.spheres)
            sphere.center.y += height;
        there.lights[0].position.y = height;
        Image image;
        const MotionTime time{clock, 1, 0};
        renderer->render(settings, {&time, 1}, image);
        CHECK(same_bits(image, render(*make_renderer<Backend>(), there, settings)));
    }
}

TEST_CASE_TEMPLATE("motion: several moments are averaged in linear light", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = moving_scene(5, {.spheres = 200});
    FrameSettings settings;
    settings.width = 40;
    settings.height = 30;
    const MotionTime times[] = {{0.0625, 1, 0}, {0.25, 2, 0}, {0.75, 4, 0}};
    renderer->set_scene(scene, settings.precision);
    Image image;
    renderer->render(settings, times, image);
    std::vector<float> mean(image.rgb.size());
    for (const MotionTime& time : times) {
        const Image still = render(*make_renderer<Backend>(), moved(scene, time), settings);
        for (size_t i = 0; i < mean.size(); ++i)
            mean[i] += still.rgb[i];
    }
    for (float& value : mean)
        value /= 3;
    CHECK(image.rgb == mean);
}

TEST_CASE_TEMPLATE("motion: a number that is not finite is reported, and the next frame is right", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    FrameSettings settings;
    settings.width = 40;
    settings.height = 30;
    Image image;
    SceneProgram scene = moving_scene(6, {.spheres = 100});
    const MotionTime good{0.5, 2, 0.5};
    SUBCASE("of a sphere") {
        const MotionTime bad{-1, 2, 0.5}; // its root
        renderer->set_scene(scene, settings.precision);
        CHECK_THROWS_AS(renderer->render(settings, {&bad, 1}, image), MotionUndefined);
    }
    SUBCASE("of the light") {
        const MotionTime bad{0.5, std::numeric_limits<double>::infinity(), 0.5};
        renderer->set_scene(scene, settings.precision);
        CHECK_THROWS_AS(renderer->render(settings, {&bad, 1}, image), MotionUndefined);
    }
    renderer->render(settings, {&good, 1}, image);
    CHECK(same_bits(image, render(*make_renderer<Backend>(), moved(scene, good), settings)));
}
