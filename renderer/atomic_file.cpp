// SPDX-License-Identifier: Apache-2.0
#include "renderer/atomic_file.h"
#include "parser/source_files.h"
#include "renderer/temporary_name.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
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
    Descriptor(Descriptor&& other) noexcept
        : number_(std::exchange(other.number_, -1)), path_(std::move(other.path_)) {}
    Descriptor& operator=(const Descriptor&) = delete;

    /// The same open file, and so the same lock, under another number.
    Descriptor duplicate() const {
        const int number = ::fcntl(number_, F_DUPFD_CLOEXEC, 0);
        if (number < 0)
            fail(path_, errno);
        return Descriptor(number, path_);
    }
    /// False when somebody else was quicker: then the file is, or will be, without a name. File systems that know no
    /// locks do without.
    bool lock() const {
        if (::flock(number_, LOCK_EX | LOCK_NB) != 0)
            return errno != EWOULDBLOCK;
        struct stat info;
        return ::fstat(number_, &info) != 0 || info.st_nlink > 0;
    }

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
    Descriptor(int number, const fs::path& path) : number_(number), path_(path) {}

    int number_;
    fs::path path_;
};

/// A new file beside `path`, locked for as long as it is open: see leftovers.h.
Descriptor make_temporary(const fs::path& path, fs::path& temporary) {
    for (;;) {
        temporary = temporary_name(path);
        Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL, path);
        if (file.lock())
            return file;
    }
}

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

struct PendingFile::Implementation {
    fs::path path, temporary;
    Descriptor file;
    Descriptor lock; ///< until the file has its final name

    explicit Implementation(const fs::path& path)
        : path(path), file(make_temporary(path, temporary)), lock(file.duplicate()) {}
    ~Implementation() {
        if (!temporary.empty())
            ::unlink(temporary.c_str());
    }
};

PendingFile::PendingFile(const fs::path& path) : implementation_(std::make_unique<Implementation>(path)) {}

PendingFile::~PendingFile() = default;

const fs::path& PendingFile::temporary() const {
    return implementation_->temporary;
}

void PendingFile::write(std::span<const unsigned char> bytes) {
    implementation_->file.write(bytes);
}

void PendingFile::commit() {
    auto& [path, temporary, file, lock] = *implementation_;
    file.sync();
    file.close();
    if (::rename(temporary.c_str(), path.c_str()) != 0)
        fail(path, errno);
    temporary.clear();
    Descriptor folder(folder_of(path), O_RDONLY | O_DIRECTORY, path);
    folder.sync(); // the new name itself reaches the disk
}

void write_file(const fs::path& path, std::span<const unsigned char> bytes) {
    if (is_device(path)) {
        Descriptor device(path, O_WRONLY, path);
        device.write(bytes);
        device.close();
        return;
    }
    PendingFile file(path);
    file.write(bytes);
    file.commit();
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
    const PendingFile probe(path);
}

} // namespace proxima
