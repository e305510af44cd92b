// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_rate.h"
#include "renderer/errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace proxima {
namespace {

constexpr double slowest = 0.01, fastest = 1000; // frames a second

[[noreturn]] void fail(std::string_view text) {
    throw UsageError(fmt::format("--fps {}: write frames a second from {} to {}, like 24, 29.97 or 30000/1001", text,
                                 slowest, fastest));
}

template <class Number> Number number(std::string_view whole, std::string_view text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end)
        fail(whole);
    return value;
}

FrameRate reduced(uint64_t numerator, uint64_t denominator) {
    const uint64_t common = std::gcd(numerator, denominator);
    return {uint32_t(numerator / common), uint32_t(denominator / common)};
}

} // namespace

FrameRate parse_frame_rate(std::string_view text) {
    FrameRate rate;
    if (const size_t slash = text.find('/'); slash != std::string_view::npos) {
        const auto above = number<uint32_t>(text, text.substr(0, slash));
        const auto below = number<uint32_t>(text, text.substr(slash + 1));
        if (above == 0 || below == 0)
            fail(text);
        rate = reduced(above, below);
    } else {
        const double value = number<double>(text, text);
        if (!(value >= slowest && value <= fastest))
            fail(text);
        const double up = std::ceil(value);
        // 23.976 and the like are 1000/1001 of a whole number.
        rate = value != up && std::abs(value - up * 1000 / 1001) < 0.0051 ? reduced(uint64_t(up) * 1000, 1001)
                                                                          : reduced(std::llround(value * 1000), 1000);
    }
    const double value = double(rate.numerator) / rate.denominator;
    if (!(value >= slowest && value <= fastest))
        fail(text);
    return rate;
}

TimeCode time_code(int64_t frame, const FrameRate& rate) {
    const int64_t a_second = std::max(1u, rate.nominal());
    const int64_t a_day = a_second * 86400;
    const int64_t of_day = (frame % a_day + a_day) % a_day;
    const int64_t second = of_day / a_second;
    return {uint32_t(second / 3600), uint32_t(second / 60 % 60), uint32_t(second % 60), uint32_t(of_day % a_second)};
}

} // namespace proxima
