// SPDX-License-Identifier: Apache-2.0
// global_settings, background, and what #version and assumed_gamma mean for the picture.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("settings: values and limits") {
    const SceneProgram scene =
        scene_of("global_settings { ambient_light rgb <1, 2, 3> max_trace_level 7.9 adc_bailout 0.01 charset utf8 "
                 "max_intersections 64 number_of_waves 5 noise_generator 2 mm_per_unit 10 }");
    CHECK(scene.ambient_light == glm::vec3(1, 2, 3));
    CHECK(scene.max_trace_level == 7);
    CHECK(scene.adc_bailout == 0.01f);
    const SceneProgram plain = scene_of("");
    CHECK(plain.max_trace_level == 5);
    CHECK(plain.adc_bailout == doctest::Approx(1.0 / 255));
    for (const char* level : {"0", "257", "-1"}) {
        CAPTURE(std::string(level));
        CHECK(error_of(std::string("global_settings { max_trace_level ") + level + " }").find("between 1 and 256") !=
              std::string::npos);
    }
    CHECK(error_of("global_settings { assumed_gamma 0 }") == "assumed_gamma must be above 0");
    CHECK(error_of("global_settings { radiosity { } }") == "Proxima does not support 'radiosity'");
}

TEST_CASE("settings: the background is darkened by its transmit") {
    CHECK(scene_of("background { rgb <1, 0.5, 0> }").background == glm::vec3(1, 0.5f, 0));
    CHECK(scene_of("background { 0.5 }").background == glm::vec3(0.25f));
    CHECK(scene_of("background { rgbt <1, 0.5, 1, 0.25> }").background == glm::vec3(0.75f, 0.375f, 0.75f));
    CHECK(scene_of("background { rgbf <1, 0.5, 1, 0.25> }").background == glm::vec3(1, 0.5f, 1));
}

TEST_CASE("settings: version and assumed_gamma choose the curve as in POV-Ray") {
    struct Case {
        const char* text;
        WorkingCurve curve;
        bool legacy;
    };
    const Case cases[] = {
        {"#version 3.7; global_settings { assumed_gamma 1.0 }", WorkingCurve::linear, false},
        {"#version 3.7;", WorkingCurve::linear, false},
        {"", WorkingCurve::display, true},
        {"#version 3.6;", WorkingCurve::display, true},
        {"#include \"colors.inc\"", WorkingCurve::linear, false},
        {"#version 3.6; #include \"colors.inc\"", WorkingCurve::display, true},
        {"global_settings { assumed_gamma 1.0 }", WorkingCurve::linear, true},
        {"#version 3.7; global_settings { assumed_gamma 2.2 }", WorkingCurve::power, false},
        {"#version 3.7; global_settings { assumed_gamma srgb }", WorkingCurve::srgb, false},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        const SceneProgram scene = scene_of(test.text);
        CHECK(scene.working_curve == test.curve);
        CHECK(scene.legacy_transparency == test.legacy);
    }
    CHECK(scene_of("global_settings { assumed_gamma 2.2 }").working_gamma == 2.2f);
}
