// SPDX-License-Identifier: Apache-2.0
// The front door: a file on disk, its includes, evaluated for several frames.
#include "parser/scene_script.h"
#include "tests/folder.h"

#include <cstdio>
#include <doctest/doctest.h>
#include <filesystem>

using namespace proxima;
using namespace proxima::testing;
namespace fs = std::filesystem;

TEST_CASE("script: read once, evaluated for every frame") {
    const Folder folder;
    const fs::path path = folder.write("a.scn", "#include \"b.inc\"\nsphere { clock*x, Radius }");
    folder.write("b.inc", "#local Hidden = 2; #declare Radius = Hidden + 1;");
    Diagnostics diagnostics;
    SceneScript script(path, {}, diagnostics);
    REQUIRE(!diagnostics.has_errors());
    for (int frame = 0; frame < 3; ++frame) {
        EvaluationSettings settings;
        settings.time.clock = frame;
        const SceneProgram scene = script.evaluate(settings, diagnostics);
        REQUIRE(scene.spheres.size() == 1);
        CHECK(scene.spheres[0].center.x == frame);
        CHECK(scene.spheres[0].radius == 3);
        CHECK(scene.depends_on_time);
    }
    CHECK(!diagnostics.has_errors());
    CHECK(script.files().size() == 2);
}

TEST_CASE("script: names of an include file live as in POV-Ray") {
    const Folder folder;
    folder.write("inner.inc", "#local L = 1; #declare M = 7; #local G = 5; #declare G = 6; sphere { <L, M, G>, 1 }");
    const fs::path path = folder.write("a.scn", "#local M = 3; #declare G = 2; #include \"inner.inc\"\n"
                                                "sphere { <0, M, G>, 1 } #ifdef (L) foo #end");
    Diagnostics diagnostics;
    SceneScript script(path, {}, diagnostics);
    const SceneProgram scene = script.evaluate({}, diagnostics);
    CHECK(diagnostics.format(script.files()) == "");
    REQUIRE(scene.spheres.size() == 2);
    CHECK(scene.spheres[0].center == Vec3<double>(1, 7, 6));
    CHECK(scene.spheres[1].center == Vec3<double>(0, 7, 2));
}

TEST_CASE("script: mistakes in a file are found while it is parsed, those in an include when it is read") {
    const Folder folder;
    folder.write("bad.inc", "sphere { 0, \"x }");
    folder.write("missing_end.inc", "\n#if (1)");
    Diagnostics parsing;
    SceneScript broken(folder.write("a.scn", "#if (1)"), {}, parsing);
    CHECK(parsing.error_count() == 1);
    CHECK(broken.evaluate({}, parsing).spheres.empty());

    Diagnostics diagnostics;
    SceneScript script(folder.write("b.scn", "#include \"bad.inc\"\n#include \"missing_end.inc\"\nfoo"), {},
                       diagnostics);
    CHECK(!diagnostics.has_errors());
    script.evaluate({}, diagnostics);
    const std::string text = diagnostics.format(script.files());
    CHECK(text.find("bad.inc:1:") != std::string::npos);
    CHECK(text.find("missing_end.inc:2:1: error: this directive has no #end") != std::string::npos);
    CHECK(text.find("b.scn:3:1: error: 'foo' is not declared") != std::string::npos);
}

TEST_CASE("script: files that include each other end in a message") {
    const Folder folder;
    const fs::path path = folder.write("a.scn", "#include \"a.scn\"");
    Diagnostics diagnostics;
    SceneScript script(path, {}, diagnostics);
    script.evaluate({}, diagnostics);
    CHECK(diagnostics.all().at(0).message == "files include each other more than 100 deep");
    CHECK_THROWS_AS(SceneScript(folder.path / "none.scn", {}, diagnostics), FileError);
}

TEST_CASE("script: a scene from standard input finds its files in the working folder") {
    const Folder folder;
    folder.write("radius.inc", "#declare Radius = 3;");
    const fs::path scene = folder.write("scene.txt", "#include \"radius.inc\" sphere { 0, Radius }");
    const fs::path before = fs::current_path();
    fs::current_path(folder.path);
    REQUIRE(std::freopen(scene.c_str(), "r", stdin));
    Diagnostics diagnostics;
    SceneScript script("-", {}, diagnostics);
    const SceneProgram program = script.evaluate({}, diagnostics);
    fs::current_path(before);
    CHECK(diagnostics.format(script.files()) == "");
    REQUIRE(program.spheres.size() == 1);
    CHECK(program.spheres[0].radius == 3);
    CHECK(script.files().name(0) == "<stdin>");
}

TEST_CASE("script: every example is free of mistakes and warnings") {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(PROXIMA_EXAMPLES)) {
        if (entry.path().extension() != ".scn")
            continue;
        ++count;
        CAPTURE(entry.path());
        Diagnostics diagnostics;
        SceneScript script(entry.path(), {}, diagnostics);
        const SceneProgram scene = script.evaluate({}, diagnostics);
        CHECK(diagnostics.format(script.files()) == "");
        CHECK(scene.spheres.size() + scene.ellipsoids.size() > 0);
    }
    CHECK(count >= 10);
}
