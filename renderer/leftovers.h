// SPDX-License-Identifier: Apache-2.0
// What killed runs leave behind: files under temporary names that nobody will finish. A file is one if nobody holds its
// lock, which every PendingFile does, and if it was made on this machine, where that is certain, or has not changed for
// an hour: other hosts may share the folder but not its locks. The hour is measured by the folder's own clock.
#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

namespace proxima {

/// Removes those of `files`, which all lie in one folder, and returns how many there were. What cannot be listed,
/// opened or removed is left.
size_t remove_leftovers(const std::vector<std::filesystem::path>& files);

} // namespace proxima
