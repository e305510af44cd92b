// SPDX-License-Identifier: Apache-2.0
// A whole scene scaled or turned, camera, lights and patterns with it.
#pragma once
#include "parser/scene_program.h"

namespace proxima::testing {

/// `factor` is a power of two, so that nothing is rounded.
SceneProgram scaled(SceneProgram scene, double factor);

/// `turn` is a rotation.
SceneProgram turned(SceneProgram scene, const Mat3<double>& turn);

} // namespace proxima::testing
