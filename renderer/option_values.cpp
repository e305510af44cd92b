// SPDX-License-Identifier: Apache-2.0
#include "renderer/option_values.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

namespace proxima {
namespace {

constexpr uint32_t max_side = 65536;
constexpr uint64_t max_pixels = uint64_t(1) << 31;
constexpr uint32_t max_voxels_along = 65535;
constexpr uint64_t max_voxels = uint64_t(1) << 32;

/// The whole of `text` as a number, or nothing.
template <class Number> std::optional<Number> read_number(std::string_view text) {
    Number value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || text.empty())
        return std::nullopt;
    return value;
}

float parse_clock_value(std::string_view whole, std::string_view text) {
    const auto value = read_number<double>(text);
    if (!value || !std::isfinite(float(*value)))
        throw UsageError(fmt::format(
            "--clock {}: '{}' is not a finite number; write 0.25 for a still, 0:1 for an animation", whole, text));
    return float(*value);
}

bool is_identifier(std::string_view name) {
    const auto is_letter = [](unsigned char c) { return std::isalpha(c) || c == '_'; };
    return !name.empty() && is_letter(static_cast<unsigned char>(name[0])) &&
           std::all_of(name.begin(), name.end(), [&](unsigned char c) { return is_letter(c) || std::isdigit(c); });
}

} // namespace

uint32_t parse_count(std::string_view option, std::string_view text, uint32_t lowest, uint32_t highest) {
    const auto value = read_number<uint64_t>(text);
    if (!value || *value < lowest || *value > highest)
        throw UsageError(fmt::format("{} {}: write a whole number from {} to {}", option, text, lowest, highest));
    return uint32_t(*value);
}

Antialiasing parse_antialiasing(std::string_view text) {
    using Method = Antialiasing::Method;
    const auto wrong = [&](std::string_view what) { return UsageError(fmt::format("--antialias {}: {}", text, what)); };
    std::vector<std::string_view> parts;
    for (size_t start = 0; start <= text.size();) {
        const size_t end = std::min(text.find(':', start), text.size());
        parts.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    const std::map<std::string_view, Method> methods = {
        {"none", Method::none}, {"grid", Method::grid}, {"method1", Method::blocks}, {"method2", Method::squares}};
    const auto method = methods.find(parts[0]);
    if (method == methods.end())
        throw wrong("write none, grid:N, method1[:THRESHOLD[:DEPTH]] or method2[:THRESHOLD[:DEPTH]]");
    Antialiasing result{method->second};
    const bool has_threshold = result.method == Method::blocks || result.method == Method::squares;
    const size_t most_parts = has_threshold ? 3 : result.method == Method::grid ? 2 : 1;
    if (parts.size() > most_parts)
        throw wrong("there are too many parts; write grid:N, method1:THRESHOLD:DEPTH or method2:THRESHOLD:DEPTH");
    if (has_threshold && parts.size() > 1) {
        const auto threshold = read_number<float>(parts[1]);
        if (!threshold || !(*threshold >= 0 && *threshold <= 3))
            throw wrong("the threshold is a number from 0 to 3");
        result.threshold = *threshold;
    }
    if (parts.size() == most_parts && most_parts > 1) {
        const uint32_t deepest = result.method == Method::squares ? 5 : result.method == Method::blocks ? 9 : 64;
        const auto depth = read_number<uint32_t>(parts.back());
        if (!depth || *depth < 1 || *depth > deepest)
            throw wrong(fmt::format("the last part is a whole number from 1 to {}", deepest));
        result.depth = *depth;
    }
    return result;
}

std::pair<uint32_t, uint32_t> parse_size(std::string_view text) {
    const size_t cross = std::min(text.find('x'), text.size());
    const auto width = read_number<uint64_t>(text.substr(0, cross));
    const auto height = read_number<uint64_t>(text.substr(std::min(cross + 1, text.size())));
    if (!width || !height || *width == 0 || *height == 0)
        throw UsageError(fmt::format("--size {}: write width x height in pixels, like 1280x720", text));
    if (*width > max_side || *height > max_side || *width * *height > max_pixels)
        throw UsageError(
            fmt::format("--size {}: a picture has at most {} pixels a side and {} in all; choose a smaller one", text,
                        max_side, max_pixels));
    return {uint32_t(*width), uint32_t(*height)};
}

std::array<uint32_t, 3> parse_grid(std::string_view text) {
    std::vector<uint32_t> counts;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find('x', begin), text.size());
        counts.push_back(parse_count("--grid", text.substr(begin, end - begin), 1, max_voxels_along));
        begin = end + 1;
    }
    if (counts.size() == 1)
        counts.resize(3, counts[0]);
    if (counts.size() != 3)
        throw UsageError(
            fmt::format("--grid {}: write one number of voxels for all axes, or three like 64x32x64", text));
    if (uint64_t(counts[0]) * counts[1] * counts[2] > max_voxels)
        throw UsageError(fmt::format("--grid {}: more than {} voxels; choose a coarser grid", text, max_voxels));
    return {counts[0], counts[1], counts[2]};
}

ClockValues parse_clock(std::string_view text) {
    const size_t colon = text.find(':');
    ClockValues clock{parse_clock_value(text, text.substr(0, colon)), std::nullopt};
    if (colon != std::string_view::npos)
        clock.final = parse_clock_value(text, text.substr(colon + 1));
    return clock;
}

std::pair<double, double> parse_shutter(std::string_view text) {
    const size_t colon = std::min(text.find(':'), text.size());
    const auto open = read_number<double>(text.substr(0, colon));
    const auto close = read_number<double>(text.substr(std::min(colon + 1, text.size())));
    if (!open || !close || !std::isfinite(*open) || !std::isfinite(*close) || *close < *open)
        throw UsageError(fmt::format(
            "--shutter {}: write OPEN:CLOSE in steps from frame to frame, OPEN not above CLOSE, like -0.25:0.25",
            text));
    return {*open, *close};
}

AovLayers parse_layers(std::string_view text) {
    static const std::map<std::string, bool AovLayers::*> choices{{"depth", &AovLayers::depth},
                                                                  {"normal", &AovLayers::normal},
                                                                  {"id", &AovLayers::id},
                                                                  {"steps", &AovLayers::steps}};
    AovLayers layers;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        layers.*parse_choice("--aov", std::string(text.substr(begin, end - begin)), choices) = true;
        begin = end + 1;
    }
    return layers;
}

double parse_ratio(std::string_view option, std::string_view text, std::string_view example) {
    const size_t slash = std::min(text.find('/'), text.size());
    const auto above = read_number<double>(text.substr(0, slash));
    const auto below = slash == text.size() ? std::optional(1.0) : read_number<double>(text.substr(slash + 1));
    const double value = above && below ? *above / *below : -1;
    if (!std::isfinite(value) || value < 0)
        throw UsageError(fmt::format("{} {}: write a number from 0, white being 1, like {}", option, text, example));
    return value;
}

double parse_tolerance(std::string_view text) {
    return parse_ratio("--tolerance", text, "0.004 or 1/255");
}

double parse_percent(std::string_view option, std::string_view text) {
    const auto value = read_number<double>(text.substr(0, text.ends_with('%') ? text.size() - 1 : text.size()));
    if (!value || !(*value >= 0 && *value <= 100))
        throw UsageError(fmt::format("{} {}: write percent from 0 to 100, like 0.1", option, text));
    return *value / 100;
}

std::pair<std::string, std::string> parse_declare(std::string_view text) {
    const size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    if (equals == std::string_view::npos || !is_identifier(name))
        throw UsageError(fmt::format("--declare {}: write NAME=VALUE, like Count=12", text));
    const std::string_view value = text.substr(equals + 1);
    const bool is_string = value.size() >= 2 && value.front() == '"' && value.back() == '"';
    const auto number = read_number<double>(value);
    if (!is_string && !(number && std::isfinite(*number)))
        throw UsageError(fmt::format("--declare {}: the value is neither a number nor a text in double quotes; write "
                                     "'{}=\"{}\"' with the quotes",
                                     text, name, value));
    return {std::string(name), std::string(value)};
}

} // namespace proxima
