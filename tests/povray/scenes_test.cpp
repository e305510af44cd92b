// SPDX-License-Identifier: Apache-2.0
// Every small scene of scenes/, one a feature, rendered by POV-Ray and by Proxima, compared at 16 bits in linear light.
// A scene may ask for options of its own in comment lines:
//     // povray: +A0.0 +R3 -J
//     // proxima: --antialias grid:3
//     // float: 0.95            the share of pixels that `float` must have within 1/255, when that is below 0.99
// Leaves the pictures and a table (scenes_table.txt) in the folder it runs in. POV-Ray's pictures are kept in
// povray_cache/ under the hash of what they depend on. Names of scenes as arguments run only those.
#define DOCTEST_CONFIG_IMPLEMENT
#include "tests/povray/programs.h"

#include <algorithm>
#include <atomic>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>
#include <sstream>
#include <thread>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> chosen_scenes;

struct SmallScene {
    std::string name;
    Shot shot;
    double float_share = 0.99;
    std::string cached; ///< POV-Ray's picture
};

struct Outcome {
    std::string error;
    Difference in_double;
    Difference in_float;
};

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

/// The include and data files of the folder: what a scene's picture depends on besides its own text.
std::string shared_texts(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().extension() != ".scn")
            files[entry.path().string()] = text_of(entry.path());
    std::string all;
    for (const auto& [path, text] : files)
        all += path + '\n' + text;
    return all;
}

SmallScene read_scene(const fs::path& path, const std::string& shared) {
    SmallScene scene;
    scene.name = path.stem().string();
    scene.shot.scene = path;
    const std::string text = text_of(path);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const auto value = [&](std::string_view key) { return line.starts_with(key) ? line.substr(key.size()) : ""; };
        for (const std::string& word : words_of(value("// povray:")))
            scene.shot.povray_options.push_back(word);
        for (const std::string& word : words_of(value("// proxima:")))
            scene.shot.proxima_options.push_back(word);
        if (const std::string share = value("// float:"); !share.empty())
            scene.float_share = std::stod(share);
    }
    const size_t hash = std::hash<std::string>{}(
        fmt::format("{} {} {} {}\n{}", scene.shot.width, scene.shot.height, shot_clock, text, shared));
    scene.cached = fmt::format("povray_cache/{}.{:016x}.png", scene.name, hash);
    return scene;
}

/// A picture enters the cache whole or not at all.
Picture16 reference_picture(const SmallScene& scene) {
    if (fs::exists(scene.cached))
        return read_picture16(scene.cached);
    const fs::path fresh = scene.name + ".povray.png";
    Picture16 picture = povray_picture(scene.shot, fresh);
    fs::rename(fresh, scene.cached);
    return picture;
}

Outcome compare_scene(const SmallScene& scene, const std::vector<Pixel>& excused) {
    Outcome outcome;
    try {
        SmallScene single = scene;
        single.shot.proxima_options.insert(single.shot.proxima_options.end(), {"--threads", "1"});
        const Picture16 reference = reference_picture(single);
        outcome.in_double =
            compare(reference, proxima_picture(single.shot, scene.name + ".double.png", "double"), 2, excused);
        outcome.in_float = compare(reference, proxima_picture(single.shot, scene.name + ".float.png", "float"), 257);
    } catch (const std::exception& error) {
        outcome.error = error.what();
    }
    return outcome;
}

bool is_chosen(const std::string& name) {
    return chosen_scenes.empty() || std::find(chosen_scenes.begin(), chosen_scenes.end(), name) != chosen_scenes.end();
}

/// Both programs run on one thread each, several scenes at once: POV-Ray sleeps for most of a small picture's time.
std::vector<Outcome> compare_all(const std::vector<SmallScene>& scenes) {
    const auto listed = excused_pixels();
    std::vector<Outcome> outcomes(scenes.size());
    std::atomic<size_t> next = 0;
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(2u, 2 * std::thread::hardware_concurrency()); ++i)
        workers.emplace_back([&] {
            for (size_t job; (job = next++) < scenes.size();) {
                const auto found = listed.find(scenes[job].name);
                outcomes[job] =
                    compare_scene(scenes[job], found == listed.end() ? std::vector<Pixel>{} : found->second);
            }
        });
    workers.clear(); // waits
    return outcomes;
}

} // namespace

TEST_CASE("povray: every small scene looks as in POV-Ray") {
    const std::string shared = shared_texts(PROXIMA_POVRAY_SCENES);
    std::vector<SmallScene> scenes;
    for (const fs::path& path : scenes_in(PROXIMA_POVRAY_SCENES))
        if (is_chosen(path.stem().string()))
            scenes.push_back(read_scene(path, shared));
    REQUIRE(!scenes.empty());
    fs::create_directories("povray_cache");
    const std::vector<Outcome> outcomes = compare_all(scenes);

    std::ofstream table("scenes_table.txt");
    table << fmt::format("{:<36} {:>14} {:>8} {:>10} {:>17}\n", "80x60, in 1/65535", "double, worst", "excused", "RMS",
                         "float in 1/255");
    for (size_t i = 0; i < scenes.size(); ++i) {
        const auto& [error, exact, fast] = outcomes[i];
        INFO(scenes[i].name);
        CHECK_MESSAGE(error.empty(), error);
        if (!error.empty())
            continue;
        table << fmt::format("{:<36} {:>14} {:>8} {:>10.3f} {:>15.4f} %\n", scenes[i].name, exact.largest,
                             exact.excused.size(), exact.root_mean_square, 100 * fast.share_equal8);
        CHECK_MESSAGE(exact.over.empty(), fmt::format("{} pixels are off, the worst, {} {}, by {}/65535",
                                                      exact.over.size(), exact.worst.x, exact.worst.y, exact.largest));
        CHECK(fast.share_equal8 >= scenes[i].float_share);
    }
}

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i)
        if (argv[i][0] != '-')
            chosen_scenes.emplace_back(argv[i]);
    return doctest::Context(argc, argv).run();
}
