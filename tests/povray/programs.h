// SPDX-License-Identifier: Apache-2.0
// One scene rendered by POV-Ray and by Proxima, so that the two pictures can be compared sample by sample: 16 bits,
// linear light, no antialiasing, POV-Ray's tolerances.
#pragma once
#include "tests/povray/picture.h"

#include <map>
#include <optional>

namespace proxima::testing {

/// A frame of an animation, as both programs number it.
struct ShotFrame {
    int frame = 1;
    int first = 1, last = 1;
    bool cyclic = false;
};

struct Shot {
    std::filesystem::path scene;
    int width = 80;
    int height = 60;
    std::vector<std::string> povray_options{};  ///< added to POV-Ray's command line; later options go first
    std::vector<std::string> proxima_options{}; ///< added to Proxima's
    std::optional<ShotFrame> frame{};           ///< none: a still at shot_clock
};

/// Stills are taken at this clock, so that animated scenes are not compared at a symmetric moment only.
inline constexpr const char* shot_clock = "0.25";

// Both throw std::runtime_error with the program's messages when it fails.
Picture16 povray_picture(const Shot& shot, const std::filesystem::path& output);
/// `precision` is float or double.
Picture16 proxima_picture(const Shot& shot, const std::filesystem::path& output, const std::string& precision);

/// Scene name -> the pixels that excused_pixels.txt lists for it: lines "scene x y reason".
std::map<std::string, std::vector<Pixel>> excused_pixels();

/// The .scn files of a folder, sorted.
std::vector<std::filesystem::path> scenes_in(const std::filesystem::path& folder);

} // namespace proxima::testing
