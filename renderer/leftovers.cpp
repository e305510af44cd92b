// SPDX-License-Identifier: Apache-2.0
#include "renderer/leftovers.h"
#include "renderer/atomic_file.h"
#include "renderer/temporary_name.h"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <set>
#include <string>
#include <sys/file.h>
#include <unistd.h>

namespace proxima {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::hours patience(1);

/// What time it is where the folder lies. Throws FileError.
fs::file_time_type clock_of(const fs::path& folder) {
    const PendingFile now(folder / "now");
    return fs::last_write_time(now.temporary());
}

bool is_old(const fs::path& file) {
    return clock_of(file.parent_path()) - fs::last_write_time(file) > patience;
}

/// Removes it while its lock is held: whoever makes a file looks whether it still has a name once it is locked.
bool remove_if_abandoned(const fs::path& file, bool is_of_this_machine) {
    const int number = ::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (number < 0)
        return false;
    const bool is_locked = ::flock(number, LOCK_EX | LOCK_NB) == 0;
    const bool is_in_use = !is_locked && errno == EWOULDBLOCK;
    bool is_removed = false;
    try {
        if (!is_in_use && ((is_locked && is_of_this_machine) || is_old(file)))
            is_removed = ::unlink(file.c_str()) == 0;
    } catch (const std::exception&) { // it is as if it were new
    }
    ::close(number);
    return is_removed;
}

} // namespace

size_t remove_leftovers(const std::vector<fs::path>& files) {
    std::set<std::string> names;
    for (const fs::path& file : files)
        names.insert(kept_part(file.filename().string()));
    size_t removed = 0;
    std::error_code error;
    const fs::path folder = files.empty() || !files[0].has_parent_path() ? "." : files[0].parent_path();
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const auto name = parse_temporary_name(entry->path().filename().string());
        if (name && names.contains(name->file))
            removed += remove_if_abandoned(entry->path(), name->is_of_this_machine);
    }
    return removed;
}

} // namespace proxima
