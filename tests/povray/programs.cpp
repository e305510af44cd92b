// SPDX-License-Identifier: Apache-2.0
#include "tests/povray/programs.h"

#include "tests/process.h"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace proxima::testing {
namespace fs = std::filesystem;
namespace {

/// POV-Ray may hang; a small picture never takes this long.
constexpr double timeout_seconds = 60;

Picture16 picture_by(std::vector<std::string> command, const std::vector<std::string>& more, const fs::path& output) {
    command.insert(command.end(), more.begin(), more.end());
    fs::remove(output);
    const auto run = run_process(command, ".", timeout_seconds);
    if (run.exit_code != 0)
        throw std::runtime_error(fmt::format("{} ended with {}:\n{}", command[0], run.exit_code, run.standard_error));
    return read_picture16(output);
}

/// As many digits as POV-Ray gives a frame's name: those of the last frame, which is one more in a cyclic animation.
int digits_of(const ShotFrame& frame) {
    return int(fmt::format("{}", frame.last + (frame.cyclic ? 1 : 0)).size());
}

fs::path with_number(const fs::path& output, const std::string& number) {
    return output.parent_path() / (output.stem().string() + number + output.extension().string());
}

} // namespace

Picture16 povray_picture(const Shot& shot, const fs::path& output) {
    std::vector<std::string> command{"povray",
                                     "+I" + shot.scene.string(),
                                     "+O" + output.string(),
                                     fmt::format("+W{}", shot.width),
                                     fmt::format("+H{}", shot.height),
                                     "+FN16",
                                     "File_Gamma=1.0",
                                     "-A",
                                     "-D",
                                     "+WT1",
                                     "+L" + shot.scene.parent_path().string()};
    if (!shot.frame) {
        command.push_back(std::string("+K") + shot_clock);
        return picture_by(command, shot.povray_options, output);
    }
    const ShotFrame& frame = *shot.frame;
    for (const std::string& option : {fmt::format("+KFI{}", frame.first), fmt::format("+KFF{}", frame.last),
                                      fmt::format("+SF{}", frame.frame), fmt::format("+EF{}", frame.frame)})
        command.push_back(option);
    if (frame.cyclic)
        command.push_back("+KC");
    return picture_by(command, shot.povray_options,
                      with_number(output, fmt::format("{:0{}}", frame.frame, digits_of(frame))));
}

Picture16 proxima_picture(const Shot& shot, const fs::path& output, const std::string& precision) {
    std::vector<std::string> command = {PROXIMA_PROGRAM,
                                        "render",
                                        shot.scene.string(),
                                        "-o",
                                        (shot.frame ? with_number(output, "%04d") : output).string(),
                                        "--size",
                                        fmt::format("{}x{}", shot.width, shot.height),
                                        "--tolerances",
                                        "povray",
                                        "--precision",
                                        precision,
                                        "--bits",
                                        "16",
                                        "--device",
                                        "cpu"};
    if (shot.frame) {
        const ShotFrame& frame = *shot.frame;
        for (const std::string& option : {std::string("--frames"), fmt::format("{}-{}", frame.first, frame.last),
                                          std::string("--subset"), fmt::format("{}", frame.frame)})
            command.push_back(option);
        if (frame.cyclic)
            command.push_back("--cyclic");
    } else {
        command.insert(command.end(), {"--clock", shot_clock});
    }
    if (std::find(shot.proxima_options.begin(), shot.proxima_options.end(), "--view") == shot.proxima_options.end())
        command.insert(command.end(), {"--view", "Raw"});
    return picture_by(command, shot.proxima_options,
                      shot.frame ? with_number(output, fmt::format("{:04}", shot.frame->frame)) : output);
}

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

std::vector<fs::path> scenes_in(const fs::path& folder) {
    std::vector<fs::path> scenes;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".scn")
            scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

} // namespace proxima::testing
