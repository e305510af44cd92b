// SPDX-License-Identifier: Apache-2.0
// Files that are whole or not there: bytes go to a temporary name in the same folder, reach the disk, and then take
// the final name in one step. Every failure throws FileError with the path and the reason, and leaves nothing behind.
#pragma once
#include <filesystem>
#include <memory>
#include <span>

namespace proxima {

/// A file that is being made under a temporary name beside `path`, and gone with this object unless it is committed.
class PendingFile {
public:
    explicit PendingFile(const std::filesystem::path& path);
    ~PendingFile();

    /// For others who write it; it exists.
    const std::filesystem::path& temporary() const;
    void write(std::span<const unsigned char> bytes);
    /// Replaces `path` by it, once it has reached the disk.
    void commit();

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Replaces `path` by a file of these bytes. A device or a pipe is written in place.
void write_file(const std::filesystem::path& path, std::span<const unsigned char> bytes);

/// Finds out, before any work is done, whether write_file could write `path`: its folder exists and takes new files,
/// and `path` is no folder. Leaves no trace.
void check_writable(const std::filesystem::path& path);

} // namespace proxima
