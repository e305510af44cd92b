// SPDX-License-Identifier: Apache-2.0
#include "renderer/ini_value.h"
#include "renderer/errors.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fmt/format.h>

namespace proxima {

bool same_letters(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b,
                              [](char x, char y) { return std::tolower(uint8_t(x)) == std::tolower(uint8_t(y)); });
}

bool ini_flag(std::string_view name, std::string_view value) {
    for (const std::string_view yes : {"on", "true", "yes", "1"})
        if (same_letters(value, yes))
            return true;
    for (const std::string_view no : {"off", "false", "no", "0", "0.0"})
        if (same_letters(value, no))
            return false;
    throw UsageError(fmt::format("{}={}: write on or off", name, value));
}

} // namespace proxima
