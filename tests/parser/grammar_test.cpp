// SPDX-License-Identifier: Apache-2.0
// The grammar by itself: which texts its rules match, and that none of them can loop without consuming.
#include "parser/grammar.h"

#include <bit>
#include <cmath>
#include <doctest/doctest.h>
#include <string>
#include <tao/pegtl/contrib/analyze.hpp>

namespace tao::pegtl {

template <class Name> struct analyze_traits<Name, proxima::grammar::comment_rest> : analyze_any_traits<> {};

template <class Name> struct analyze_traits<Name, proxima::grammar::literal_number> : analyze_any_traits<> {};

} // namespace tao::pegtl

using namespace proxima;

namespace {

/// Whether `Rule` matches the text from its beginning to its end.
template <class Rule> bool matches(const std::string& text) {
    grammar::pegtl::memory_input<> input(text, "");
    return grammar::pegtl::parse<grammar::pegtl::seq<Rule, grammar::pegtl::eof>>(input);
}

} // namespace

TEST_CASE("grammar: no rule can loop without consuming") {
    CHECK(grammar::pegtl::analyze<grammar::scene>(0) == 0);
}

TEST_CASE("grammar: numbers are written as in POV-Ray") {
    for (const char* text : {"0", "12", "1.5", ".5", "5.", "1e3", "1.5E-3", ".5e+10"}) {
        CAPTURE(std::string(text));
        CHECK(matches<grammar::whole_number>(text));
    }
    for (const char* text : {"", ".", "-1", "1e", "1.5.2", "e5", "0x10"}) {
        CAPTURE(std::string(text));
        CHECK(!matches<grammar::whole_number>(text));
    }
}

TEST_CASE("grammar: the fast numbers of literal spheres are std::from_chars's, to the bit") {
    for (const std::string text : {"0",
                                   "-0",
                                   "1",
                                   "0.1",
                                   "-0.1",
                                   "123456789012345",
                                   "1234567890123456",
                                   "0.123456789012345",
                                   "0.1234567890123456789",
                                   ".5",
                                   "5.",
                                   "-5.25",
                                   "1e3",
                                   "1.5E-3",
                                   "9007199254740993",
                                   "0.000000000000001",
                                   "123456.789012345",
                                   "1e-320",
                                   "17.03",
                                   "99999.9999999999",
                                   "3.141592653589793238",
                                   "0.30000000000000004"}) {
        CAPTURE(text);
        double value = NAN, expected = NAN;
        CHECK(read_decimal(text.data(), text.data() + text.size(), value) == text.data() + text.size());
        std::from_chars(text.data(), text.data() + text.size(), expected);
        CHECK(std::bit_cast<uint64_t>(value) == std::bit_cast<uint64_t>(expected));
    }
    for (const std::string text : {"", "-", ".", "-.", "x", "e5", "+1", "1e999"}) {
        CAPTURE(text);
        double value = 0;
        CHECK(read_decimal(text.data(), text.data() + text.size(), value) == nullptr);
    }
}

TEST_CASE("grammar: comments nest and end where they began") {
    for (const char* text :
         {"", " \t\r\n", "// to the end", "// a\n// b\n", "/* a */", "/* a /* b */ c */", "/***/", "/* // */"}) {
        CAPTURE(std::string(text));
        CHECK(matches<grammar::space>(text));
    }
    for (const char* text : {"/*", "/* a", "/* /* */", "/*/"}) {
        CAPTURE(std::string(text));
        CHECK(!matches<grammar::space>(text));
    }
}

TEST_CASE("grammar: names have letters, digits and underscores") {
    for (const char* text : {"a", "A1", "_x", "Long_Name_2"}) {
        CAPTURE(std::string(text));
        CHECK(matches<grammar::identifier>(text));
    }
    for (const char* text : {"1a", "a-b", "", "a.b"}) {
        CAPTURE(std::string(text));
        CHECK(!matches<grammar::identifier>(text));
    }
}

TEST_CASE("grammar: strings end on their line") {
    CHECK(matches<grammar::text>("\"\""));
    CHECK(matches<grammar::text>("\"a \\\" b\""));
    CHECK(!matches<grammar::text>("\"a"));
    CHECK(!matches<grammar::text>("\"a\nb\""));
}

TEST_CASE("grammar: a literal sphere is numbers and at most the name of a texture or a color") {
    for (const char* text :
         {"sphere{<1,2,3>,4}", "sphere { < -1 , .2 , 3e5 > , 0.5 }", "sphere { <1,2,3>, 4 texture { T } }",
          "sphere { <1,2,3>, 4 pigment { rgb <1,0,0> } }", "sphere { <1,2,3>, 4 pigment{color rgb<1,0,0>} }",
          "sphere /* a */ { <1,2,3>, // b\n 4 texture{T}}"}) {
        CAPTURE(std::string(text));
        CHECK(matches<grammar::literal_sphere>(text));
    }
    for (const char* text :
         {"sphere { <1,2>, 3 }", "sphere { 0, 1 }", "sphere { <1,2,3>, 2*2 }", "sphere { <1,2,3>, 4 pigment { P } }",
          "sphere { <1,2,3>, 4 pigment { rgb 1 } }", "sphere { <1,2,3>, 4 pigment { rgbt <1,2,3> } }",
          "sphere { <1,2,3>, 4 pigment { rgb <1,2,3>*2 } }", "spheres { <1,2,3>, 4 }",
          "sphere { <1,2,3>, 4 texture { T scale 2 } }"}) {
        CAPTURE(std::string(text));
        CHECK(!matches<grammar::literal_sphere>(text));
    }
}
