// SPDX-License-Identifier: Apache-2.0
// The names of files that are being made: hidden, beside the file that they will be, with the machine that makes them
// and a number in it. They say what becomes of those that a killed program left behind.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace proxima {

/// A name that nobody has, in the folder of `path`.
std::filesystem::path temporary_name(const std::filesystem::path& path);

struct TemporaryName {
    std::string file;        ///< the name that it was to get; a very long one is cut
    bool is_of_this_machine; ///< and made since it was started
};

/// What a file's name (without folders) says, if it is one of ours.
std::optional<TemporaryName> parse_temporary_name(const std::string& name);

/// The part of a file's name that temporary names have.
std::string kept_part(const std::string& file);

} // namespace proxima
