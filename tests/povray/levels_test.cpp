// SPDX-License-Identifier: Apache-2.0
// The levels of PNG files as POV-Ray writes them, of light that is the same in both programs to the last bit: spheres
// that only glow, each in a colour of its own.
#include "tests/process.h"

#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>
#include <string>
#include <vector>

using namespace proxima::testing;

namespace {

// Red is even in linear light, green about so in levels; blue is mostly dark, where levels change fastest.
constexpr const char* scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -10*z direction z right 320*x up 240*y }
#default { finish { ambient 0 diffuse 0 emission 1 } }
#declare R = seed(1);
#for (Y, 0, 239)
  #for (X, 0, 319)
    sphere { <X - 159.5, Y - 119.5, 0>, 0.75 pigment { rgb <rand(R), pow(rand(R), 2.2), pow(rand(R), 4)> } }
  #end
#end
)";

template <class Level> std::vector<Level> levels_by(const std::vector<std::string>& command, const std::string& file) {
    const ProcessResult run = run_process(command, ".", 120);
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    const auto input = OIIO::ImageInput::open(file);
    REQUIRE(input);
    REQUIRE(input->spec().format == OIIO::TypeDesc(OIIO::BaseTypeFromC<Level>::value));
    REQUIRE(input->spec().nchannels == 3);
    std::vector<Level> levels(320 * 240 * 3);
    REQUIRE(input->read_image(0, 0, 0, 3, OIIO::BaseTypeFromC<Level>::value, levels.data()));
    return levels;
}

/// How many levels there are that are not POV-Ray's; none may be off by more than one.
template <class Level> size_t count_others(const std::string& bits) {
    const auto reference = levels_by<Level>(
        {"povray", "+Ilevels.scn", "+Olevels.povray.png", "+W320", "+H240", "+FN" + bits, "-A", "-D", "+WT1"},
        "levels.povray.png");
    const auto own =
        levels_by<Level>({PROXIMA_PROGRAM, "render", "levels.scn", "-o", "levels.png", "--size", "320x240", "--bits",
                          bits, "--tolerances", "povray", "--precision", "double", "--device", "cpu"},
                         "levels.png");
    size_t others = 0;
    int worst = 0;
    for (size_t i = 0; i < own.size(); ++i) {
        others += own[i] != reference[i];
        worst = std::max(worst, std::abs(int(own[i]) - int(reference[i])));
    }
    CHECK(worst <= 1);
    const auto [darkest, brightest] = std::ranges::minmax(own);
    CHECK(int(darkest) == 0);
    CHECK(int(brightest) >= (1 << (8 * sizeof(Level))) - 2);
    MESSAGE(fmt::format("{} bits: {} of {} levels are one off", bits, others, own.size()));
    return others;
}

} // namespace

TEST_CASE("povray: PNG files have POV-Ray's own levels, of 8 bits all but one in ten thousand") {
    std::ofstream("levels.scn") << scene;
    CHECK(count_others<uint8_t>("8") <= 320 * 240 * 3 / 10000);
    count_others<uint16_t>("16");
}
