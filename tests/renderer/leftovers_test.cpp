// SPDX-License-Identifier: Apache-2.0
#include "renderer/atomic_file.h"
#include "renderer/leftovers.h"
#include "renderer/temporary_name.h"
#include "tests/folder.h"

#include <chrono>
#include <doctest/doctest.h>
#include <fstream>
#include <set>

using namespace proxima;
namespace fs = std::filesystem;

namespace {

struct Folder : testing::Folder {
    /// A file that nobody holds.
    fs::path leave(const fs::path& name, std::chrono::minutes age = std::chrono::minutes(0)) const {
        std::ofstream(path / name) << "half a picture";
        fs::last_write_time(path / name, fs::file_time_type::clock::now() - age);
        return path / name;
    }
    size_t remove(const std::vector<std::string>& names) const {
        std::vector<fs::path> files;
        for (const std::string& name : names)
            files.push_back(path / name);
        return remove_leftovers(files);
    }
};

/// The same name, made on another machine.
std::string elsewhere(const fs::path& name) {
    std::string text = name.filename().string();
    const size_t machine = text.size() - 20;
    text[machine] = text[machine] == '0' ? '1' : '0';
    return text;
}

constexpr std::chrono::minutes old(90);

} // namespace

TEST_CASE("leftovers: names say of which file they are, and who made them") {
    const fs::path name = temporary_name("folder/a.0001.exr");
    CHECK(name.parent_path() == "folder");
    const auto parsed = parse_temporary_name(name.filename().string());
    REQUIRE(parsed);
    CHECK(parsed->file == "a.0001.exr");
    CHECK(parsed->is_of_this_machine);
    CHECK(temporary_name("folder/a.0001.exr") != name);
    const auto other = parse_temporary_name(elsewhere(name));
    REQUIRE(other);
    CHECK(other->file == "a.0001.exr");
    CHECK_FALSE(other->is_of_this_machine);
    const std::string very_long(240, 'x');
    CHECK(parse_temporary_name(temporary_name(very_long).string().substr(2))->file == kept_part(very_long));
    for (const char* text :
         {"", ".tmp", ".a.tmp", "a.0001.exr", ".a.exr.0123456789abcdef", ".0123456789abcdef.tmp",
          ".a.exr.0123456789abcdeg.tmp", "a.exr.0123456789abcdef.tmp", ".a.exr_0123456789abcdef.tmp"})
        CHECK_MESSAGE(!parse_temporary_name(text), text);
    CHECK(parse_temporary_name(".a.exr.0123456789abcdef.tmp"));
}

TEST_CASE("leftovers: those of this machine go at once, those of others after an hour, and no other files") {
    const Folder folder;
    const auto name = [](const char* file) { return temporary_name(file).filename(); };
    const fs::path own = folder.leave(name("a.exr")), own_old = folder.leave(name("a.exr"), old);
    const fs::path other = folder.leave(elsewhere(name("a.exr")));
    const fs::path other_old = folder.leave(elsewhere(name("b.exr")), old);
    const fs::path unasked = folder.leave(name("c.exr"), old);
    folder.leave("a.exr", old);
    folder.leave(".a.exr.tmp", old);
    CHECK(folder.remove({"a.exr", "b.exr"}) == 3);
    CHECK_FALSE(fs::exists(own));
    CHECK_FALSE(fs::exists(own_old));
    CHECK_FALSE(fs::exists(other_old));
    CHECK(fs::exists(other));
    CHECK(fs::exists(unasked));
    CHECK(fs::exists(folder.path / "a.exr"));
    CHECK(fs::exists(folder.path / ".a.exr.tmp"));
    CHECK(folder.remove({"a.exr", "b.exr"}) == 0);
    CHECK(folder.remove({}) == 0);
    CHECK(remove_leftovers({folder.path / "missing" / "a.exr"}) == 0);
}

TEST_CASE("leftovers: a file that is being made stays, however old it is, and gets its name") {
    const Folder folder;
    PendingFile file(folder.path / "a.exr");
    const std::string text = "a whole picture";
    file.write({reinterpret_cast<const unsigned char*>(text.data()), text.size()});
    CHECK(folder.remove({"a.exr"}) == 0);
    fs::last_write_time(file.temporary(), fs::file_time_type::clock::now() - old);
    CHECK(folder.remove({"a.exr"}) == 0);
    file.commit();
    CHECK(fs::file_size(folder.path / "a.exr") == text.size());

    PendingFile moved(folder.path / "b.exr"); // as if by another host that shares the locks
    const fs::path name = folder.path / elsewhere(moved.temporary());
    fs::rename(moved.temporary(), name);
    fs::last_write_time(name, fs::file_time_type::clock::now() - old);
    CHECK(folder.remove({"b.exr"}) == 0);
    CHECK(fs::exists(name));
}
