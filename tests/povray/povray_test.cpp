// SPDX-License-Identifier: Apache-2.0
// Every example, rendered by POV-Ray and by Proxima, compared at 16 bits in linear light. Leaves the pictures and a
// table (table.txt) in the folder it runs in.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "tests/povray/picture.h"
#include "tests/process.h"

#include <algorithm>
#include <cstdio>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sstream>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

constexpr int width = 320, height = 240;
const fs::path examples = PROXIMA_EXAMPLES;

/// Stills are taken at this clock, so that animated scenes are not compared at a symmetric moment only.
constexpr const char* clock_value = "0.25";

/// The share of pixels that `float` must have within 1/255. Mirrors magnify its rounding, a hundredfold on each small
/// sphere: six of them in a row leave about one pixel in a hundred of the sphere flake to chance.
double float_share(const std::string& scene) { return scene == "02_sphereflake" ? 0.985 : 0.999; }

std::vector<fs::path> example_scenes() {
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(examples))
        if (entry.path().extension() == ".scn")
            scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// The pixels that excused_pixels.txt lists: lines "scene x y reason".
std::map<std::string, std::vector<Pixel>> excused_pixels() {
    std::map<std::string, std::vector<Pixel>> result;
    std::ifstream file(fs::path(PROXIMA_TEST_SOURCES) / "excused_pixels.txt");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string scene;
        Pixel pixel;
        if (words >> scene >> pixel.x >> pixel.y && scene[0] != '#')
            result[scene].push_back(pixel);
    }
    return result;
}

Picture16 picture_by(const std::vector<std::string>& command, const fs::path& output) {
    fs::remove(output);
    const auto run = run_process(command);
    if (run.exit_code != 0)
        throw std::runtime_error(fmt::format("{} ended with {}:\n{}", command[0], run.exit_code, run.standard_error));
    return read_picture16(output);
}

Picture16 povray_picture(const fs::path& scene, const fs::path& output) {
    return picture_by({"povray", "+I" + scene.string(), "+O" + output.string(), fmt::format("+W{}", width),
                       fmt::format("+H{}", height), "+FN16", "File_Gamma=1.0", "-A", "-D",
                       "+L" + scene.parent_path().string(), std::string("+K") + clock_value},
                      output);
}

Picture16 proxima_picture(const fs::path& scene, const fs::path& output, const std::string& precision) {
    return picture_by({PROXIMA_PROGRAM, "render", scene.string(), "-o", output.string(), "--size",
                       fmt::format("{}x{}", width, height), "--tolerances", "povray", "--precision", precision,
                       "--view", "Raw", "--bits", "16", "--clock", clock_value, "--device", "cpu"},
                      output);
}

/// Renders one scene with both programs, checks it, and returns its row of the table.
std::string compare_scene(const fs::path& scene, const std::vector<Pixel>& excused) {
    const std::string name = scene.stem().string();
    const Picture16 reference = povray_picture(scene, name + ".povray.png");
    const Picture16 in_double = proxima_picture(scene, name + ".double.png", "double");
    const Picture16 in_float = proxima_picture(scene, name + ".float.png", "float");

    const Difference exact = compare(reference, in_double, 2, excused);
    for (size_t i = 0; i < std::min<size_t>(exact.over.size(), 10); ++i)
        MESSAGE(name << ": pixel " << exact.over[i].x << " " << exact.over[i].y << " is off");
    CHECK(exact.over.empty());
    const Difference fast = compare(reference, in_float, 257);
    CHECK(fast.share_equal8 >= float_share(name));

    return fmt::format("{:<26} {:>14} {:>10} {:>10.3f} {:>15.4f} %\n", name, exact.largest, exact.excused.size(),
                       exact.root_mean_square, 100 * fast.share_equal8);
}

} // namespace

TEST_CASE("povray: every example looks as in POV-Ray") {
    const auto scenes = example_scenes();
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
