// SPDX-License-Identifier: Apache-2.0
// `proxima plan` says which features a scene needs and which were left out.
#include "tests/renderer/workplace.h"

#include <nlohmann/json.hpp>

using namespace proxima::testing;

namespace {

nlohmann::json features_of(const Workplace& work, const std::string& body) {
    work.write("a.scn", std::string(still_scene) + body);
    const ProcessResult run = work.run({"plan", "a.scn", "--json"});
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    auto features = nlohmann::json::parse(run.standard_output).at("features");
    return features;
}

bool is_needed(const nlohmann::json& value) {
    return value.get<std::string>().starts_with("needed");
}

} // namespace

TEST_CASE("features: opaque spheres leave everything out") {
    const Workplace work("features_test");
    const nlohmann::json features = features_of(work, "");
    CHECK(says(features["decision"], "all end at their first surface"));
    CHECK(features.size() > 15);
    for (const auto& [name, value] : features.items()) {
        CAPTURE(name);
        CHECK((name == "decision" || value == "left out"));
    }
}

TEST_CASE("features: each is needed where a scene asks for it") {
    const Workplace work("features_test");
    struct Row {
        const char *body, *feature, *kernel;
    };
    const char *one = "first surface", *mirrors = "mirrors", *furnished = "lights of all kinds but areas",
               *all = "with everything";
    const Row rows[] = {
        {"sphere { x, 1 finish { reflection 0.5 } }", "reflection", mirrors},
        {"sphere { x, 1 finish { reflection { 0.5 } reflection_exponent 2 } }", "reflection_exponent", all},
        {"sphere { x, 1 pigment { rgbf 1 } }", "transparency", all},
        {"sphere { x, 1 pigment { rgbf 1 } }", "tinted_shadows", all},
        {"sphere { x, 1 pigment { rgbf 1 } interior { ior 1.5 } }", "refraction", all},
        {"sphere { x, 1 pigment { rgbf 1 } interior { fade_power 1 fade_distance 1 } }", "fading_interiors", all},
        {"sphere { x, 1 pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } } }", "patterns", furnished},
        {"light_source { y, 1 spotlight point_at 0 }", "lights_with_direction", furnished},
        {"light_source { y, 1 area_light x, z, 3, 3 }", "area_lights", all},
        {"sphere { x, 1 no_image }", "hidden_from_rays", furnished},
        {"sphere { x, 1 double_illuminate }", "lit_from_both_sides", all},
        {"sky_sphere { pigment { rgb 1 } }", "sky_sphere", furnished},
        {"fog { distance 9 }", "fog", all},
        {"sky_sphere { pigment { rgb 1 } } sphere { x, 1 finish { reflection 0.5 } }", "sky_sphere", all},
        {"sphere { 0, 1 scale <1, 2, 1> }", "ellipsoids", one},
        {"sphere { <clock, 3, 0>, 1 }", "motion", one},
    };
    for (const Row& row : rows) {
        CAPTURE(row.feature);
        const nlohmann::json features = features_of(work, row.body);
        CHECK(is_needed(features[row.feature]));
        CHECK(says(features["decision"], row.kernel));
    }
}
