// SPDX-License-Identifier: Apache-2.0
// What Proxima knows of POV-Ray's standard include files, as texts in the scene language: the same names with the same
// values, and of random numbers the same sequence. The frame of such a file (its guard, its #version) is not here.
#pragma once
#include <algorithm>
#include <fmt/format.h>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace proxima::standard {

std::string arrays();
std::string array_statistics(); ///< a part of math.inc
std::string colors();
std::string consts();
std::string debug();
std::string finish();
std::string glass();
std::string glass_old();
std::string golds();
std::string gradients(); ///< a part of math.inc
std::string ior();
std::string logo();
std::string math();
std::string metals();
std::string rand();
std::string shapes();
std::string shapes2();
std::string shapes3();
std::string shapes_old();
std::string shapesq();
std::string skies();
std::string stage1();
std::string stdcam();
std::string stdinc();
std::string stoneold();
std::string stones();
std::string stones1();
std::string stones2();
std::string strings();
std::string texture_maps(); ///< a part of textures.inc
std::string textures();
std::string transforms();
std::string woodmaps();
std::string woods();

/// A name and the terms of its color.
using NamedColor = std::pair<std::string_view, std::string_view>;

/// `#declare` of each color, as rgb with three terms and as rgbf with four.
std::string declare_colors(std::string_view prefix, std::span<const NamedColor> colors);

} // namespace proxima::standard
