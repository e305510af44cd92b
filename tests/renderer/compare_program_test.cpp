// SPDX-License-Identifier: Apache-2.0
// `proxima compare` as a user meets it: files in; figures, pictures, a page and exit codes out.
#include "tests/process.h"

#include <OpenImageIO/imageio.h>
#include <doctest/doctest.h>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

using namespace proxima::testing;
namespace fs = std::filesystem;

namespace {

constexpr const char* scene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
light_source { <-5, 5, -5>, rgb 1 }
sphere { <clock, 0, 0>, 0.5 pigment { rgb <1, 0.3, 0.2> } finish { ambient frame_number / 20 } }
)";

struct Workplace {
    fs::path folder = fs::absolute("compare_test");

    Workplace() {
        fs::remove_all(folder);
        fs::create_directories(folder / "a");
        fs::create_directories(folder / "b");
        std::ofstream(folder / "a.scn") << scene;
    }
    ~Workplace() { fs::remove_all(folder); }

    /// A flat 8-bit picture; with `odd` one sample of pixel (1, 2) is that level.
    void picture(const std::string& name, int level, int odd = -1, int width = 16) const {
        std::vector<uint8_t> samples(size_t(width) * 12 * 3, uint8_t(level));
        if (odd >= 0)
            samples[(2 * size_t(width) + 1) * 3] = uint8_t(odd);
        const auto output = OIIO::ImageOutput::create((folder / name).string());
        REQUIRE(output);
        REQUIRE(output->open((folder / name).string(), OIIO::ImageSpec(width, 12, 3, OIIO::TypeDesc::UINT8)));
        REQUIRE(output->write_image(OIIO::TypeDesc::UINT8, samples.data()));
        REQUIRE(output->close());
    }

    ProcessResult compare(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {PROXIMA_PROGRAM, "compare"});
        return run_process(arguments, folder, 120);
    }

    std::string content(const std::string& name) const {
        std::ifstream file(folder / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("compare program: two equal files end with 0, two different ones with 4 and the worst pixel") {
    const Workplace work;
    work.picture("a.png", 100);
    work.picture("b.png", 100, 90);
    const ProcessResult equal = work.compare({"a.png", "a.png"});
    CHECK(equal.exit_code == 0);
    CHECK(equal.standard_error.empty());
    const ProcessResult different = work.compare({"a.png", "b.png", "--json", "f.json", "--heatmap", "h.png"});
    CHECK(different.exit_code == 4);
    CHECK(says(different.standard_output, "sRGB levels of 8 bits as stored"));
    CHECK(says(different.standard_output, "x 1, y 2: A (100, 100, 100), B (90, 100, 100)"));
    const auto json = nlohmann::json::parse(work.content("f.json"));
    CHECK(json["pairs"][0]["pixels_over"] == 1);
    CHECK(json["pairs"][0]["worst"]["b"][0] == 90);
    const auto heatmap = OIIO::ImageInput::open((work.folder / "h.png").string());
    REQUIRE(heatmap);
    CHECK(heatmap->spec().width == 3 * 16 + 2 * 4);

    CHECK(work.compare({"a.png", "b.png", "--tolerance", "10/255"}).exit_code == 0);
    CHECK(work.compare({"a.png", "b.png", "--tolerance", "9/255"}).exit_code == 4);
    CHECK(work.compare({"a.png", "b.png", "--allow", "0.53"}).exit_code == 0); // 1 of 192 pixels is 0.521 %
    CHECK(work.compare({"a.png", "b.png", "--allow", "0.5%"}).exit_code == 4);
}

TEST_CASE("compare program: sequences and folders are paired, and what one side lacks is a difference") {
    const Workplace work;
    for (const char* side : {"a", "b"})
        for (int frame = 1; frame <= 3; ++frame)
            work.picture(fmt::format("{}/f.{:04}.png", side, frame), 10 * frame);
    for (const auto& [a, b] : {std::pair("a/f.####.png", "b/f.%04d.png"), std::pair("a", "b")}) {
        CAPTURE(a);
        CHECK(work.compare({a, b}).exit_code == 0);
        work.picture("b/f.0004.png", 1);
        const ProcessResult run = work.compare({a, b});
        CHECK(run.exit_code == 4);
        CHECK(says(run.standard_output, "missing: A has none"));
        CHECK(says(run.standard_error, "1 of 4 pairs are not equal"));
        fs::remove(work.folder / "b/f.0004.png");
    }
    CHECK(work.compare({"a/f.####.png", "b/f.####.png", "--frames", "2-3"}).exit_code == 0);
    CHECK(work.compare({"a/f.####.png", "b/f.####.png", "--frames", "2-5"}).exit_code == 4);
    CHECK(work.compare({"a/x.####.png", "b/x.####.png"}).exit_code == 3);
}

TEST_CASE("compare program: the page shows the failures and its pictures, and needs nothing else") {
    const Workplace work;
    work.picture("a/1.png", 10);
    work.picture("b/1.png", 10);
    work.picture("a/2<i>.png", 10);
    work.picture("b/2<i>.png", 10, 200);
    work.picture("a/3.png", 10);
    work.picture("b/3.png", 10, -1, 17);
    CHECK(work.compare({"a", "b", "--report", "page/of/it"}).exit_code == 4);
    const std::string page = work.content("page/of/it/index.html");
    CHECK(says(page, "the sizes differ: A is 16 x 12, B is 17 x 12"));
    CHECK_FALSE(says(page, "2<i>"));
    CHECK_FALSE(says(page, "://") != says(page, "http://www.w3.org/2000/svg")); // no other address
    for (const char* name : {"1.a", "1.b", "1.difference", "2.difference"})
        CHECK(fs::exists(work.folder / fmt::format("page/of/it/pictures/{}.png", name)));
    CHECK_FALSE(fs::exists(work.folder / "page/of/it/pictures/3.a.png"));
}

TEST_CASE("compare program: each mistake has its exit code and its remedy") {
    const Workplace work;
    work.picture("a.png", 1);
    work.picture("wide.png", 1, -1, 17);
    std::ofstream(work.folder / "text.png") << "text";
    struct Row {
        std::vector<std::string> arguments;
        int exit_code;
        const char* message;
    };
    const Row rows[] = {
        {{"a.png", "nowhere.png"}, 3, "nowhere.png: cannot be read: No such file or directory"},
        {{"a.png", "text.png"}, 3, "text.png: not a readable picture: "},
        {{"a.png", "wide.png"}, 4, "the sizes differ: A is 16 x 12, B is 17 x 12"},
        {{"a.png"}, 2, "there is nothing to compare it with; write A and B, or --povray after a scene"},
        {{"a.png", "b"}, 2, "a.png is a file and b a folder"},
        {{"a", "b"}, 3, "there are no pictures"},
        {{"a.png", "a.png", "--size", "2x2"}, 2, "--size: only --povray renders"},
        {{"a.png", "a.png", "--frames", "1-2"}, 2, "--frames: only a sequence has frames"},
        {{"a.png", "a.png", "--tolerance", "1/0"}, 2, "--tolerance 1/0: write a number from 0"},
        {{"a.png", "a.png", "--allow", "101"}, 2, "--allow 101: write percent from 0 to 100"},
        {{"a.png", "a.png", "--heatmap", "h.jpg"}, 2, "--heatmap h.jpg: it is a PNG"},
        {{"a.png", "a.png", "--json", "no/f.json"}, 3, "there is no folder 'no'"},
        {{"a.png", "a.png", "--report", "a.png"}, 3, "cannot be made"},
        {{"a.scn", "a.png", "--povray"}, 2, "a.png: --povray compares one scene with itself"},
        {{"a.scn", "--povray", "--frames", "3"}, 2, "POV-Ray has no clock in an animation of one frame"},
        {{"-", "--povray"}, 2, "two programs cannot read one standard input"},
        {{"nowhere.scn", "--povray"}, 3, "nowhere.scn"},
        {{"a.scn", "--povray", "--antialias", "grid:10"}, 2, "grid:10: POV-Ray's depth is at most 9"},
        {{"a.scn", "--povray", "--antialias", "method1:2"}, 2, "method1:2: POV-Ray's threshold is at most 1"},
        {{"a.png", "a.png", "--antialias", "grid:3"}, 2, "--antialias: only --povray renders"},
    };
    for (const Row& row : rows) {
        const ProcessResult run = work.compare(row.arguments);
        CAPTURE(row.message);
        CAPTURE(run.standard_error);
        CHECK(run.exit_code == row.exit_code);
        CHECK(says(run.standard_error, row.message));
    }
}

TEST_CASE("compare program: POV-Ray renders the same frames") {
    const Workplace work;
    const ProcessResult still =
        work.compare({"a.scn", "--povray", "--size", "32x24", "--clock", "0.25", "--json", "s.json"});
    CAPTURE(still.standard_error);
    CHECK(still.exit_code == 0);
    CHECK(nlohmann::json::parse(work.content("s.json"))["pairs"][0]["white"] == 65535);
    const ProcessResult animation = work.compare({"a.scn", "--povray", "--size", "32x24", "--frames", "1-12",
                                                  "--subset", "2,12", "--cyclic", "--report", "page"});
    CAPTURE(animation.standard_error);
    CHECK(animation.exit_code == 0);
    CHECK(says(animation.standard_output, "frame 2 "));
    CHECK(says(animation.standard_output, "2 of 2 pairs are equal"));
    // Two frames, not one twice.
    CHECK(work.content("page/pictures/1.a.png") != work.content("page/pictures/2.a.png"));
}

TEST_CASE("compare program: both programs antialias alike, and as an .ini says") {
    const Workplace work;
    const auto same = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--povray", "--size", "40x30", "--clock", "0.25", "--heatmap", "h.png"});
        const ProcessResult run = work.compare(arguments);
        CAPTURE(run.standard_output);
        CAPTURE(run.standard_error);
        CHECK(run.exit_code == 0);
        return work.content("h.png");
    };
    const std::string plain = same({"a.scn"});
    const std::string method1 = same({"a.scn", "--antialias", "method1:0.1:4"});
    CHECK(plain != method1);
    CHECK(same({"a.scn", "--antialias", "grid:3"}) != plain);
    CHECK(same({"a.scn", "--antialias", "method2:0.1:3"}) != method1);
    const auto ini = [&](const std::string& settings) {
        std::ofstream(work.folder / "a.ini") << "Input_File_Name=a.scn\nAntialias=on\n" << settings;
    };
    ini("Jitter=off\nAntialias_Threshold=0.1\nAntialias_Depth=4\n");
    CHECK(same({"a.ini"}) == method1);
    CHECK(same({"a.ini", "--antialias", "none"}) == plain);
    ini("Width=4\nHeight=3\n");
    CHECK(same({"a.ini", "--antialias", "method1:0.1:4"}) == method1);
    const ProcessResult jittered = work.compare({"a.ini", "--povray"});
    CHECK(jittered.exit_code == 2);
    CHECK(says(jittered.standard_error, "a.ini:2: Antialias=on: POV-Ray would jitter the rays"));
}

TEST_CASE("compare program: POV-Ray missing, slow or failing is said, with what to do") {
    const Workplace work;
    const std::string path = std::getenv("PATH");
    const auto with_povray = [&](const std::string& script, std::vector<std::string> more = {}) {
        fs::create_directories(work.folder / "bin");
        fs::remove(work.folder / "bin/povray");
        if (!script.empty()) {
            std::ofstream(work.folder / "bin/povray") << "#!/bin/sh\n" << script;
            fs::permissions(work.folder / "bin/povray", fs::perms::owner_all);
        }
        std::vector<std::string> arguments{"/usr/bin/env",  "PATH=" + (work.folder / "bin").string(),
                                           PROXIMA_PROGRAM, "compare",
                                           "a.scn",         "--povray",
                                           "--size",        "8x6"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_process(arguments, work.folder, 60);
    };
    const ProcessResult missing = with_povray("");
    CHECK(missing.exit_code == 3);
    CHECK(says(missing.standard_error, "povray cannot be started; install POV-Ray 3.7 (Debian: apt install povray"));
    const ProcessResult failing =
        with_povray("echo authors >&2; echo '[Parsing...]' >&2; echo 'line 3: no' >&2; exit 1");
    CHECK(failing.exit_code == 1);
    CHECK(says(failing.standard_error, "line 3: no"));
    CHECK_FALSE(says(failing.standard_error, "authors"));
    CHECK(says(failing.standard_error, "a.scn: POV-Ray ended with code 1"));
    // A shell that ignores SIGTERM, as POV-Ray does.
    const ProcessResult slow = with_povray("trap '' TERM; while :; do :; done", {"--time-limit", "1"});
    CHECK(slow.exit_code == 3);
    CHECK(says(slow.standard_error, "POV-Ray was not ready after 1 seconds and was stopped"));
    const ProcessResult silent = with_povray("exit 0");
    CHECK(silent.exit_code == 3);
    CHECK(says(silent.standard_error, "picture.png: cannot be read"));
}
