// SPDX-License-Identifier: Apache-2.0
// The order in which a device stores spheres: neighbours in space next to each other, so that building and walking the
// grid stay in the caches. The picture does not depend on it.
#pragma once
#include "parser/scene_program.h"

#include <cstdint>
#include <vector>

namespace proxima {

/// The sphere that comes first, second, and so on; empty to keep the scene's order. Spheres around the camera come
/// first, in the scene's order: POV-Ray's rules for nested interiors look at it.
std::vector<uint32_t> spatial_order(const SceneProgram& scene);

} // namespace proxima
