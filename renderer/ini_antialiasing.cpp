// SPDX-License-Identifier: Apache-2.0
#include "renderer/ini_antialiasing.h"
#include "renderer/errors.h"
#include "renderer/ini_value.h"

#include <charconv>
#include <fmt/format.h>

namespace proxima {
namespace {

double number(std::string_view name, std::string_view value, double lowest, double highest) {
    double result = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
    if (error != std::errc() || end != value.data() + value.size() || !(result >= lowest && result <= highest))
        throw UsageError(fmt::format("{}={}: write a number from {} to {}", name, value, lowest, highest));
    return result;
}

} // namespace

bool IniAntialiasing::set(std::string_view name, std::string_view value) {
    const auto is = [&](std::string_view known) { return same_letters(name, known); };
    if (is("Antialias"))
        on_ = ini_flag(name, value);
    else if (is("Jitter"))
        jitter_ = ini_flag(name, value);
    else if (is("Antialias_Threshold"))
        threshold_ = value;
    else if (is("Antialias_Depth"))
        depth_ = value;
    else if (is("Sampling_Method"))
        method_ = value;
    else if (is("Jitter_Amount"))
        jitter_amount_ = value;
    else if (is("Antialias_Gamma"))
        gamma_ = value;
    else
        return false;
    return true;
}

std::string IniAntialiasing::option() const {
    if (!on_)
        return {};
    if (jitter_ && number("Jitter_Amount", jitter_amount_, 0, 1e6) != 0)
        throw UsageError(
            "Antialias=on: POV-Ray would jitter the rays, which Proxima does not; write Jitter=off, or choose "
            "--antialias or --samples yourself");
    if (number("Antialias_Gamma", gamma_, 0, 1e6) != 2.5)
        throw UsageError(fmt::format("Proxima does not support Antialias_Gamma={}; leave it out, it is 2.5", gamma_));
    const double depth = number("Antialias_Depth", depth_, 1, 9);
    const double method = number("Sampling_Method", method_, 1, 2);
    return fmt::format("method{}:{}:{}", int(method), number("Antialias_Threshold", threshold_, 0, 1), int(depth));
}

} // namespace proxima
