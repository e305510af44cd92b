// SPDX-License-Identifier: Apache-2.0
#include "parser/source_files.h"
#include "renderer/atomic_file.h"
#include "tests/folder.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <doctest/doctest.h>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <unistd.h>
#include <vector>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

std::vector<unsigned char> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

std::string content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Folder : testing::Folder {
    size_t entries() const { return size_t(std::distance(fs::directory_iterator(path), {})); }
};

} // namespace

TEST_CASE("atomic file: the final name holds the bytes and nothing else stays") {
    const Folder folder;
    const fs::path path = folder.path / "a.png";
    check_writable(path);
    CHECK(folder.entries() == 0);
    write_file(path, bytes_of("one"));
    CHECK(content(path) == "one");
    write_file(path, bytes_of("another"));
    CHECK(content(path) == "another");
    write_file(folder.path / "empty.png", {});
    CHECK(fs::file_size(folder.path / "empty.png") == 0);
    CHECK(folder.entries() == 2);
}

TEST_CASE("atomic file: what cannot be written is refused beforehand, with the path and the reason") {
    const Folder folder;
    write_file(folder.path / "file", bytes_of("x"));
    struct Row {
        fs::path path;
        const char* reason;
    };
    const Row rows[] = {
        {folder.path, "it is a folder"},
        {folder.path / "missing" / "a.png", "there is no folder"},
        {folder.path / "file" / "a.png", "is not a folder"},
        {"/proc/a.png", "cannot be written"},
        {folder.path / std::string(300, 'n'), "File name too long"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.path);
        for (const bool beforehand : {true, false}) {
            std::string message;
            try {
                if (beforehand)
                    check_writable(row.path);
                else
                    write_file(row.path, bytes_of("x"));
            } catch (const FileError& error) {
                message = error.what();
            }
            CHECK(message.find(row.path.string()) == 0);
            if (beforehand)
                CHECK(message.find(row.reason) != std::string::npos);
        }
    }
    CHECK(folder.entries() == 1);
}

TEST_CASE("atomic file: a folder that may not be changed is refused") {
    if (geteuid() == 0) {
        MESSAGE("skipped: root may change every folder");
        return;
    }
    const Folder folder;
    fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THROWS_AS(check_writable(folder.path / "a.png"), FileError);
    fs::permissions(folder.path, fs::perms::owner_all);
}

TEST_CASE("atomic file: a full device is an error") {
    CHECK_THROWS_AS(write_file("/dev/full", bytes_of("x")), FileError);
}

TEST_CASE("atomic file: a write that fails half-way leaves the old file and nothing else") {
    const Folder folder;
    const fs::path path = folder.path / "a.png";
    write_file(path, bytes_of("old"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = before;
    small.rlim_cur = 4096;
    setrlimit(RLIMIT_FSIZE, &small);
    std::string message;
    try {
        write_file(path, std::vector<unsigned char>(100'000));
    } catch (const FileError& error) {
        message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, old_handler);
    CHECK(message == path.string() + ": cannot be written: File too large");
    CHECK(content(path) == "old");
    CHECK(folder.entries() == 1);
}
