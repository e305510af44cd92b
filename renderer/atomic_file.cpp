// SPDX-License-Identifier: Apache-2.0
#include "renderer/atomic_file.h"
#include "parser/source_files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <random>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace proxima {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw FileError(fmt::format("{}: cannot be written: {}", path.string(), reason));
}

[[noreturn]] void fail(const fs::path& path, int error) {
    fail(path, std::strerror(error));
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// An open file. `path` is only for messages.
class Descriptor {
public:
    Descriptor(const fs::path& opened, int flags, const fs::path& path)
        : number_(::open(opened.c_str(), flags | O_CLOEXEC, 0666)), path_(path) {
        if (number_ < 0)
            fail(path_, errno);
    }
    ~Descriptor() {
        if (number_ >= 0)
            ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    void write(std::span<const unsigned char> bytes) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(number_, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR)
                continue;
            if (written < 0)
                fail(path_, errno);
            bytes = bytes.subspan(size_t(written));
        }
    }
    void sync() {
        if (::fsync(number_) != 0 && errno != EINVAL && errno != EROFS) // pipes and some file systems cannot
            fail(path_, errno);
    }
    /// Some file systems report a failed write only here.
    void close() {
        const int number = std::exchange(number_, -1);
        if (::close(number) != 0)
            fail(path_, errno);
    }

private:
    int number_;
    fs::path path_;
};

/// A name that nobody has, in the folder of `path`; the file is removed unless it was renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& path)
        : name_(folder_of(path) / fmt::format(".{}.{:08x}{:08x}.tmp", path.filename().string().substr(0, 200),
                                              std::random_device()(), std::random_device()())),
          file_(name_, O_WRONLY | O_CREAT | O_EXCL, path), path_(path) {}
    ~TemporaryFile() {
        if (!name_.empty())
            ::unlink(name_.c_str());
    }

    Descriptor& file() { return file_; }
    void rename() {
        if (::rename(name_.c_str(), path_.c_str()) != 0)
            fail(path_, errno);
        name_.clear();
    }

private:
    fs::path name_;
    Descriptor file_;
    fs::path path_;
};

/// Whether `path` is there and is neither a file nor a folder. Throws for a folder.
bool is_device(const fs::path& path) {
    struct stat info;
    if (::stat(path.c_str(), &info) != 0) {
        if (errno != ENOENT && errno != ENOTDIR)
            fail(path, errno);
        return false;
    }
    if (S_ISDIR(info.st_mode))
        fail(path, "it is a folder; name a file in it");
    return !S_ISREG(info.st_mode);
}

} // namespace

void write_file(const fs::path& path, std::span<const unsigned char> bytes) {
    if (is_device(path)) {
        Descriptor device(path, O_WRONLY, path);
        device.write(bytes);
        device.close();
        return;
    }
    TemporaryFile temporary(path);
    temporary.file().write(bytes);
    temporary.file().sync();
    temporary.file().close();
    temporary.rename();
    Descriptor folder(folder_of(path), O_RDONLY | O_DIRECTORY, path);
    folder.sync(); // the new name itself reaches the disk
}

void check_writable(const fs::path& path) {
    if (is_device(path)) {
        if (::access(path.c_str(), W_OK) != 0)
            fail(path, errno);
        return;
    }
    std::error_code error;
    if (!fs::exists(folder_of(path), error))
        fail(path, fmt::format("there is no folder '{}'; create it first", folder_of(path).string()));
    if (!fs::is_directory(folder_of(path), error))
        fail(path, fmt::format("'{}' is not a folder", folder_of(path).string()));
    TemporaryFile temporary(path);
}

} // namespace proxima
