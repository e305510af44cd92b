// SPDX-License-Identifier: Apache-2.0
// Scenes that would take for ever, or the whole stack.
#include "tests/parser/evaluate.h"

#include <ctime>

using namespace proxima;
using namespace proxima::testing;

TEST_CASE("limits: a loop in which nothing changes is found at once") {
    const std::string message = "this loop never ends: nothing that its condition could depend on changes in it";
    CHECK(error_of("#while (1) #end") == message);
    CHECK(error_of("#declare I = 0; #while (I < 5) sphere { I, 1 } #end") == message);
    CHECK(error_of("#declare I = 0; #while (I < 5) #declare J = 2; #end") == message);
}

TEST_CASE("limits: other endless loops end at the step limit, which names the loop") {
    EvaluationSettings settings;
    settings.budget.steps = 100'000;
    const Evaluated result = evaluate("#declare I = 0;\n#while (1) #declare I = I + 1; #end", settings);
    CHECK(result.messages.find("scene:2:1: error: the scene takes more than 100000 steps to evaluate") == 0);
    CHECK(error_of("#for (I, 0, 1e12) #end", settings) == "the scene takes more than 100000 steps to evaluate");
}

TEST_CASE("limits: who needs more steps is told how far the loop came and how many will do") {
    const std::string scene = "#declare N = 0;\n"
                              "#for (I, 1, 20000)\n"
                              "  #for (J, 1, 3) sphere { <I, J, sin(clock + J)>, 0.1 } #end\n"
                              "#end\n";
    EvaluationSettings settings;
    settings.record_motion = true;
    settings.budget.steps = 1'000'000;
    const std::string said = evaluate(scene, settings).messages;
    CHECK(said.find("scene:2:1: error: the scene takes more than 1 million steps to evaluate") == 0);
    const auto number_behind = [&](const std::string& words) {
        const size_t place = said.find(words);
        REQUIRE_MESSAGE(place != std::string::npos, said);
        return std::stoull(said.substr(place + words.size()));
    };
    CHECK(number_behind("does this loop end? ") > 1000);
    CHECK(said.find(" of its 20000 rounds are done; --max-steps ") != std::string::npos);
    const uint64_t enough = number_behind("--max-steps ");
    CHECK(enough < 10);
    settings.budget.steps = enough * 1'000'000;
    CHECK(evaluate(scene, settings).scene.spheres.size() == 60'000);

    // Where no end is in sight, none is promised.
    settings.budget.steps = 100'000;
    for (const char* endless : {"#declare I = 0; #while (1) #declare I = I + 1; #end", "#for (I, 0, 1e12) #end",
                                "#for (I, 1, 9) #declare J = 0; #while (1) #declare J = J + 1; #end #end"}) {
        const std::string message = evaluate(endless, settings).messages;
        CAPTURE(message);
        CHECK(message.find("does this loop end? ") != std::string::npos);
        CHECK(message.find("should do") == std::string::npos);
    }
}

TEST_CASE("limits: nesting of every kind ends in a message") {
    const auto repeat = [](const std::string& text, int count) {
        std::string result;
        for (int i = 0; i < count; ++i)
            result += text;
        return result;
    };
    const std::string deep = "this is nested more than 200 deep";
    CHECK(error_of("sphere { " + repeat("-", 100'000) + "1, 1 }") == deep);
    CHECK(error_of("sphere { " + repeat("!", 100'000) + "1, 1 }") == deep);
    CHECK(error_of("sphere { (1 " + repeat("? 2 : 1 ", 100'000) + "), 1 }") == deep);
    CHECK(error_of("sphere { " + repeat("<", 100'000) + ", 1 }") == deep);
    CHECK(error_of(repeat("union { ", 100'000)) == "brackets stand in each other more than 200 deep");
    CHECK(error_of("sphere { " + repeat("sin(", 100'000) + ", 1 }") ==
          "brackets stand in each other more than 200 deep");
    CHECK(error_of("sphere { 0, 1 " + repeat("texture { pigment { ", 150) + "}") ==
          "brackets stand in each other more than 200 deep");
    CHECK(error_of(repeat("#declare A = ", 100'000)) != "");
}

TEST_CASE("limits: strings do not grow without end") {
    CHECK(error_of("#declare S = \"abcdefgh\" #for (I, 1, 40) #declare S = concat(S, S) #end") ==
          "this string is longer than a million characters");
    CHECK(evaluate("#warning str(1, 1e9, 1e9)").diagnostics.error_count() == 0);
}

TEST_CASE("limits: numbers that overflow a place are refused") {
    CHECK(error_of("sphere { 1e308*10, 1 }") == "a vector is not finite");
    CHECK(error_of("sphere { 0, 1e308*10 }") == "this number is not finite");
    CHECK(error_of("sphere { 0, 1 pigment { rgb 1e308*10 } }") == "this color is not finite");
    CHECK(error_of("#for (I, 0, 1e308*10) #end") == "this number is not finite");
}

TEST_CASE("limits: memory and time end in a message") {
    EvaluationSettings little;
    little.budget.bytes = 256 << 20;
    const std::string memory = "the scene takes more than 256 MB of memory to evaluate";
    CHECK(error_of("#declare A = array[10000][10000];", little) == memory);
    CHECK(error_of("#declare U = sphere { x, 1 } #for (I, 1, 40) #declare U = union { object { U } object { U } } #end",
                   little) == memory);
    CHECK(error_of("#declare S = \"x\"; #for (I, 1, 18) #declare S = concat(S, S) #end\n"
                   "#declare A = array[10000]; #for (I, 0, 9999) #declare A[I] = concat(S, \"y\") #end",
                   little) == memory);
    CHECK(scene_of("#for (I, 1, 1000000) #declare S = str(I, 0, 0) #end sphere { 0, 1 }", little).spheres.size() == 1);

    EvaluationSettings hurried;
    hurried.budget.seconds = 0.05;
    CHECK(error_of("#declare I = 0; #while (1) #declare I = I + 1; #end", hurried) ==
          "the scene takes more than 0.05 seconds to evaluate");
}

TEST_CASE("limits: mistakes by the thousand do not take long") {
    const auto seconds_for = [](const std::string& text) {
        const std::clock_t start = std::clock();
        CHECK(evaluate(text).diagnostics.has_errors());
        return double(std::clock() - start) / CLOCKS_PER_SEC;
    };
    std::string undeclared;
    for (int i = 0; i < 300; ++i)
        undeclared += "sphere { Name" + std::to_string(i) + ", 1 }\n";
    CHECK(seconds_for(undeclared) < 1);
    // The same mistake in each of ten thousand macros that call each other, on the way out of them.
    CHECK(seconds_for("#macro M() M() #declare A = functionn(1); #end M()") < 1);
}
