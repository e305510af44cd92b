// SPDX-License-Identifier: Apache-2.0
// A POV-Ray .ini file in, the texts of our own options out. What would change the picture and is not here is refused.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace proxima {

/// Each text is what a user would write on the command line; empty where the file says nothing.
struct IniOptions {
    std::string scene, size, frames, subset, clock, output, bits, threads, antialias;
    std::vector<std::string> declares, include_paths;
    bool cyclic = false;
    std::string antialias_refusal; ///< for whom the file's antialiasing counts, why there is none like it here
};

/// Whether a command's SCENE is an .ini file, `name.ini` or `name.ini[section]`.
bool is_povray_ini(std::string_view scene);

/// Reads the lines before the first section and those of `section`, if any. The scene is looked for in the working
/// folder, then beside the file. Throws FileError, and UsageError with file and line.
IniOptions read_povray_ini(const std::string& scene);

/// The same of a text. `name` is for messages.
IniOptions parse_povray_ini(std::string_view text, std::string_view section, const std::string& name);

} // namespace proxima
