// SPDX-License-Identifier: Apache-2.0
// How rays will find spheres: the plan's section "method".
#pragma once
#include "renderer/choose_devices.h"
#include "renderer/frame_scenes.h"
#include "renderer/plan_report.h"

namespace proxima {

/// Builds the grid and the cloud of a frame on the device and counts what rays look up in them, in a picture that is
/// small. `scenes` is what the frame shows. Throws DeviceError and MotionUndefined.
PlanSection method_plan(const FrameScenes& scenes, const FrameSettings& settings, const ChosenDevice& device);

} // namespace proxima
