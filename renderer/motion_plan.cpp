// SPDX-License-Identifier: Apache-2.0
#include "renderer/motion_plan.h"

#include <fmt/format.h>

namespace proxima {
namespace {

/// Instructions of all instances: what is computed for a frame.
uint64_t operations(const MotionCode& code) {
    uint64_t sum = 0;
    for (const MotionProgram& program : code.programs)
        sum += uint64_t(program.instructions) * program.instances;
    return sum;
}

std::string decision(const SceneProgram& scene, const std::optional<MotionObstacle>& found,
                     const Animation& animation) {
    if (!scene.depends_on_time)
        return "nothing follows from the time; the script is evaluated once";
    if (!found)
        return animation.is_still ? "the script is evaluated once; motion programs would say an animation's frames"
                                  : "the script is evaluated once; motion programs say the frames";
    const MotionObstacle& obstacle = *found;
    const std::string place =
        obstacle.line > 0 ? fmt::format("{}:{}:{}: ", obstacle.file, obstacle.line, obstacle.column) : "";
    return fmt::format("the script {} evaluated again for every frame: {}{}", animation.is_still ? "would be" : "is",
                       place, obstacle.reason);
}

} // namespace

PlanSection motion_plan(const SceneProgram& scene, const std::optional<MotionObstacle>& obstacle,
                        const Animation& animation) {
    const MotionPrograms& motion = scene.motion;
    const size_t moving = motion.moving_spheres();
    PlanSection section{.name = "motion", .decision = decision(scene, obstacle, animation), .values = {}};
    const auto add = [&](const char* name, PlanSection::Value value) {
        section.values.emplace_back(name, std::move(value));
    };
    add("frames", uint64_t(animation.frames.size()));
    add("moments_a_frame", uint64_t(animation.shutter.samples));
    add("spheres", uint64_t(scene.spheres.size()));
    if (obstacle) {
        add("forced_by", obstacle->word);
        add("line", uint64_t(obstacle->line));
        return section;
    }
    add("static_spheres", uint64_t(scene.spheres.size() - moving));
    add("moving_spheres", uint64_t(moving));
    add("programs", uint64_t(motion.spheres.programs.size()));
    add("instructions", uint64_t(motion.spheres.instructions.size()));
    add("operations_a_frame", operations(motion.spheres));
    add("constants", uint64_t(motion.spheres.constants.size()));
    add("shared_constants", uint64_t(motion.spheres.shared.size()));
    add("computed_once_a_frame", uint64_t(motion.uniforms.programs.size()));
    add("fields", uint64_t(motion.fields.size()));
    return section;
}

} // namespace proxima
