// SPDX-License-Identifier: Apache-2.0
// What a frame's rays would find spheres with, and what else there was to choose from: the plan's section "rendering".
#pragma once
#include "renderer/frame_cost.h"
#include "renderer/plan_report.h"

namespace proxima {

/// `device` is the one that `plan` is of.
PlanSection method_plan(const FramePlan& plan, const std::string& device);

} // namespace proxima
