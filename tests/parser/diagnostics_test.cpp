// SPDX-License-Identifier: Apache-2.0
// How mistakes look, and near names.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("diagnostics: a mistake shows its place, its line, a caret and what to do") {
    CHECK(evaluate("sphere { 0,\n  Raduis }\n#declare Radius = 1;").messages ==
          "scene:2:3: error: 'Raduis' is not declared\n"
          "    Raduis }\n"
          "    ^~~~~~\n"
          "  did you mean 'radius'?\n");
    CHECK(evaluate("#declare Radius = 1;\nsphere { 0, Raduis }").messages ==
          "scene:2:13: error: 'Raduis' is not declared\n"
          "  sphere { 0, Raduis }\n"
          "              ^~~~~~\n"
          "  did you mean 'Radius'?\n");
}

TEST_CASE("diagnostics: a tab does not shift the caret, a long line is cut around the place") {
    CHECK(evaluate("\tQux").messages == "scene:1:2: error: 'Qux' is not declared\n   Qux\n   ^~~\n"
                                        "  expected an object, a light, the camera, a setting or a directive\n");
    const std::string messages = evaluate(std::string(500, ' ') + "foo" + std::string(500, ' ') + ";").messages;
    CHECK(messages.find("scene:1:501:") == 0);
    CHECK(messages.size() < 400);
}

TEST_CASE("diagnostics: the same place is reported once, and of many mistakes twenty are shown") {
    Diagnostics diagnostics;
    SourceFiles files;
    files.add_text("scene", std::string(100, 'x'));
    for (int round = 0; round < 2; ++round)
        for (uint32_t i = 0; i < 25; ++i)
            diagnostics.error({{0, i}, 1}, "wrong");
    CHECK(diagnostics.error_count() == 25);
    const std::string text = diagnostics.format(files);
    CHECK(text.find("5 more mistakes are not shown\n") != std::string::npos);
}

TEST_CASE("diagnostics: near names") {
    const std::string_view names[] = {"sphere", "plane", "White", "Radius", "x"};
    struct Case {
        const char* name;
        const char* nearest;
    };
    for (const Case& test :
         {Case{"sphre", "sphere"}, Case{"shpere", "sphere"}, Case{"Spheer", "sphere"}, Case{"white", "White"},
          Case{"Raduis", "Radius"}, Case{"Q", ""}, Case{"camera", ""}, Case{"Flake", ""}}) {
        CAPTURE(std::string(test.name));
        CHECK(nearest_name(test.name, names) == test.nearest);
    }
}

TEST_CASE("diagnostics: names that nobody used are notes, and only without mistakes") {
    CHECK(evaluate("#declare Used = 1; #declare Unused = 2; sphere { 0, Used }").messages ==
          "scene:1:29: note: 'Unused' is declared and not used\n"
          "  #declare Used = 1; #declare Unused = 2; sphere { 0, Used }\n"
          "                              ^~~~~~\n");
    CHECK(evaluate("#declare Unused = 2; sphere { 0, Missing }").messages.find("note") == std::string::npos);
}

TEST_CASE("diagnostics: a word that POV-Ray has and Proxima has not is named, with advice") {
    CHECK(evaluate("box { 0, 1 }").messages == "scene:1:1: error: Proxima does not support 'box'\n"
                                               "  box { 0, 1 }\n"
                                               "  ^~~\n"
                                               "  use spheres and planes: they are the only shapes\n");
    for (const char* word : {"cone", "difference", "merge", "blob", "isosurface", "rainbow", "mesh2"}) {
        CAPTURE(std::string(word));
        CHECK(error_of(std::string(word) + " { }") == std::string("Proxima does not support '") + word + "'");
    }
}
