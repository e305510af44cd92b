// SPDX-License-Identifier: Apache-2.0
// Which kernels a scene runs, what they can do, and what was left out of them: the plan's section "features".
#pragma once
#include "parser/scene_program.h"
#include "renderer/animation.h"
#include "renderer/plan_report.h"

namespace proxima {

PlanSection feature_plan(const SceneProgram& scene, const Animation& animation);

} // namespace proxima
