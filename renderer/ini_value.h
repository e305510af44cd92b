// SPDX-License-Identifier: Apache-2.0
// How POV-Ray's .ini files spell names and flags.
#pragma once
#include <string_view>

namespace proxima {

/// Whether two words are the same but for small and capital letters.
bool same_letters(std::string_view a, std::string_view b);

/// on, true, yes and 1, or off, false, no and 0. Throws UsageError, which begins with the setting.
bool ini_flag(std::string_view name, std::string_view value);

} // namespace proxima
