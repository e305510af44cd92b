// SPDX-License-Identifier: Apache-2.0
// Text -> TokenProgram: kinds, payloads, and the jumps between directives and brackets.
#include "parser/parse.h"
#include "parser/words.h"

#include <doctest/doctest.h>
#include <string>

using namespace proxima;

namespace {

struct Parsed {
    SourceFiles files;
    SymbolTable symbols;
    Diagnostics diagnostics;
    TokenProgram program;

    explicit Parsed(std::string text) {
        const uint32_t file = files.add_text("scene", std::move(text));
        program = parse_text(files, file, symbols, diagnostics);
    }
    TokenKind kind(size_t index) const { return program.tokens.at(index).kind; }
    std::string first_error() const { return diagnostics.all().empty() ? "" : diagnostics.all().front().message; }
};

} // namespace

TEST_CASE("tokens: every kind is recognised with its place and length") {
    struct Case {
        const char* text;
        TokenKind kind;
    };
    const Case cases[] = {
        {"12.5", TokenKind::number},
        {"\"a\"", TokenKind::string},
        {"Name", TokenKind::name},
        {"sphere", TokenKind::word},
        {"torus", TokenKind::word},
        {"{", TokenKind::left_brace},
        {"}", TokenKind::right_brace},
        {"(", TokenKind::left_paren},
        {")", TokenKind::right_paren},
        {"[", TokenKind::left_bracket},
        {"]", TokenKind::right_bracket},
        {"<", TokenKind::left_angle},
        {">", TokenKind::right_angle},
        {"<=", TokenKind::less_equal},
        {">=", TokenKind::greater_equal},
        {"=", TokenKind::equal},
        {"!=", TokenKind::not_equal},
        {"+", TokenKind::plus},
        {"-", TokenKind::minus},
        {"*", TokenKind::star},
        {"/", TokenKind::slash},
        {"!", TokenKind::bang},
        {"&", TokenKind::ampersand},
        {"|", TokenKind::bar},
        {"?", TokenKind::question},
        {":", TokenKind::colon},
        {",", TokenKind::comma},
        {";", TokenKind::semicolon},
        {".", TokenKind::dot},
        {"#declare", TokenKind::directive},
        {"# declare", TokenKind::directive},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        const Parsed parsed(std::string(" /* x */ ") + test.text + " ");
        REQUIRE(parsed.program.tokens.size() == 2);
        CHECK(parsed.kind(0) == test.kind);
        CHECK(parsed.program.tokens[0].offset == 9);
        CHECK(parsed.program.tokens[0].length == std::string(test.text).size());
        CHECK(parsed.kind(1) == TokenKind::end_of_text);
    }
}

TEST_CASE("tokens: names are symbols, reserved words have fixed ones") {
    const Parsed parsed("Red Red Blue sphere red");
    CHECK(parsed.program.tokens[0].index == parsed.program.tokens[1].index);
    CHECK(parsed.program.tokens[0].index != parsed.program.tokens[2].index);
    CHECK(parsed.program.tokens[3].index == uint32_t(Word::sphere));
    CHECK(parsed.program.tokens[4].index == uint32_t(Word::red));
}

TEST_CASE("tokens: strings know the escapes") {
    const Parsed parsed(R"("a\"b\\c\n")");
    REQUIRE(parsed.program.strings.size() == 1);
    CHECK(parsed.program.strings[0] == "a\"b\\c\n");
    CHECK(Parsed(R"("\q")").first_error() == "unknown escape sequence in a string");
}

TEST_CASE("tokens: brackets know their partners") {
    const Parsed parsed("{ ( [ ] ) }");
    CHECK(parsed.program.tokens[0].target == 5);
    CHECK(parsed.program.tokens[1].target == 4);
    CHECK(parsed.program.tokens[2].target == 3);
}

TEST_CASE("tokens: the directives of a block know each other") {
    //                0   123   4 5       678   9 10    11 12
    const Parsed parsed("#if (A) B #elseif (C) D #else E #end");
    const auto& tokens = parsed.program.tokens;
    REQUIRE(parsed.program.valid);
    CHECK(tokens[0].target == 5);
    CHECK(tokens[5].target == 10);
    CHECK(tokens[10].target == 12);
    CHECK(tokens[0].index == 12);
    CHECK(tokens[5].index == 0);
    CHECK(tokens[12].index == 0);
}

TEST_CASE("tokens: directives that do not fit together are refused") {
    struct Case {
        const char* text;
        const char* message;
    };
    const Case cases[] = {
        {"#if (1)", "this directive has no #end"},
        {"#end", "this #end closes nothing"},
        {"#else", "this directive belongs to no #if"},
        {"#while (1) #else #end", "this directive belongs to no #if"},
        {"#if (1) #else #else #end", "nothing but #end may follow the #else of a block"},
        {"#if (1) #else #elseif (2) #end", "nothing but #end may follow the #else of a block"},
        {"#case (1)", "this directive stands in no #switch"},
        {"#break", "#break stands in no #while, #for or #switch"},
        {"#if (1) #break #end", "#break stands in no #while, #for or #switch"},
        {"#declar A = 1;", "there is no directive #declar"},
        {"# 5", "a directive's name must follow the #"},
        {"\"abc", "this string is not closed"},
        {"/* abc", "this comment is not closed"},
        {"1.2.3", "this is no number"},
        {"$", "unexpected character '$'"},
        {"1e999", "this number is too large or too small for a double"},
    };
    for (const Case& test : cases) {
        CAPTURE(std::string(test.text));
        const Parsed parsed(test.text);
        CHECK(parsed.first_error() == test.message);
        CHECK(!parsed.program.valid);
    }
}

TEST_CASE("tokens: a byte order mark and any line ends are no tokens") {
    CHECK(Parsed("\xef\xbb\xbf"
                 "A\r\nB\rC")
              .program.tokens.size() == 4);
    CHECK(Parsed("").program.tokens.size() == 1);
}

TEST_CASE("tokens: deep nesting is refused, deep comments are not") {
    CHECK(Parsed(std::string(200'000, '(')).first_error() == "brackets stand in each other more than 200 deep");
    std::string ifs;
    for (int i = 0; i < 300; ++i)
        ifs += "#if (1) ";
    CHECK(Parsed(ifs).first_error() == "directives stand in each other more than 200 deep");
    std::string comments;
    for (int i = 0; i < 200'000; ++i)
        comments += "/*";
    for (int i = 0; i < 200'000; ++i)
        comments += "*/";
    CHECK(Parsed(comments).program.valid);
}
