// SPDX-License-Identifier: Apache-2.0
#include "parser/data_file.h"

#include "parser/decimal.h"
#include "parser/string_escapes.h"

#include <algorithm>

namespace proxima {

void DataFile::fail(const char* message, const char* hint) const {
    throw SceneError({{file_, uint32_t(at_)}, 1}, message, hint);
}

bool DataFile::accept(char c) {
    if (peek() != c)
        return false;
    ++at_;
    return true;
}

void DataFile::skip_space() {
    for (; at_ < text_.size(); ++at_) {
        const char c = text_[at_];
        if (c == '/')
            skip_comment();
        else if (c != ' ' && !(c >= '\t' && c <= '\r'))
            return;
    }
}

/// Goes to the last character of the comment that begins here.
void DataFile::skip_comment() {
    const char second = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    if (second == '/') {
        at_ = std::min(text_.find('\n', at_), text_.size() - 1);
        return;
    }
    if (second != '*')
        fail("unexpected '/'", "expected a number, a vector or a string");
    size_t depth = 1;
    size_t end = at_ + 2;
    for (; depth > 0 && end + 1 < text_.size(); ++end) {
        const bool opens = text_[end] == '/' && text_[end + 1] == '*';
        const bool closes = text_[end] == '*' && text_[end + 1] == '/';
        depth = opens ? depth + 1 : closes ? depth - 1 : depth;
        end += opens || closes ? 1 : 0;
    }
    if (depth > 0)
        fail("this comment is not closed");
    at_ = end - 1;
}

bool DataFile::read(Value& value) {
    skip_space();
    if (at_ == text_.size()) {
        ended_ = true;
        return false;
    }
    if (peek() == '<')
        value = vector();
    else if (peek() == '"')
        value = string();
    else
        value = Terms(number());
    skip_space();
    if (at_ == text_.size())
        ended_ = true;
    else if (!accept(','))
        fail("a comma must stand here", "expected ',' between two values: POV-Ray would drop what stands here");
    return true;
}

double DataFile::number() {
    const bool negative = accept('-');
    if (!negative)
        accept('+');
    if (negative || peek() == ' ')
        skip_space();
    double value = 0;
    const char* const begin = text_.data() + at_;
    const bool starts = uint8_t(peek() - '0') < 10 || peek() == '.';
    const char* const end = starts ? read_decimal(begin, text_.data() + text_.size(), value) : nullptr;
    if (!end)
        fail(starts ? "this is no number, or too large or too small for a double" : "no value begins here",
             "expected a number, a vector like <1, 2, 3> or a string in double quotes");
    at_ += size_t(end - begin);
    return negative ? -value : value;
}

Terms DataFile::vector() {
    accept('<');
    Terms terms;
    for (terms.count = 0;;) {
        skip_space();
        if (terms.count >= 2 && accept('>'))
            return terms;
        if (terms.count == 5)
            fail("a vector has at most 5 terms", "expected '>'");
        terms.value[terms.count] = number();
        ++terms.count;
        skip_space();
        accept(',');
    }
}

std::string DataFile::string() {
    const size_t begin = at_ + 1;
    size_t end = begin;
    while (end < text_.size() && text_[end] != '"')
        end += text_[end] == '\\' ? 2 : 1;
    if (end >= text_.size())
        fail("this string is not closed");
    std::string value;
    const size_t bad = unescape(text_.substr(begin, end - begin), value);
    if (bad != std::string_view::npos) {
        at_ = begin + bad;
        fail("unknown escape sequence in a string", "expected \\n, \\t, \\\", \\' or \\\\");
    }
    at_ = end + 1;
    return value;
}

} // namespace proxima
