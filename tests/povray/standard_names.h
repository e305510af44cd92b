// SPDX-License-Identifier: Apache-2.0
// The names that an include file of POV-Ray declares.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace proxima::testing {

struct StandardName {
    std::string name;
    bool is_called = false; ///< a macro or a function
};

/// Each name once, in the order of the file; not those that its macros declare when they are called, and not those that
/// it takes back with #undef.
std::vector<StandardName> standard_names(const std::filesystem::path& path);

} // namespace proxima::testing
