// SPDX-License-Identifier: Apache-2.0
// The escape sequences of strings, in scenes and in data files.
#pragma once
#include <string>
#include <string_view>

namespace proxima {

/// Appends the characters that `inner`, a string without its quotes, stands for. Returns where an unknown escape
/// sequence begins, or npos.
inline size_t unescape(std::string_view inner, std::string& value) {
    size_t bad = std::string_view::npos;
    for (size_t i = 0; i < inner.size(); ++i) {
        if (inner[i] != '\\') {
            value += inner[i];
            continue;
        }
        const size_t begin = i;
        switch (++i < inner.size() ? inner[i] : '\0') {
        case 'n':
            value += '\n';
            break;
        case 't':
            value += '\t';
            break;
        case '\\':
        case '"':
        case '\'':
            value += inner[i];
            break;
        default:
            if (bad == std::string_view::npos)
                bad = begin;
        }
    }
    return bad;
}

} // namespace proxima
