// SPDX-License-Identifier: Apache-2.0
#include "parser/source_files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace proxima {
namespace fs = std::filesystem;
namespace {

/// Closes a file descriptor on every way out.
struct Descriptor {
    int fd;
    explicit Descriptor(int fd) : fd(fd) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (fd >= 0)
            ::close(fd);
    }
};

FileError unreadable(const fs::path& path, const std::string& reason) {
    return FileError("cannot read " + path.string() + ": " + reason);
}

fs::path resolve(const fs::path& path) {
    std::error_code error;
    fs::path real = fs::canonical(path, error);
    if (error)
        throw unreadable(path, error.message());
    return real;
}

std::string read_standard_input() {
    std::string text;
    char piece[65536];
    for (;;) {
        const ssize_t count = ::read(STDIN_FILENO, piece, sizeof piece);
        if (count == 0)
            return text;
        if (count < 0 && errno != EINTR)
            throw unreadable("the standard input", std::strerror(errno));
        text.append(piece, size_t(std::max<ssize_t>(count, 0)));
        if (text.size() >= std::numeric_limits<uint32_t>::max())
            throw unreadable("the standard input", "it is larger than 4 GiB");
    }
}

/// Whether `path` is `folder` or lies in it; both are resolved.
bool is_below(const fs::path& path, const fs::path& folder) {
    const auto [rest, _] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return rest == folder.end();
}

} // namespace

SourceFiles::~SourceFiles() {
    for (const File& file : files_)
        if (file.mapping)
            ::munmap(file.mapping, file.text.size());
}

uint32_t SourceFiles::open_scene(const fs::path& path, std::vector<fs::path> include_paths) {
    const bool from_input = path == "-";
    const fs::path real = from_input ? fs::path() : resolve(path);
    folders_ = {path.parent_path().empty() ? fs::path(".") : path.parent_path()};
    allowed_roots_ = {from_input ? resolve(".") : real.parent_path()};
    for (fs::path& folder : include_paths) {
        std::error_code error;
        if (!fs::is_directory(folder, error))
            throw FileError("the include path " + folder.string() + " is not a folder");
        allowed_roots_.push_back(resolve(folder));
        folders_.push_back(std::move(folder));
    }
    return from_input ? add_text("<stdin>", read_standard_input()) : map_file(path, real);
}

std::optional<SourceFiles::Found> SourceFiles::find(const std::string& name) const {
    const fs::path relative(name);
    if (name.empty())
        throw FileError("the name of the file is empty");
    if (name.find('\0') != std::string::npos || relative.is_absolute())
        throw FileError("cannot read " + name + ": give a path relative to the scene's folder or to an include path");
    for (const fs::path& folder : folders_) {
        const fs::path candidate = (folder == "." ? relative : folder / relative);
        std::error_code error;
        if (!fs::exists(fs::symlink_status(candidate, error)))
            continue;
        fs::path real = resolve(candidate);
        if (!allowed(real))
            throw unreadable(candidate, "it lies outside of the scene's folder and the include paths");
        return Found{candidate, std::move(real)};
    }
    return std::nullopt;
}

std::optional<uint32_t> SourceFiles::open_include(const std::string& name) {
    const std::optional<Found> found = find(name);
    if (!found)
        return std::nullopt;
    for (uint32_t index = 0; index < size(); ++index)
        if (files_[index].real_path == found->real_path)
            return index;
    return map_file(found->path, found->real_path);
}

uint32_t SourceFiles::add_text(std::string name, std::string text) {
    File& file = files_.emplace_back();
    file.name = std::move(name);
    file.owned = std::move(text);
    file.text = file.owned;
    return size() - 1;
}

bool SourceFiles::allowed(const fs::path& real_path) const {
    return std::any_of(allowed_roots_.begin(), allowed_roots_.end(),
                       [&](const fs::path& root) { return is_below(real_path, root); });
}

uint32_t SourceFiles::map_file(const fs::path& path, const fs::path& real_path) {
    // Without O_NONBLOCK, opening a named pipe would wait for its writer.
    const Descriptor descriptor(::open(real_path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (descriptor.fd < 0)
        throw unreadable(path, std::strerror(errno));
    struct stat status {};
    if (::fstat(descriptor.fd, &status) != 0)
        throw unreadable(path, std::strerror(errno));
    if (S_ISDIR(status.st_mode))
        throw unreadable(path, "it is a folder");
    if (!S_ISREG(status.st_mode))
        throw unreadable(path, "it is not a regular file");
    if (uint64_t(status.st_size) >= std::numeric_limits<uint32_t>::max())
        throw unreadable(path, "it is larger than 4 GiB");

    void* mapping = nullptr;
    if (status.st_size > 0) {
        mapping = ::mmap(nullptr, size_t(status.st_size), PROT_READ, MAP_PRIVATE, descriptor.fd, 0);
        if (mapping == MAP_FAILED)
            throw unreadable(path, std::strerror(errno));
        ::madvise(mapping, size_t(status.st_size), MADV_SEQUENTIAL);
    }
    File& file = files_.emplace_back();
    file.name = path.string();
    file.real_path = real_path;
    file.mapping = mapping;
    file.text = {static_cast<const char*>(mapping), size_t(status.st_size)};
    return size() - 1;
}

LineColumn SourceFiles::line_column(SourceLocation location) const {
    const std::string_view before = text(location.file).substr(0, location.offset);
    const size_t line_start = before.rfind('\n') + 1; // npos + 1 is 0
    return {uint32_t(std::count(before.begin(), before.end(), '\n') + 1), uint32_t(before.size() - line_start + 1)};
}

std::string_view SourceFiles::line_text(SourceLocation location) const {
    const std::string_view all = text(location.file);
    const size_t start = all.substr(0, location.offset).rfind('\n') + 1;
    std::string_view line = all.substr(start, all.find('\n', start) - start);
    if (line.ends_with('\r'))
        line.remove_suffix(1);
    return line;
}

} // namespace proxima
