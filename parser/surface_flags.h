// SPDX-License-Identifier: Apache-2.0
// What follows for a material from the numbers of its layers: whether light goes through it, whether it mirrors.
#pragma once
#include "parser/scene_program.h"

#include <span>

namespace proxima {

/// material_transparent and material_reflective, as the layers have them.
uint32_t surface_flags(const SceneTables& tables, std::span<const Layer> layers);

/// Sets these flags of all materials anew, after the numbers of pigments and finishes changed.
void mark_surfaces(SceneTables& tables);

} // namespace proxima
