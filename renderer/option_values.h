// SPDX-License-Identifier: Apache-2.0
// The text of one option in, its value out. Each function names the option in the UsageError that it throws, and says
// what to write instead.
#pragma once
#include "parser/diagnostics.h"
#include "renderer/errors.h"
#include "renderer/options.h"

#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace proxima {

/// A whole number in [lowest, highest].
uint32_t parse_count(std::string_view option, std::string_view text, uint32_t lowest, uint32_t highest);

/// "none", "grid:N", "method1" or "method2" with ":THRESHOLD" and ":DEPTH" behind it.
Antialiasing parse_antialiasing(std::string_view text);

/// "640x480": at most 65536 a side and 2^31 pixels.
std::pair<uint32_t, uint32_t> parse_size(std::string_view text);

/// "64" or "64x32x64".
std::array<uint32_t, 3> parse_grid(std::string_view text);

/// "0.3" or "0:1": one clock or the first and the last.
struct ClockValues {
    float initial = 0.0f;
    std::optional<float> final;
};
ClockValues parse_clock(std::string_view text);

/// OPEN:CLOSE of --shutter; it does not close before it opens.
std::pair<double, double> parse_shutter(std::string_view text);

/// "depth,normal,id,steps" or some of them.
AovLayers parse_layers(std::string_view text);

/// "0.01" or "2/65535": from 0. `example` is for who wrote something else.
double parse_ratio(std::string_view option, std::string_view text, std::string_view example);

/// The same for --tolerance.
double parse_tolerance(std::string_view text);

/// "0.1": percent, as a share from 0 to 1.
double parse_percent(std::string_view option, std::string_view text);

/// "NAME=2.5" or "NAME=\"text\"".
std::pair<std::string, std::string> parse_declare(std::string_view text);

/// One of a few words.
template <class Value>
Value parse_choice(std::string_view option, const std::string& text, const std::map<std::string, Value>& choices) {
    if (const auto found = choices.find(text); found != choices.end())
        return found->second;
    std::vector<std::string_view> names;
    for (const auto& [name, value] : choices)
        names.push_back(name);
    const std::string near = nearest_name(text, names);
    throw UsageError(fmt::format("{} {}: not one of {}{}", option, text, fmt::join(names, ", "),
                                 near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

} // namespace proxima
