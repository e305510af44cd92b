// SPDX-License-Identifier: Apache-2.0
// The extremes: scenes and what is declared for them.
#pragma once
#include "tests/extremes/scene_text.h"

namespace proxima::testing {

struct ExtremeCase {
    std::string name;
    std::string scene; ///< a file of scenes/
    Declares declares{};
    uint32_t width = 64, height = 48;
    bool is_quick = true;   ///< it is part of the test
    bool by_a_hair = false; ///< rays run along outlines: a picture is as good as one seen outline_tolerance aside
};

/// Whether to have the case that takes minutes and gigabytes.
enum class Slowness { usual, all };
std::vector<ExtremeCase> extreme_cases(Slowness slowness = Slowness::usual);

SceneProgram read_case(const ExtremeCase& extreme, const std::filesystem::path& scenes = PROXIMA_EXTREMES);

} // namespace proxima::testing
