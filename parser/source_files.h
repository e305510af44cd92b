// SPDX-License-Identifier: Apache-2.0
// The texts that a scene is made of: files mapped into memory, found by the sandbox's rules, and named by an index.
// A scene reads only below its own folder and below the include paths.
#pragma once
#include "parser/source_location.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace proxima {

/// A file cannot be read, or may not be. The message names it and says why.
class FileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Line and column count from 1; a column is a byte.
struct LineColumn {
    uint32_t line = 1;
    uint32_t column = 1;
};

class SourceFiles {
public:
    SourceFiles() = default;
    ~SourceFiles();
    SourceFiles(const SourceFiles&) = delete;
    SourceFiles& operator=(const SourceFiles&) = delete;

    /// Opens the scene file and allows its folder and `include_paths` for reading; "-" is the standard input, whose
    /// folder is the working folder. Returns its index.
    uint32_t open_scene(const std::filesystem::path& path, std::vector<std::filesystem::path> include_paths);

    /// The resolved path of `name`, which is searched beside the scene, then in the include paths. Nothing when there
    /// is no such file; one outside of these folders throws FileError.
    struct Found {
        std::filesystem::path path, real_path;
    };
    std::optional<Found> find(const std::string& name) const;

    /// Opens an include file or a data file that find() finds. The same file keeps its index. One that may not be read
    /// throws FileError.
    std::optional<uint32_t> open_include(const std::string& name);

    /// Adds a text that is no file.
    uint32_t add_text(std::string name, std::string text);

    std::string_view text(uint32_t file) const { return files_[file].text; }
    /// The name as messages show it.
    const std::string& name(uint32_t file) const { return files_[file].name; }
    uint32_t size() const { return uint32_t(files_.size()); }

    /// Counts from the text's start: for messages only.
    LineColumn line_column(SourceLocation location) const;
    /// The line around a location, without its end.
    std::string_view line_text(SourceLocation location) const;

private:
    struct File {
        std::string name;
        std::filesystem::path real_path;
        std::string owned;
        std::string_view text;
        void* mapping = nullptr;
    };

    uint32_t map_file(const std::filesystem::path& path, const std::filesystem::path& real_path);
    bool allowed(const std::filesystem::path& real_path) const;

    std::deque<File> files_; // a deque: the texts are referred to
    std::vector<std::filesystem::path> folders_;
    std::vector<std::filesystem::path> allowed_roots_;
};

} // namespace proxima
