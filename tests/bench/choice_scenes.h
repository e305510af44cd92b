// SPDX-License-Identifier: Apache-2.0
// Scenes to choose between grid and cloud for: spheres in many arrangements, seen from outside and from within.
#pragma once
#include "parser/scene_program.h"

#include <string>
#include <vector>

namespace proxima::bench {

struct ChoiceScene {
    std::string name;
    SceneProgram scene;
};

/// `fit`: those that coefficients are fitted on; `test`: others, in arrangements and views of their own, of which there
/// are more than 40.
enum class SceneSet { fit, test };

size_t choice_scene_count(SceneSet set);
/// `scale` multiplies the numbers of spheres, which are 3,000 to 40,000 otherwise.
ChoiceScene choice_scene(SceneSet set, size_t place, double scale);

} // namespace proxima::bench
