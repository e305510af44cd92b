// SPDX-License-Identifier: Apache-2.0
// The part of `proxima plan` that says in which precision a scene is rendered, and why.
#pragma once
#include "renderer/float_fit.h"
#include "renderer/plan_report.h"

namespace proxima {

PlanSection precision_plan(const SceneProgram& scene, const FloatFit& fit);

} // namespace proxima
