// SPDX-License-Identifier: Apache-2.0
// A scene as the numbers that its picture depends on, to compare two.
#pragma once
#include "parser/scene_program.h"

#include <vector>

namespace proxima::testing {

/// Everything that a picture depends on, in a fixed order.
std::vector<double> numbers_of(const SceneProgram& scene);

enum class Likeness { none, but_signs_of_zeros, bits };
/// How like two scenes' numbers are. NaN is like nothing.
Likeness likeness(const std::vector<double>& a, const std::vector<double>& b);

} // namespace proxima::testing
