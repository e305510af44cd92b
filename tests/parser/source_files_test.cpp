// SPDX-License-Identifier: Apache-2.0
// Which files a scene may read, and the places in them.
#include "parser/source_files.h"

#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <sys/stat.h>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

/// A folder with a scene folder, an include folder and a file that belongs to neither.
struct Folders {
    fs::path root;

    Folders() {
        std::string name = (fs::temp_directory_path() / "proxima-files-XXXXXX").string();
        root = mkdtemp(name.data());
        fs::create_directories(root / "scene/sub");
        fs::create_directories(root / "include");
        write("scene/main.scn", "one\ntwo\r\nthree");
        write("scene/beside.inc", "beside");
        write("scene/sub/below.inc", "below");
        write("include/library.inc", "library");
        write("secret", "secret");
    }
    Folders(const Folders&) = delete;
    ~Folders() { fs::remove_all(root); }

    void write(const char* path, const char* text) const { std::ofstream(root / path) << text; }
};

std::string failure(SourceFiles& files, const std::string& name) {
    try {
        return files.open_include(name) ? "" : "not found";
    } catch (const FileError& error) {
        return error.what();
    }
}

bool contains(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("files: a scene finds what lies beside it, below it and in the include paths") {
    const Folders folders;
    SourceFiles files;
    CHECK(files.open_scene(folders.root / "scene/main.scn", {folders.root / "include"}) == 0);
    CHECK(files.text(*files.open_include("beside.inc")) == "beside");
    CHECK(files.text(*files.open_include("sub/below.inc")) == "below");
    CHECK(files.text(*files.open_include("library.inc")) == "library");
    CHECK(files.open_include("sub/../beside.inc") == files.open_include("beside.inc"));
    CHECK(!files.open_include("missing.inc"));
}

TEST_CASE("files: nothing outside of these folders is read") {
    const Folders folders;
    fs::create_symlink(folders.root / "secret", folders.root / "scene/link.inc");
    fs::create_symlink(folders.root / "scene/beside.inc", folders.root / "scene/good_link.inc");
    mkfifo((folders.root / "scene/pipe.inc").c_str(), 0600);
    SourceFiles files;
    files.open_scene(folders.root / "scene/main.scn", {});
    CHECK(contains(failure(files, "../secret"), "outside of the scene's folder"));
    CHECK(contains(failure(files, "link.inc"), "outside of the scene's folder"));
    CHECK(contains(failure(files, (folders.root / "secret").string()), "relative to the scene's folder"));
    CHECK(contains(failure(files, "../include/library.inc"), "outside of the scene's folder"));
    CHECK(contains(failure(files, "pipe.inc"), "not a regular file"));
    CHECK(contains(failure(files, "sub"), "it is a folder"));
    CHECK(contains(failure(files, ""), "empty"));
    CHECK(failure(files, "good_link.inc") == "");
}

TEST_CASE("files: a scene that cannot be read says why") {
    const Folders folders;
    const auto open = [](const fs::path& path, std::vector<fs::path> include_paths = {}) -> std::string {
        try {
            SourceFiles().open_scene(path, std::move(include_paths));
            return "";
        } catch (const FileError& error) {
            return error.what();
        }
    };
    CHECK(contains(open(folders.root / "none.scn"), "No such file"));
    CHECK(contains(open(folders.root / "scene"), "it is a folder"));
    CHECK(contains(open("/dev/null"), "not a regular file"));
    CHECK(contains(open(folders.root / "scene/main.scn", {folders.root / "none"}), "is not a folder"));
    folders.write("scene/empty.scn", "");
    CHECK(open(folders.root / "scene/empty.scn") == "");
}

TEST_CASE("files: an offset has a line, a column and the line's text") {
    const Folders folders;
    SourceFiles files;
    files.open_scene(folders.root / "scene/main.scn", {});
    struct Case {
        uint32_t offset, line, column;
        const char* text;
    };
    for (const Case& test : {Case{0, 1, 1, "one"}, Case{2, 1, 3, "one"}, Case{4, 2, 1, "two"}, Case{9, 3, 1, "three"},
                             Case{14, 3, 6, "three"}}) {
        CAPTURE(test.offset);
        const LineColumn at = files.line_column({0, test.offset});
        CHECK(at.line == test.line);
        CHECK(at.column == test.column);
        CHECK(files.line_text({0, test.offset}) == test.text);
    }
}
