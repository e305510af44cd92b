// SPDX-License-Identifier: Apache-2.0
// POV-Ray's standard include files, known by name without the files: their names and values, written anew in the scene
// language, and the names that Proxima refuses because they need what it does not have.
#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace proxima {

/// Names that need one word of the language.
struct RefusedNames {
    std::string_view word;  ///< one that Proxima does not support
    std::string_view names; ///< separated by blanks
};

struct StandardFile {
    std::string_view name;  ///< "colors.inc"
    std::string_view guard; ///< declared where the file is first read; then it is not read again. "" in files without
    std::string (*text)();  ///< what Proxima knows of it, or nullptr
    std::span<const RefusedNames> refused;
    bool sets_version = true; ///< to what it was before, as a #version statement
};

/// Nullptr when `name` is not a standard file.
const StandardFile* find_standard_file(std::string_view name);

/// The file as a scene includes it: its text, between the #version statements that such files have.
std::string standard_text(const StandardFile& file);

/// The standard file that declares `identifier`, known or refused, or nullptr.
const StandardFile* standard_file_of(std::string_view identifier);

/// Calls use(name) for each name.
template <class Use> void for_each_name(const RefusedNames& refused, const Use& use) {
    for (size_t begin = 0; begin < refused.names.size();) {
        const size_t end = std::min(refused.names.find(' ', begin), refused.names.size());
        use(refused.names.substr(begin, end - begin));
        begin = end + 1;
    }
}

} // namespace proxima
