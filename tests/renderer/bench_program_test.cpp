// SPDX-License-Identifier: Apache-2.0
// `proxima bench` as a user meets it, on tiny sizes: tables, charts, exit codes.
#include "renderer/bench/structures.h"
#include "tests/renderer/workplace.h"

#include <doctest/doctest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

using namespace proxima::testing;
using nlohmann::json;

namespace {

ProcessResult bench(const Workplace& work, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"--size", "32x20", "--device", "cpu", "--repeats", "1"});
    return work.run(std::move(arguments));
}

/// Every tag that is opened is closed, in order, and there is one root.
bool is_well_formed(const std::string& text) {
    std::vector<std::string> open;
    size_t roots = 0, at = 0;
    while ((at = text.find('<', at)) != std::string::npos) {
        const size_t end = text.find('>', at);
        if (end == std::string::npos || text.find('<', at + 1) < end)
            return false;
        const std::string tag = text.substr(at + 1, end - at - 1);
        at = end + 1;
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1))
                return false;
            open.pop_back();
        } else {
            roots += open.empty();
            if (!tag.ends_with('/'))
                open.push_back(tag.substr(0, tag.find_first_of(" \n")));
        }
    }
    for (size_t i = text.find('&'); i != std::string::npos; i = text.find('&', i + 1))
        if (text.compare(i, 5, "&amp;") != 0 && text.compare(i, 4, "&lt;") != 0 && text.compare(i, 4, "&gt;") != 0)
            return false;
    return open.empty() && roots == 1;
}

size_t count_lines(const std::string& text) {
    return size_t(std::count(text.begin(), text.end(), '\n'));
}

/// The files of a run with -o out: the table in three forms that agree, and the charts.
void check_folder(const Workplace& work, const std::string& name, const std::set<std::string>& charts) {
    const json table = json::parse(work.content("out/" + name + ".json"));
    const std::string csv = work.content("out/" + name + ".csv");
    CHECK(table["bench"] == name);
    REQUIRE(table["rows"].size() > 0);
    CHECK(count_lines(csv) == table["rows"].size() + 1);
    std::istringstream lines(csv);
    std::string header;
    std::getline(lines, header);
    std::string expected;
    const auto ordered = nlohmann::ordered_json::parse(work.content("out/" + name + ".json"));
    for (const auto& [column, value] : ordered["rows"][0].items())
        expected += (expected.empty() ? "" : ",") + column;
    CHECK(header == expected);
    for (std::string line; std::getline(lines, line);)
        CHECK(std::count(line.begin(), line.end(), ',') == std::count(header.begin(), header.end(), ','));
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(work.folder / "out"))
        if (entry.path().extension() == ".svg") {
            found.insert(entry.path().stem());
            const std::string svg = work.content("out/" + entry.path().filename().string());
            CHECK_MESSAGE(is_well_formed(svg), entry.path());
            CHECK(svg.find("nan") == std::string::npos);
            CHECK(svg.find("inf\"") == std::string::npos);
            CHECK(svg.find("<circle") != std::string::npos);
        }
    CHECK(found == charts);
}

} // namespace

TEST_CASE("bench seed: figures by every method, one picture a scene, charts and tables") {
    const Workplace work("bench_test");
    const ProcessResult run =
        bench(work, {"seed", "-o", "out", "--spheres", "30", "--only", "figure 2/3,figure 5,figure 6,figure 7"});
    REQUIRE_MESSAGE(run.exit_code == 0, run.standard_error);
    CHECK(run.standard_output == work.content("out/seed.txt"));
    CHECK(says(run.standard_output, "91.8 %"));
    CHECK(says(run.standard_error, "30 lattice spheres, cpu, paper-cloud: "));
    check_folder(work, "seed",
                 {"figure-2", "figure-3", "figure-5", "figure-6", "figure-7", "loop-lattice", "loop-planes"});
    const json table = json::parse(work.content("out/seed.json"));
    CHECK(table["claims"].size() == 12);
    std::map<std::string, std::set<std::string>> methods, pictures;
    std::map<std::string, size_t> best;
    for (const json& row : table["rows"]) {
        const std::string figure = row["experiment"], scene = row["scene"], width = to_string(row["width"]);
        methods[figure].insert(row["method"]);
        pictures[scene + to_string(row["spheres"]) + width].insert(row["picture"]);
        best[figure] += row["best"] == true;
        CHECK(row["failure"] == "");
        CHECK(row["frames"] >= 1);
        CHECK(row["frame_ms"] > 0);
        CHECK((row["map_ms"] > 0) == std::string(row["method"]).ends_with("cloud"));
        CHECK((row["lookups"].is_null() || row["lookups"] > 0));
    }
    for (const char* figure : {"figure 2/3", "figure 5"}) {
        CHECK(methods[figure] == std::set<std::string>{"brute", "cloud", "grid", "paper-cloud", "paper-grid"});
        CHECK(best[figure] == 2);
    }
    for (const char* figure : {"figure 6", "figure 7"})
        CHECK(methods[figure] == std::set<std::string>{"cloud", "paper-cloud"});
    CHECK(pictures.size() == 3);
    for (const auto& [scene, found] : pictures)
        CHECK_MESSAGE(found.size() == 1, scene);
    // What was measured can be rendered.
    CHECK(work.render({"out/scenes/lattice.scn", "--declare", "Count=30", "-o", "a.png"}).exit_code == 0);
}

TEST_CASE("bench sparse and scale: their scenes, their charts, JSON instead of a table") {
    const Workplace work("bench_test");
    const ProcessResult sparse = bench(work, {"sparse", "-o", "out", "--spheres", "700", "--json"});
    REQUIRE_MESSAGE(sparse.exit_code == 0, sparse.standard_error);
    CHECK(sparse.standard_output == work.content("out/sparse.json"));
    check_folder(work, "sparse", {"sparse"});
    std::map<std::string, size_t> structures;
    const json sparse_table = json::parse(sparse.standard_output);
    for (const json& row : sparse_table["structures"])
        ++structures[row["structure"]];
    CHECK(structures == std::map<std::string, size_t>{{"grid", 6}, {"octree", 6}, {"two-level grid", 6}});
    fs::remove_all(work.folder / "out");
    const ProcessResult scale = bench(work, {"scale", "-o", "out", "--spheres", "100,200", "--only", "planes,shell"});
    REQUIRE_MESSAGE(scale.exit_code == 0, scale.standard_error);
    check_folder(work, "scale", {"scale-planes", "scale-shell", "maps"});
    std::set<std::string> scenes;
    const json scale_table = json::parse(work.content("out/scale.json"));
    for (const json& row : scale_table["rows"])
        scenes.insert(row["scene"]);
    CHECK(scenes == std::set<std::string>{"planes", "shell"});
}

TEST_CASE("bench: the structures that are counted find the same hits") {
    for (uint32_t seed = 1; seed < 5; ++seed) {
        std::mt19937 engine(seed);
        std::uniform_real_distribution<double> uniform(-1.0, 1.0);
        proxima::SceneProgram scene;
        scene.camera.location = {0, 0, -4};
        const double spread = seed % 2 ? 1.0 : 0.1; // or a dense cluster among few others
        for (int i = 0; i < 1000; ++i)
            scene.spheres.push_back(
                {(i < 20 ? 1.0 : spread) * proxima::Vec3<double>(uniform(engine), uniform(engine), uniform(engine)),
                 0.03 * spread});
        const auto figures = proxima::count_structures(scene, 80, 60);
        REQUIRE(figures.size() == 3);
        CHECK(figures[0].checksum > 0);
        for (const auto& of : figures) {
            CHECK(of.checksum == doctest::Approx(figures[0].checksum).epsilon(1e-12));
            CHECK(of.lookups >= 1);
            CHECK(of.bytes > 0);
        }
        if (spread < 1) // what a second level is for
            CHECK(figures[1].tests < figures[0].tests / 2);
    }
}

TEST_CASE("bench: without a folder nothing is left, and a folder that cannot be written is exit code 3") {
    const Workplace work("bench_test");
    const ProcessResult run = bench(work, {"scale", "--spheres", "10", "--only", "shell"});
    CHECK(run.exit_code == 0);
    CHECK(work.files().empty());
    work.write("file", "");
    for (const char* folder : {"file", "file/below", "/proc/none"}) {
        const ProcessResult refused = bench(work, {"seed", "-o", folder});
        CHECK(refused.exit_code == 3);
        CHECK(says(refused.standard_error, folder));
    }
}

TEST_CASE("bench: a wrong command line is exit code 2 and says what to write") {
    const Workplace work("bench_test");
    CHECK(says(bench(work, {"seeds"}).standard_error, "did you mean seed?"));
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{}, {"seeds"}, {"scale", "--spheres", "many"}, {"scale", "--only", "moon"}}) {
        const ProcessResult run = bench(work, arguments);
        CHECK(run.exit_code == 2);
        CHECK(run.standard_output.empty());
    }
    CHECK(says(work.run({"bench", "--help"}).standard_output, "proxima bench seed -o"));
}
