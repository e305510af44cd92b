// SPDX-License-Identifier: Apache-2.0
// Strings: literals, names, and the functions that make them or measure them.
#include "parser/evaluator.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>

namespace proxima {
namespace {

/// As printf's %*.*f: a negative `length` pads with zeros, a negative `precision` is 6 digits.
std::string formatted(double value, double length, double precision) {
    const int width = int(std::min(std::abs(length), 1000.0));
    const int digits = precision < 0 ? 6 : int(std::min(precision, 300.0));
    return length < 0 ? fmt::format("{:0{}.{}f}", value, width, digits)
                      : fmt::format("{:{}.{}f}", value, width, digits);
}

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
}
char upper(char c) {
    return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
}

} // namespace

bool Evaluator::starts_string() {
    const Token& token = peek();
    if (token.kind == TokenKind::string)
        return true;
    if (token.kind == TokenKind::word)
        return token.index >= uint32_t(Word::str) && token.index <= uint32_t(Word::strlwr);
    return identifier<std::string>() != nullptr;
}

std::string Evaluator::string() {
    if (!starts_string())
        fail_unexpected("a string");
    const Nesting nesting(*this);
    const Token& token = peek();
    if (token.kind == TokenKind::string) {
        advance();
        return program_->strings[token.index];
    }
    if (token.kind == TokenKind::name) {
        std::string value = std::get<std::string>(*named_value(token));
        advance();
        return value;
    }
    advance();
    expect(TokenKind::left_paren);
    std::string result;
    switch (Word(token.index)) {
    case Word::str: {
        const double value = number();
        separator();
        const double length = number();
        separator();
        result = formatted(value, length, number());
        break;
    }
    case Word::vstr: {
        const double count = number();
        separator();
        const Token& at = peek();
        const Terms terms = sum();
        if (!(count >= 2 && count <= 5) || terms.count == 1)
            fail(at, "vstr takes a vector and its number of terms, 2 to 5");
        if (terms.nodes)
            look_at(span(at), at, terms.nodes);
        separator();
        const std::string between = string();
        separator();
        const double length = number();
        separator();
        const double precision = number();
        for (int i = 0; i < int(count); ++i)
            result += (i > 0 ? between : "") + formatted(i < terms.count ? terms.value[i] : 0, length, precision);
        break;
    }
    case Word::concat:
        do {
            result += string();
            charge(result.size());
            if (result.size() > 1'000'000)
                fail(token, "this string is longer than a million characters");
        } while (accept(TokenKind::comma));
        break;
    case Word::chr: {
        const double code = number();
        if (!(code >= 1 && code <= 127))
            fail(token, "chr takes a number from 1 to 127");
        result = std::string(1, char(code));
        break;
    }
    case Word::substr: {
        const std::string text = string();
        separator();
        const double start = number();
        separator();
        const double length = number();
        if (!(start >= 1 && length >= 0 && start - 1 + length <= double(text.size())))
            fail(token, fmt::format("the string has {} characters and no such part", text.size()));
        result = text.substr(size_t(start) - 1, size_t(length));
        break;
    }
    case Word::strupr:
    case Word::strlwr:
        result = string();
        std::ranges::transform(result, result.begin(), Word(token.index) == Word::strupr ? upper : lower);
        break;
    default:
        fail(token, fmt::format("Proxima does not support '{}'", spelling(token)));
    }
    expect(TokenKind::right_paren);
    return result;
}

double Evaluator::string_function(const Token& token) {
    const std::string text = string();
    switch (Word(token.index)) {
    case Word::asc:
        if (text.empty())
            fail(token, "asc of an empty string");
        return double(uint8_t(text.front()));
    case Word::strcmp: {
        separator();
        const int order = text.compare(string());
        return order < 0 ? -1 : order > 0 ? 1 : 0;
    }
    case Word::strlen:
        return double(text.size());
    case Word::file_exists:
        try {
            return sources_.files.find(text) ? 1 : 0;
        } catch (const FileError& error) {
            fail(token, error.what());
        }
    default: {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        if (end == text.c_str() || !std::isfinite(value))
            fail(token, fmt::format("\"{}\" is no number", text));
        return value;
    }
    }
}

} // namespace proxima
