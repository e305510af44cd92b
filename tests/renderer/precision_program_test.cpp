// SPDX-License-Identifier: Apache-2.0
// Precision as a user meets it: what is chosen, and what is said of it.
#include "tests/renderer/workplace.h"

#include <nlohmann/json.hpp>

using namespace proxima::testing;

namespace {

/// The standard error of a rendering, and the precision that its frames say.
std::pair<std::string, std::string> render(const Workplace& work, std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", "a.exr", "--stats-json", "a.json"});
    const ProcessResult run = work.render(arguments);
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    return {run.standard_error, nlohmann::json::parse(work.content("a.json")).at("frames").at(0).at("precision")};
}

nlohmann::json plan_of(const Workplace& work, const char* scene) {
    const ProcessResult run = work.run({"plan", scene, "--json"});
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    return nlohmann::json::parse(run.standard_output).at("precision");
}

} // namespace

TEST_CASE("precision: a scene that float does not hold is rendered in double, and a line says so") {
    const Workplace work("precision_test");
    work.write("far.scn", "#version 3.7; global_settings { assumed_gamma 1 }\n"
                          "camera { location <1e8, 0, -3> look_at <1e8, 0, 0> }\n"
                          "light_source { <1e8, 5, -5>, rgb 1 } sphere { <1e8, 0, 0>, 0.5 pigment { rgb 1 } }\n");
    const auto [said, precision] = render(work, {"far.scn"});
    CHECK(precision == "double");
    CHECK(says(said, "pixels: it is rendered in double"));
    fs::copy_file(work.folder / "a.exr", work.folder / "chosen.exr");
    CHECK_FALSE(says(render(work, {"far.scn", "--precision", "double"}).first, "rendered in"));
    CHECK(work.run({"compare", "a.exr", "chosen.exr"}).exit_code == 0);

    const auto [warned, by_name] = render(work, {"far.scn", "--precision", "float"});
    CHECK(by_name == "float");
    CHECK(says(warned, "rendered in float all the same, as --precision float asks for"));

    const auto [silent, usual] = render(work, {"still.scn"});
    CHECK(usual == "float");
    CHECK_FALSE(says(silent, "rendered in"));
}

TEST_CASE("precision: plan says what would be chosen, and why") {
    const Workplace work("precision_test");
    work.write("globe.scn", "camera { location <0, 2, -3> look_at 0 } light_source { <1, 5, -5>, rgb 1 }\n"
                            "#for (I, 1, 9) sphere { <I - 5, 0.5, 0>, 0.5 } #end sphere { <0, -1e6, 0>, 1e6 }\n");
    work.write("far.scn", "camera { location <1e8, 0, -3> look_at <1e8, 0, 0> } sphere { <1e8, 0, 0>, 0.5 }\n");
    CHECK(plan_of(work, "still.scn").at("decision") == "float holds the scene");
    const nlohmann::json globe = plan_of(work, "globe.scn");
    CHECK(globe.at("decision") == "float, but for what is large: rays meet that in double");
    CHECK(globe.at("large_spheres") == 1);
    const nlohmann::json far = plan_of(work, "far.scn");
    CHECK(says(far.at("decision").get<std::string>(), "double: float would move what is seen by up to"));
    CHECK(far.at("coordinate") > 1e8);
    CHECK(far.at("moved_pixels") > 1);
}
