// SPDX-License-Identifier: Apache-2.0
// The strict subset: each line of snippets.txt that Proxima accepts is part of one scene, line by line, that POV-Ray
// has to accept. The lines that it refuses are named.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "tests/parser/evaluate.h"
#include "tests/process.h"

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <set>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

/// The snippets by their line, from 1; lines that are none are empty.
std::vector<std::string> read_snippets() {
    std::vector<std::string> lines(1);
    std::ifstream file(fs::path(PROXIMA_TEST_SOURCES) / "snippets.txt");
    for (std::string line; std::getline(file, line);) {
        const std::string number = std::to_string(lines.size());
        for (size_t at; (at = line.find('$')) != std::string::npos;)
            line.replace(at, 1, number);
        lines.push_back(line.starts_with("// ") ? "" : line);
    }
    return lines;
}

/// The line that POV-Ray complains about ("... line 12: Parse Error ..."), or 0; its message goes to `message`.
size_t refused_line(const std::vector<std::string>& lines, std::string& message) {
    std::ofstream scene("snippets.scn");
    for (size_t i = 1; i < lines.size(); ++i)
        scene << lines[i] << '\n';
    scene << "camera { location 1e5*y direction y }\n"; // not inside of a hundred spheres
    scene.close();
    const auto run =
        run_process({"povray", "+Isnippets.scn", "+W4", "+H4", "-D", "-GR", "-GS", "+Osnippets.png"}, ".", 60);
    if (run.exit_code == 0)
        return 0;
    const size_t error = std::min(run.standard_error.rfind("Parse Error"), run.standard_error.size());
    const size_t line = run.standard_error.rfind("line ", error);
    REQUIRE_MESSAGE(line != std::string::npos, run.standard_error);
    message = run.standard_error.substr(line, 300);
    return std::stoul(run.standard_error.substr(line + 5));
}

} // namespace

TEST_CASE("snippets: what Proxima accepts, POV-Ray accepts") {
    std::vector<std::string> lines = read_snippets();
    size_t accepted = 0, refused = 0;
    for (std::string& line : lines) {
        if (line.empty())
            continue;
        const bool right = !evaluate(line).diagnostics.has_errors();
        ++(right ? accepted : refused);
        if (!right)
            line.clear();
    }
    CHECK(accepted >= 150);
    CHECK(refused >= 100);
    std::string message;
    for (int wrong = 0; wrong < 100; ++wrong) {
        const size_t line = refused_line(lines, message);
        if (line == 0)
            break;
        REQUIRE(line < lines.size());
        CHECK_MESSAGE(false, fmt::format("POV-Ray refuses line {}: {}\n{}", line, lines[line], message));
        REQUIRE(!lines[line].empty());
        lines[line].clear();
    }
    MESSAGE(accepted << " snippets are accepted, " << refused << " refused");
}
