// SPDX-License-Identifier: Apache-2.0
// How the frames of an animation come from its script: the plan's section "motion".
#pragma once
#include "parser/scene_program.h"
#include "renderer/animation.h"
#include "renderer/plan_report.h"

namespace proxima {

/// `scene` is of one of its frames, evaluated with motion recorded unless there is an obstacle.
PlanSection motion_plan(const SceneProgram& scene, const std::optional<MotionObstacle>& obstacle,
                        const Animation& animation);

} // namespace proxima
