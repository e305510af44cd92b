// SPDX-License-Identifier: Apache-2.0
// Wrong input of every kind: each scene in scenes/ against the message in its .expected file (PROXIMA_UPDATE=1 writes
// those anew, to be read before they are committed), and wrong command lines.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "tests/process.h"

#include <algorithm>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <sstream>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

const fs::path scenes = PROXIMA_ERROR_SCENES;

std::string text_of(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

ProcessResult check(const fs::path& scene) {
    return run_process({PROXIMA_PROGRAM, "check", scene.filename()}, scene.parent_path(), 30);
}

/// A folder of its own that goes away with it.
struct TemporaryFolder {
    fs::path path;
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "proxima-errors-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    ~TemporaryFolder() { fs::remove_all(path); }
};

} // namespace

TEST_CASE("errors: every wrong scene is refused with its message") {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(scenes))
        if (entry.path().extension() == ".scn")
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    REQUIRE(files.size() >= 60);

    const bool update = std::getenv("PROXIMA_UPDATE") != nullptr;
    for (const fs::path& scene : files) {
        CAPTURE(scene);
        const ProcessResult run = check(scene);
        CHECK(run.exit_code == 1);
        CHECK(run.wall_seconds < 10);
        const fs::path expected = fs::path(scene).replace_extension(".expected");
        if (update)
            std::ofstream(expected) << run.standard_error;
        else
            CHECK(run.standard_error == text_of(expected));
    }
}

TEST_CASE("errors: wrong command lines and files end with their documented code and leave nothing behind") {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "good.scn") << "camera { location <0, 0, -3> look_at 0 }\nsphere { 0, 1 }\n";
    std::ofstream(folder.path / "loop.scn") << "camera { location <0, 0, -3> look_at 0 }\n"
                                               "#for (I, 1, 1000000) sphere { <I, clock, 0>, 1 } #end\n";
    fs::create_directory(folder.path / "folder.png");
    fs::create_directory(folder.path / "folder.scn");

    struct Case {
        std::vector<std::string> arguments;
        int exit_code;
        std::string message; ///< must be part of what is printed
    };
    const Case cases[] = {
        {{}, 2, "proxima"},
        {{"rendr", "good.scn"}, 2, "rendr"},
        {{"render"}, 2, "SCENE"},
        {{"render", "good.scn", "--no-such-option"}, 2, "--no-such-option"},
        {{"render", "no_such.scn"}, 3, "no_such.scn"},
        {{"render", "-"}, 2, "-o OUT"},
        {{"check", "good.scn", "--max-steps", "0"}, 2, "--max-steps"},
        {{"check", "loop.scn", "--max-steps", "1"}, 1, "of its 1000000 rounds are done; --max-steps "},
        {{"check", "good.scn", "--max-memory", "much"}, 2, "--max-memory"},
        {{"check", "good.scn", "--max-seconds", "0"}, 2, "--max-seconds"},
        {{"render", "folder.scn"}, 3, "folder.scn"},
        {{"check", "no_such.scn"}, 3, "no_such.scn"},
        {{"render", "good.scn", "-o", "no_such_folder/out.png"}, 3, "no_such_folder"},
        {{"render", "good.scn", "-o", "folder.png"}, 3, "folder.png"},
        {{"render", "good.scn", "-o", "out.xyz"}, 2, ".xyz"},
        {{"render", "good.scn", "-o", "out"}, 2, "out"},
        {{"render", "good.scn", "--size", "0x10"}, 2, "--size"},
        {{"render", "good.scn", "--size", "2147483647x2147483647"}, 2, "--size"},
        {{"render", "good.scn", "--size", "-5x5"}, 2, "--size"},
        {{"render", "good.scn", "--size", "640"}, 2, "--size"},
        {{"render", "good.scn", "--frames", "1-99999999999999999999"}, 2, "--frames"},
        {{"render", "good.scn", "--frames", "a-b"}, 2, "--frames"},
        {{"render", "good.scn", "--frames", "1-10", "-o", "out.png"}, 2, "####"},
        {{"render", "good.scn", "--samples", "0"}, 2, "--samples"},
        {{"render", "good.scn", "--precision", "half"}, 2, "--precision"},
        {{"render", "good.scn", "--grid", "0"}, 2, "--grid"},
        {{"render", "good.scn", "--grid", "100000x100000x100000"}, 2, "--grid"},
        {{"render", "good.scn", "--bits", "half", "-o", "out.png"}, 2, "--bits"},
        {{"render", "good.scn", "--display", "NoSuchDisplay"}, 2, "sRGB"},
        {{"render", "good.scn", "--view", "NoSuchView"}, 2, "Un-tone-mapped"},
        {{"render", "good.scn", "--ocio", "no_such.ocio"}, 3, "no_such.ocio"},
        {{"render", "good.scn", "--device", "cuda:99"}, 2, "cuda:99"},
        {{"render", "good.scn", "--device", "tpu"}, 2, "tpu"},
        {{"render", "good.scn", "--declare", "=3"}, 2, "--declare"},
        {{"render", "good.scn", "--threads", "-1"}, 2, "--threads"},
        {{"render", "good.scn", "--stats-json", "no_such_folder/s.json"}, 3, "no_such_folder"},
    };
    const auto count = [&] {
        return std::distance(fs::recursive_directory_iterator(folder.path), fs::recursive_directory_iterator());
    };
    const auto before = count();
    for (const Case& test : cases) {
        std::vector<std::string> command{PROXIMA_PROGRAM};
        command.insert(command.end(), test.arguments.begin(), test.arguments.end());
        const ProcessResult run = run_process(command, folder.path, 30);
        std::string line;
        for (const std::string& argument : command)
            line += argument + ' ';
        CAPTURE(line);
        CAPTURE(run.standard_error);
        CHECK(run.exit_code == test.exit_code);
        CHECK(run.standard_error.find(test.message) != std::string::npos);
        CHECK(run.standard_output.empty());
        CHECK(count() == before);
    }
}
