// SPDX-License-Identifier: Apache-2.0
// Strings and their functions, seen through #warning.
#include "tests/parser/evaluate.h"

using namespace proxima;
using namespace proxima::testing;

namespace {

std::string string_of(const std::string& expression) {
    const Evaluated result = evaluate("#warning " + expression);
    INFO(result.messages);
    return result.diagnostics.all().empty() ? "" : result.diagnostics.all()[0].message;
}

} // namespace

TEST_CASE("strings: functions that make them") {
    struct Case {
        const char* text;
        const char* value;
    };
    const Case cases[] = {
        {"\"a\"", "a"},
        {"concat(\"a\", \"b\", \"c\")", "abc"},
        {"str(12.3456, 10, 2)", "     12.35"},
        {"str(12.3456, -10, 2)", "0000012.35"},
        {"str(12.3456, 0, -1)", "12.345600"},
        {"str(-1.5, 8, 1)", "    -1.5"},
        {"str(-1.5, -8, 1)", "-00001.5"},
        {"str(7, -4, 0)", "0007"},
        {"vstr(3, <1, 2, 3>, \"; \", 0, 1)", "1.0; 2.0; 3.0"},
        {"substr(\"abcdef\", 2, 3)", "bcd"},
        {"strupr(\"aBc\")", "ABC"},
        {"strlwr(\"aBc\")", "abc"},
        {"chr(65)", "A"},
        {"concat(\"n\", str(strlen(\"abc\"), 0, 0))", "n3"},
        {"str(val(\"12.5\"), 0, 1)", "12.5"},
        {"str(asc(\"B\"), 0, 0)", "66"},
        {"str(strcmp(\"a\", \"b\"), 0, 0)", "-1"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        CHECK(string_of(test.text) == test.value);
    }
}

TEST_CASE("strings: mistakes") {
    CHECK(error_of("#warning substr(\"abc\", 3, 2)") == "the string has 3 characters and no such part");
    CHECK(error_of("#warning chr(300)") == "chr takes a number from 1 to 127");
    CHECK(error_of("#warning str(val(\"x\"), 0, 0)") == "\"x\" is no number");
    CHECK(error_of("#warning 5") == "unexpected '5'");
    CHECK(error_of("#declare S = \"a\"; sphere { S, 1 }") == "unexpected 'S', which is a string");
}
