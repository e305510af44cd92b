// SPDX-License-Identifier: Apache-2.0
#include "renderer/povray_run.h"
#include "parser/source_files.h"
#include "renderer/child_process.h"
#include "renderer/errors.h"
#include "renderer/image_file.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <stdlib.h>

namespace proxima {
namespace {

namespace fs = std::filesystem;

constexpr int exit_not_found = 127;
constexpr size_t shown_lines = 20;

/// A folder of our own among the temporary files, gone with its owner.
struct TemporaryFolder {
    fs::path path;

    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "proxima.XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw FileError(fmt::format("{}: cannot be made: {}", name, std::strerror(errno)));
        path = name;
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }
};

/// POV-Ray splits its options at spaces unless they are in quotes.
std::string quoted(const fs::path& path) {
    if (path.string().find('"') != std::string::npos)
        throw UsageError(fmt::format("{}: POV-Ray takes no name with a double quote; rename it", path.string()));
    return '"' + path.string() + '"';
}

void add_clock(std::vector<std::string>& command, const Animation& animation, int64_t frame) {
    if (animation.is_still) {
        if (animation.clock_on)
            command.push_back(fmt::format("+K{}", animation.initial_clock));
        return;
    }
    command.insert(
        command.end(),
        {fmt::format("Initial_Frame={}", animation.initial_frame), fmt::format("Final_Frame={}", animation.final_frame),
         fmt::format("Initial_Clock={}", animation.initial_clock), fmt::format("Final_Clock={}", animation.final_clock),
         fmt::format("Subset_Start_Frame={}", frame), fmt::format("Subset_End_Frame={}", frame)});
    if (animation.cyclic)
        command.push_back("Cyclic_Animation=on");
}

/// A grid in every pixel is method 1 with a threshold that every difference reaches.
void add_antialiasing(std::vector<std::string>& command, const Antialiasing& antialiasing) {
    using Method = Antialiasing::Method;
    if (antialiasing.method == Method::none)
        return command.push_back("-A");
    const float threshold = antialiasing.method == Method::grid ? 0.0f : antialiasing.threshold;
    command.insert(command.end(), {"Antialias=on", fmt::format("Antialias_Threshold={}", threshold),
                                   fmt::format("Sampling_Method={}", antialiasing.method == Method::squares ? 2 : 1),
                                   fmt::format("Antialias_Depth={}", antialiasing.depth), "Jitter=off"});
}

/// The name that POV-Ray gives the picture: an animation's frames have the digits of the last one.
fs::path picture_name(const Animation& animation, int64_t frame) {
    if (animation.is_still)
        return "picture.png";
    const size_t digits = std::to_string(animation.final_frame + (animation.cyclic ? 1 : 0)).size();
    return fmt::format("picture{:0{}}.png", frame, digits);
}

/// What POV-Ray said since it began to work: before that it lists its authors and options.
std::string last_words(const std::string& text) {
    const size_t parsing = text.rfind("[Parsing...]");
    size_t begin = parsing == std::string::npos ? 0 : std::min(text.find('\n', parsing), text.size());
    size_t lines = 0;
    for (size_t i = text.size(); i > begin; --i)
        if (text[i - 1] == '\n' && ++lines > shown_lines) {
            begin = i;
            break;
        }
    return text.substr(begin);
}

} // namespace

std::vector<std::string> povray_command(const SceneOptions& scene, const Antialiasing& antialiasing, int64_t frame,
                                        const fs::path& folder) {
    const fs::path own_folder = scene.scene.has_parent_path() ? scene.scene.parent_path() : fs::path(".");
    std::vector<std::string> command{"povray",
                                     "+I" + quoted(scene.scene),
                                     "+O" + quoted(folder / "picture.png"),
                                     fmt::format("+W{}", scene.width),
                                     fmt::format("+H{}", scene.height),
                                     "+FN16",
                                     "File_Gamma=1.0",
                                     "-D",
                                     "+WT1",
                                     "+L" + quoted(own_folder)};
    for (const fs::path& path : scene.include_paths)
        command.push_back("+L" + quoted(path));
    for (const auto& [name, value] : scene.declares)
        command.push_back(fmt::format("Declare={}={}", name, value));
    add_antialiasing(command, antialiasing);
    add_clock(command, scene.animation, frame);
    return command;
}

StoredImage render_with_povray(const SceneOptions& scene, const Antialiasing& antialiasing, int64_t frame,
                               double time_limit) {
    const TemporaryFolder folder;
    const ProcessResult run = run_process(povray_command(scene, antialiasing, frame, folder.path), ".", time_limit);
    if (run.exit_code == exit_not_found)
        throw FileError("povray cannot be started; install POV-Ray 3.7 (Debian: apt install povray povray-includes) or "
                        "add its folder to PATH");
    if (run.wall_seconds >= time_limit)
        throw FileError(fmt::format("POV-Ray was not ready after {} seconds and was stopped; allow more with "
                                    "--time-limit, or choose a smaller --size",
                                    time_limit));
    if (run.exit_code != 0)
        throw SceneRejected(fmt::format("{}: POV-Ray ended with code {}; what it said is shown above",
                                        scene.scene.string(), run.exit_code),
                            last_words(run.standard_error));
    StoredImage image = read_image_file(folder.path / picture_name(scene.animation, frame));
    image.encoding = "Linear"; // File_Gamma=1.0
    return image;
}

} // namespace proxima
