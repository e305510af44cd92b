// SPDX-License-Identifier: Apache-2.0
// Shapes of moving things -> programs: equal steps are merged, what is the same for all things of a shape is computed
// once a frame, and the rest becomes byte-code with registers.
#pragma once
#include "parser/motion_programs.h"
#include "parser/motion_shapes.h"

namespace proxima {

/// Appends the program of a shape. False when it needs more registers or constants than a program has.
bool compile(const MotionShape& shape, MotionPrograms& programs);

} // namespace proxima
