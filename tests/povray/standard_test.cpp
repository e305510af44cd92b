// SPDX-License-Identifier: Apache-2.0
// The standard include files against POV-Ray's own: every name that one of them declares is known with POV-Ray's value,
// or refused by that name. Skipped, with the reason, where POV-Ray's files are not installed.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "parser/standard_includes.h"
#include "tests/parser/evaluate.h"
#include "tests/povray/programs.h"
#include "tests/povray/standard_names.h"
#include "tests/process.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <thread>

using namespace proxima;
using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

fs::path povray_includes() {
    for (const char* folder : {"/usr/share/povray-3.7/include", "/usr/local/share/povray-3.7/include"})
        if (fs::exists(fs::path(folder) / "colors.inc"))
            return folder;
    std::puts("skipped: POV-Ray's include files are not installed (Debian's package povray-includes)");
    return {};
}

/// What stands before a use of the file: files that need the names of others get them.
std::string include(const std::string& file) {
    std::string needed;
    if (file == "stdcam" || file == "skies" || file.starts_with("stone"))
        needed = "#include \"colors.inc\"\n";
    else if (file == "shapes2" || file == "shapesq")
        needed = "#include \"shapes.inc\"\n";
    return needed + fmt::format("#include \"{}.inc\"\n", file);
}

std::vector<std::string> known_files() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(povray_includes()))
        if (entry.path().extension() == ".inc" && find_standard_file(entry.path().filename().string()))
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

bool is_accepted(const std::string& text) {
    return !evaluate(text).diagnostics.has_errors();
}

/// Ways to use a name that has a value; the first that Proxima accepts says what the name is.
struct Use {
    const char* kind;
    const char* text;
};
constexpr Use uses[] = {
    {"number", "#declare Q = vstr(5, {} + <0, 0, 0, 0, 0>, \" \", 0, 12); sphere {{ 0, 1 }}"},
    {"texture", "sphere {{ 0, 1 texture {{ {} }} }}"},
    {"pigment", "sphere {{ 0, 1 pigment {{ {} }} }}"},
    {"finish", "sphere {{ 0, 1 pigment {{ rgb <0.7, 0.4, 0.2> }} finish {{ {} }} }}"},
    {"interior", "sphere {{ 0, 1 pigment {{ rgbf <0.9, 0.95, 1, 0.9> }} interior {{ {} }} }}"},
    {"material", "sphere {{ 0, 1 material {{ {} }} }}"},
    {"color_map", "sphere {{ 0, 1 pigment {{ gradient x color_map {{ {} }} }} }}"},
    {"object", "object {{ {} }}"},
    {"camera", "camera {{ {} }}"},
};

/// "number", "texture", ...; "refused" when it is so by its name; "" when it is neither.
std::string kind_of(const std::string& file, const std::string& name) {
    for (const Use& use : uses)
        if (is_accepted(include(file) + fmt::format(fmt::runtime(use.text), name)))
            return use.kind;
    const std::string message = error_of(include(file) + fmt::format("sphere {{ 0, 1 texture {{ {} }} }}", name));
    return message.starts_with(fmt::format("'{}' needs ", name)) ? "refused" : "";
}

/// POV-Ray breaks what #debug prints into lines of 80 characters wherever that happens to be: blanks do not count.
std::string without_blanks(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
    return text;
}

/// A long parse is announced in between, when a second has passed.
std::string without_banners(const std::string& text) {
    static const std::regex banner(R"(={4,}\[[^\]]*\]={4,})");
    return std::regex_replace(text, banner, "");
}

/// What POV-Ray prints with #debug between one @ and the next.
std::vector<std::string> povray_prints(const std::string& name, const std::string& text) {
    std::ofstream(name + ".scn") << text << "#debug \"@\\n\"\nsphere { 0, 1 }\n";
    const ProcessResult run = run_process(
        {"povray", "+I" + name + ".scn", "+W4", "+H4", "-D", "-GR", "-GS", "+WT1", "+O" + name + ".png"}, ".", 60);
    INFO(run.standard_error);
    CHECK(run.exit_code == 0);
    const std::string output =
        run.standard_error.substr(std::min(run.standard_error.find("@0"), run.standard_error.size()));
    std::vector<std::string> prints;
    for (size_t at = 0, next; (next = output.find('@', at + 1)) != std::string::npos; at = next)
        prints.push_back(without_banners(without_blanks(output.substr(at + 1, next - at - 1))));
    return prints;
}

std::vector<std::string> proxima_prints(const std::string& text) {
    std::vector<std::string> prints;
    const Evaluated result = evaluate(text + "sphere { 0, 1 }\n");
    INFO(result.messages);
    CHECK(!result.diagnostics.has_errors());
    for (const Diagnostic& diagnostic : result.diagnostics.all())
        if (diagnostic.severity == Severity::warning)
            prints.push_back(without_blanks(diagnostic.message));
    return prints;
}

/// Compares what stands between bars; `tolerance` is relative, and absolute below 1.
void check_equal(const std::string& ours, const std::string& povrays, double tolerance) {
    CAPTURE(povrays);
    CAPTURE(ours);
    std::istringstream a(ours), b(povrays);
    std::string word_a, word_b;
    while (std::getline(b, word_b, '|')) {
        CHECK(bool(std::getline(a, word_a, '|')));
        char* end = nullptr;
        const double value = std::strtod(word_b.c_str(), &end);
        if (*end == '\0')
            CHECK(std::abs(std::strtod(word_a.c_str(), nullptr) - value) <= tolerance * std::max(1.0, std::abs(value)));
        else
            CHECK(word_a == word_b);
    }
    CHECK(!std::getline(a, word_a, '|'));
}

/// Prints string expressions with both programs and compares.
void compare_values(const std::string& file, const std::vector<std::string>& printed, double tolerance) {
    std::string ours, povrays;
    for (size_t i = 0; i < printed.size(); ++i) {
        ours += fmt::format("#warning concat(\"{}|\", {})\n", i, printed[i]);
        povrays += fmt::format("#debug concat(\"@{}|\", {}, \"\\n\")\n", i, printed[i]);
    }
    const std::string start = include(file) + "#declare R = seed(12);\n";
    const auto a = proxima_prints(start + ours), b = povray_prints("standard_" + file, start + povrays);
    CHECK(a.size() == printed.size());
    CHECK(b.size() == printed.size());
    for (size_t i = 0; i < std::min({a.size(), b.size(), printed.size()}); ++i) {
        INFO(printed[i]);
        check_equal(a[i], b[i], tolerance);
    }
}

std::string printed_vector(const std::string& expression) {
    return fmt::format("vstr(5, {} + <0, 0, 0, 0, 0>, \"|\", 0, 12)", expression);
}

/// The i-th sphere of a picture, in rows. `surface` is what stands behind its radius.
std::string sphere_in_row(size_t i, const std::string& surface) {
    return fmt::format("sphere {{ <{}, {}, 0>, 0.4 {} }}\n", double(i % 14) - 6.5, 4.7 - double(i / 14), surface);
}
constexpr size_t rows_hold = 10 * 14;

/// The i-th bar, as wide as the picture: a pixel shows the color that the map has at the pixel's share of the width.
std::string bar_of_map(size_t i, const std::string& map) {
    return fmt::format("sphere {{ 0, 0.2 scale <100, 1, 1> translate {}*y\n"
                       "  pigment {{ gradient x color_map {{ {} }} scale 14 translate -7*x }}\n"
                       "  finish {{ ambient 1 diffuse 0 }} }}\n",
                       4.75 - double(i) / 2, map);
}
constexpr size_t bars_hold = 20;

/// Renders objects over a plane that shows in their mirrors and behind their glass, with both programs, and compares.
void compare_objects(const std::string& name, const std::string& file, const std::string& objects) {
    std::string scene = "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 4 }\n" + include(file) +
                        "camera { orthographic location -10*z up 10.5*y right 14*x }\n"
                        "light_source { <-30, 50, -60>, rgb 0.9 }\nbackground { rgb <0.3, 0.5, 0.8> }\n"
                        "plane { z, 3 pigment { rgb <0.6, 0.7, 0.4> } finish { ambient 0.2 diffuse 0.7 } }\n";
    std::ofstream(name + ".scn") << scene << objects;
    const Shot shot{.scene = fs::absolute(name + ".scn"), .width = 160, .height = 120};
    const Difference difference =
        compare(povray_picture(shot, name + ".povray.png"), proxima_picture(shot, name + ".double.png", "double"), 2);
    CAPTURE(name);
    CAPTURE(difference.worst.x);
    CAPTURE(difference.worst.y);
    CHECK(difference.largest <= 2);
}

/// Compares surfaces in as many pictures as they fill; `object` places one.
template <class Object>
void compare_surfaces(const std::string& file, const std::vector<std::string>& surfaces, size_t picture_holds,
                      const char* suffix, const Object& object) {
    for (size_t first = 0; first < surfaces.size(); first += picture_holds) {
        std::string objects;
        for (size_t i = first; i < std::min(first + picture_holds, surfaces.size()); ++i)
            objects += object(i - first, surfaces[i]);
        compare_objects(fmt::format("standard_{}_{}_{}", file, suffix, first / picture_holds), file, objects);
    }
}

struct Counts {
    std::atomic<size_t> known = 0, refused = 0;
};

/// Checks each name of one file.
void check_names(const std::string& file, Counts& counts) {
    CAPTURE(file);
    std::vector<std::string> numbers, surfaces, maps;
    for (const StandardName& name : standard_names(povray_includes() / (file + ".inc"))) {
        CAPTURE(name.name);
        // As in POV-Ray, a name is there whether it can be used or not.
        CHECK(is_accepted(include(file) + fmt::format("#ifndef ({}) #error \"\" #end sphere {{ 0, 1 }}", name.name)));
        const std::string kind = kind_of(file, name.name);
        if (name.is_called && kind != "refused")
            continue; // standard_calls.txt and the scenes have these
        CHECK(kind != "");
        ++(kind == "refused" ? counts.refused : counts.known);
        if (kind == "number")
            numbers.push_back(printed_vector(name.name));
        if (kind == "color_map")
            maps.push_back(name.name);
        const bool is_surface =
            kind == "texture" || kind == "pigment" || kind == "finish" || kind == "interior" || kind == "material";
        if (is_surface) {
            const std::string use = fmt::format(
                fmt::runtime(
                    std::find_if(std::begin(uses), std::end(uses), [&](const Use& u) { return u.kind == kind; })->text),
                name.name);
            surfaces.push_back(use.substr(14, use.size() - 16)); // without "sphere { 0, 1 " and "}"
        }
    }
    if (!numbers.empty())
        compare_values(file, numbers, 2e-7);
    compare_surfaces(file, surfaces, rows_hold, "surfaces", sphere_in_row);
    compare_surfaces(file, maps, bars_hold, "color_maps", bar_of_map);
}

} // namespace

TEST_CASE("standard names: each is known with POV-Ray's value, or refused by name") {
    if (povray_includes().empty())
        return;
    // POV-Ray sleeps for most of a small scene's time: several at once.
    const std::vector<std::string> files = known_files();
    Counts counts;
    std::atomic<size_t> next = 0;
    std::vector<std::jthread> workers;
    for (int i = 0; i < 6; ++i)
        workers.emplace_back([&] {
            for (size_t job; (job = next++) < files.size();)
                try {
                    check_names(files[job], counts);
                } catch (const std::exception& error) {
                    CHECK_MESSAGE(false, files[job] << ": " << error.what());
                }
        });
    workers.clear(); // waits
    MESSAGE(counts.known.load() << " names are known, " << counts.refused.load() << " refused");
    CHECK(counts.known > 850);
}

TEST_CASE("standard files: one that needs the names of another is refused without them, as by POV-Ray") {
    if (povray_includes().empty())
        return;
    for (const char* file : {"shapes2", "shapesq", "skies", "stdcam", "stones1", "stones2", "stoneold"}) {
        CAPTURE(file);
        const std::string text = fmt::format("#include \"{}.inc\"\nsphere {{ 0, 1 }}\n", file);
        CHECK(!is_accepted(text));
        std::ofstream("standard_needs.scn") << text;
        CHECK(run_process({"povray", "+Istandard_needs.scn", "+W4", "+H4", "-D", "+Ostandard_needs.png"}, ".", 60)
                  .exit_code != 0);
    }
}

TEST_CASE("standard macros: calls give POV-Ray's numbers, vectors and strings") {
    if (povray_includes().empty())
        return;
    std::map<std::string, std::vector<std::string>> calls;
    std::ifstream list(fs::path(PROXIMA_TEST_SOURCES) / "standard_calls.txt");
    for (std::string line; std::getline(list, line);) {
        const size_t blank = line.find(' ');
        const std::string call = line.substr(blank + 1);
        if (line[0] != '#')
            calls[line.substr(0, blank)].push_back(call[0] == '"' ? call.substr(1, call.size() - 2)
                                                                  : printed_vector(call));
    }
    for (const auto& [file, printed] : calls)
        compare_values(file, printed, file == "colors" ? 1e-5 : 1e-11);
}

TEST_CASE("standard macros: each that is known is in the list of calls or in a scene") {
    if (povray_includes().empty())
        return;
    std::ostringstream texts;
    texts << std::ifstream(fs::path(PROXIMA_TEST_SOURCES) / "standard_calls.txt").rdbuf();
    for (const fs::path& scene : scenes_in(PROXIMA_POVRAY_SCENES))
        texts << std::ifstream(scene).rdbuf();
    for (const std::string& file : known_files())
        for (const StandardName& name : standard_names(povray_includes() / (file + ".inc")))
            if (name.is_called && file != "debug" && kind_of(file, name.name) != "refused") {
                CAPTURE(name.name);
                CHECK(texts.str().find(name.name + "(") != std::string::npos);
            }
}
