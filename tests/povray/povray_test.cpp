// SPDX-License-Identifier: Apache-2.0
// Every example, rendered by POV-Ray and by Proxima, compared at 16 bits in linear light. Leaves the pictures and a
// table (table.txt) in the folder it runs in.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "tests/povray/programs.h"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

/// Renders one scene with both programs, checks it, and returns its row of the table.
std::string compare_scene(const fs::path& scene, const std::vector<Pixel>& excused) {
    const std::string name = scene.stem().string();
    const Shot shot{.scene = scene, .width = 320, .height = 240};
    const Picture16 reference = povray_picture(shot, name + ".povray.png");
    const Picture16 in_double = proxima_picture(shot, name + ".double.png", "double");
    const Picture16 in_float = proxima_picture(shot, name + ".float.png", "float");

    const Difference exact = compare(reference, in_double, 2, excused);
    for (size_t i = 0; i < std::min<size_t>(exact.over.size(), 10); ++i)
        MESSAGE(name << ": pixel " << exact.over[i].x << " " << exact.over[i].y << " is off");
    CHECK(exact.over.empty());
    const Difference fast = compare(reference, in_float, 257);
    CHECK(fast.share_equal8 >= 0.999);
    for (const Pixel& pixel : fast.over) // rounding may move an outline, and nothing else
        CHECK_MESSAGE(is_on_outline(reference, pixel), name << ": float, pixel " << pixel.x << " " << pixel.y);

    return fmt::format("{:<26} {:>14} {:>10} {:>10.3f} {:>15.4f} %\n", name, exact.largest, exact.excused.size(),
                       exact.root_mean_square, 100 * fast.share_equal8);
}

} // namespace

TEST_CASE("povray: every example looks as in POV-Ray") {
    const auto scenes = scenes_in(PROXIMA_EXAMPLES);
    REQUIRE(scenes.size() >= 10);
    const auto listed = excused_pixels();
    std::string table = fmt::format("{:<26} {:>14} {:>10} {:>10} {:>17}\n", "320x240, in 1/65535", "double, worst",
                                    "excused", "RMS", "float in 1/255");
    for (const fs::path& scene : scenes) {
        CAPTURE(scene);
        const auto found = listed.find(scene.stem().string());
        try {
            table += compare_scene(scene, found == listed.end() ? std::vector<Pixel>{} : found->second);
        } catch (const std::exception& error) {
            FAIL_CHECK(std::string(error.what()));
        }
    }
    std::ofstream("table.txt") << table;
}

TEST_CASE("povray: the first frames and a late one of every animation look as in POV-Ray") {
    struct Row {
        const char* scene;
        ShotFrame animation;
    };
    const Row rows[] = {{"07_showcase", {.last = 72, .cyclic = true}},
                        {"12_pendulum_wave", {.last = 240, .cyclic = true}},
                        {"16_galaxy", {.last = 120}},
                        {"17_lattice_waves", {.last = 96, .cyclic = true}},
                        {"18_breaking_block", {.last = 90}},
                        {"19_life_in_space", {.first = 0, .last = 59}},
                        {"motion_splines", {.last = 72}}};
    for (const Row& row : rows)
        for (const int frame : {1, 7, 60}) {
            ShotFrame shown = row.animation;
            shown.frame = std::min(frame, shown.last);
            const std::string file = std::string(row.scene) + ".scn";
            const fs::path example = fs::path(PROXIMA_EXAMPLES) / file;
            const Shot shot{.scene = fs::exists(example) ? example : fs::path(PROXIMA_POVRAY_SCENES) / file,
                            .width = 160,
                            .height = 120,
                            .frame = shown};
            CAPTURE(row.scene);
            CAPTURE(shown.frame);
            const std::string name = row.scene;
            const Picture16 reference = povray_picture(shot, name + ".povray.frame.png");
            const Difference exact = compare(reference, proxima_picture(shot, name + ".double.frame.png", "double"), 2);
            for (size_t i = 0; i < std::min<size_t>(exact.over.size(), 10); ++i)
                MESSAGE(name << ", frame " << shown.frame << ": pixel " << exact.over[i].x << " " << exact.over[i].y
                             << " is off, the worst by " << exact.largest);
            CHECK(exact.over.empty());
            const Difference fast = compare(reference, proxima_picture(shot, name + ".float.frame.png", "float"), 257);
            CHECK(fast.share_equal8 >= 0.999);
        }
}
