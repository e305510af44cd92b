// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there: bytes go to a temporary name in the same folder, reach the disk, and then take
// the final name in one step. Every failure throws FileError with the path and the reason, and leaves nothing behind.
#pragma once
#include <filesystem>
#include <span>

namespace proxima {

/// Replaces `path` by a file of these bytes. A device or a pipe is written in place.
void write_file(const std::filesystem::path& path, std::span<const unsigned char> bytes);

/// Finds out, before any work is done, whether write_file could write `path`: its folder exists and takes new files,
/// and `path` is no folder. Leaves no trace.
void check_writable(const std::filesystem::path& path);

} // namespace proxima
