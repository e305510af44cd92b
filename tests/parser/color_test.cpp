// SPDX-License-Identifier: Apache-2.0
// Colours in every spelling; values of POV-Ray 3.7.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

const std::string header = "global_settings { assumed_gamma 1 } #declare White = rgb 1; #declare V = <1, 2, 3>;\n";

PigmentColor color_of(const std::string& text) {
    const SceneProgram scene = scene_of(header + "sphere { 0, 1 pigment { " + text + " } }");
    return scene.spheres.empty() ? PigmentColor{} : pigment_of(scene).color;
}

} // namespace

TEST_CASE("colors: every spelling gives its five channels") {
    struct Case {
        const char* text;
        float channels[5];
    };
    const Case cases[] = {
        {"rgb <1, 0.5, 0.25>", {1, .5f, .25f, 0, 0}},
        {"color rgb 0.5", {.5f, .5f, .5f, 0, 0}},
        {"colour rgb <1, 2>", {1, 2, 0, 0, 0}},
        {"rgbf 1", {1, 1, 1, 1, 0}},
        {"rgbt <1, 2, 3, 4>", {1, 2, 3, 0, 4}},
        {"rgbt <1, 2, 3, 4>*0.5", {.5f, 1, 1.5f, 0, 2}},
        {"rgbft <1, 2, 3, 4, 5>", {1, 2, 3, 4, 5}},
        {"rgb <1, 1, 1>*0.5", {.5f, .5f, .5f, 0, 0}},
        {"rgb V", {1, 2, 3, 0, 0}},
        {"color V", {1, 2, 3, 0, 0}},
        {"color red 1 green 0.5", {1, .5f, 0, 0, 0}},
        {"red 1", {1, 0, 0, 0, 0}},
        {"White*0.5", {.5f, .5f, .5f, 0, 0}},
        {"color White*0.5 filter 0.2", {.5f, .5f, .5f, .2f, 0}},
        {"White filter 0.5", {1, 1, 1, .5f, 0}},
        {"color White red 0.5", {.5f, 1, 1, 0, 0}},
        {"rgb 0.5 transmit 0.2", {.5f, .5f, .5f, 0, .2f}},
        {"rgb 1 filter 0.5*2 red 0.2", {.2f, 1, 1, 1, 0}},
        {"color 0.5", {.5f, .5f, .5f, .5f, .5f}},
        {"srgb 0.5", {.2140411f, .2140411f, .2140411f, 0, 0}},
        {"srgb <255, 128, 2>/255", {1, .2158605f, .00060705f, 0, 0}},
        {"srgbt 0.5", {.2140411f, .2140411f, .2140411f, 0, .5f}},
        {"srgbft <0.5, 0.5, 0.5, 0.5, 0.7>", {.2140411f, .2140411f, .2140411f, .5f, .7f}},
        {"srgb 0.5 red 0.5", {.5f, .2140411f, .2140411f, 0, 0}},
        {"rgb -1", {-1, -1, -1, 0, 0}},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        const PigmentColor color = color_of(test.text);
        check_near(color.rgb, glm::vec3(test.channels[0], test.channels[1], test.channels[2]), 1e-6);
        CHECK(color.filter == doctest::Approx(test.channels[3]));
        CHECK(color.transmit == doctest::Approx(test.channels[4]));
    }
}

TEST_CASE("colors: what POV-Ray refuses is refused") {
    for (const char* text : {"<1, 0, 0>", "1", "V", "rgb 1 rgb 0.5", "(White)", "-White", "2*White",
                             "color rgb 1, filter 1", "scale 2 rgb 1", "rgb <1, 2, 3, 4>", "color"}) {
        CAPTURE(std::string(text));
        CHECK(error_of(header + "sphere { 0, 1 pigment { " + text + " } }") != "");
    }
    CHECK(error_of("sphere { 0, 1 pigment { srgb 0.5 } }") ==
          "an sRGB color needs assumed_gamma in global_settings before it");
    CHECK(error_of(header + "#declare C = 2*rgb 1;") == "unexpected 'rgb'");
}

TEST_CASE("colors: sRGB colors follow the working space") {
    const auto red = [](const char* gamma) {
        return pigment_of(scene_of(std::string("global_settings { assumed_gamma ") + gamma +
                                   " } sphere { 0, 1 pigment { srgb 0.5 } }"))
            .color.rgb.x;
    };
    CHECK(red("1") == doctest::Approx(0.2140411));
    CHECK(red("srgb") == doctest::Approx(0.5));
    CHECK(red("2.2") == doctest::Approx(std::pow(0.2140411, 1 / 2.2)).epsilon(1e-5));
}
