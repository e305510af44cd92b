// SPDX-License-Identifier: Apache-2.0
#include "renderer/picture_pairs.h"
#include "parser/source_files.h"
#include "renderer/errors.h"
#include "renderer/image_file.h"
#include "renderer/numbered_name.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>
#include <string_view>

namespace proxima {
namespace {

namespace fs = std::filesystem;

enum class Kind { file, folder, sequence };

const char* describe(Kind kind) {
    switch (kind) {
    case Kind::file:
        return "a file";
    case Kind::folder:
        return "a folder";
    case Kind::sequence:
        break;
    }
    return "a sequence";
}

Kind kind_of(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return Kind::folder;
    // A file whose own name has a '#' is that file.
    return !fs::exists(path, error) && NumberedName("A, B", path).has_number() ? Kind::sequence : Kind::file;
}

PicturePair make_pair(std::string name, const fs::path& a, const fs::path& b) {
    PicturePair pair{.name = std::move(name), .a = a.string(), .b = b.string()};
    if (!a.empty())
        pair.load_a = [a] { return read_image_file(a); };
    if (!b.empty())
        pair.load_b = [b] { return read_image_file(b); };
    return pair;
}

/// The entries of a folder that `key` gives a value for, by that value.
template <class Key> auto list_folder(const fs::path& folder, const Key& key) {
    std::map<typename decltype(key(fs::path()))::value_type, fs::path> found;
    std::error_code error;
    fs::directory_iterator entries(folder.empty() ? "." : folder, error);
    for (; !error && entries != fs::directory_iterator(); entries.increment(error))
        if (const auto value = key(entries->path().filename()))
            found.emplace(*value, folder / entries->path().filename());
    if (error)
        throw FileError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
    return found;
}

std::optional<std::string> picture_name(const fs::path& name) {
    static const std::set<std::string> endings{".png", ".exr", ".tif", ".tiff", ".jpg", ".jpeg"};
    std::string ending = name.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return endings.contains(ending) ? std::optional(name.string()) : std::nullopt;
}

/// One pair for each key of either side, in the keys' order.
template <class Key, class Name>
std::vector<PicturePair> join(const std::map<Key, fs::path>& a, const std::map<Key, fs::path>& b,
                              const std::set<Key>& keys, const Name& name) {
    std::vector<PicturePair> pairs;
    for (const Key& key : keys) {
        const auto in_a = a.find(key), in_b = b.find(key);
        pairs.push_back(make_pair(name(key), in_a == a.end() ? fs::path() : in_a->second,
                                  in_b == b.end() ? fs::path() : in_b->second));
    }
    return pairs;
}

template <class Key> std::set<Key> keys_of(const std::map<Key, fs::path>& a, const std::map<Key, fs::path>& b) {
    std::set<Key> keys;
    for (const auto* side : {&a, &b})
        for (const auto& [key, path] : *side)
            keys.insert(key);
    return keys;
}

std::vector<PicturePair> pair_sequences(const fs::path& a, const fs::path& b, const std::vector<int64_t>& frames) {
    const auto list = [](const fs::path& pattern) {
        const NumberedName name("A, B", pattern);
        return list_folder(pattern.parent_path(), [&](const fs::path& file) { return name.number_of(file.string()); });
    };
    const auto in_a = list(a), in_b = list(b);
    const std::set<int64_t> keys = frames.empty() ? keys_of(in_a, in_b) : std::set(frames.begin(), frames.end());
    return join(in_a, in_b, keys, [](int64_t frame) { return fmt::format("frame {}", frame); });
}

std::vector<PicturePair> pair_folders(const fs::path& a, const fs::path& b) {
    const auto in_a = list_folder(a, picture_name), in_b = list_folder(b, picture_name);
    return join(in_a, in_b, keys_of(in_a, in_b), [](const std::string& name) { return name; });
}

} // namespace

std::vector<PicturePair> pair_files(const fs::path& a, const fs::path& b, const std::vector<int64_t>& frames) {
    const Kind kind = kind_of(a);
    if (kind != kind_of(b))
        throw UsageError(fmt::format("{} is {} and {} {}; compare two files, two folders, or two sequences like "
                                     "a.####.png",
                                     a.string(), describe(kind), b.string(), describe(kind_of(b))));
    if (!frames.empty() && kind != Kind::sequence)
        throw UsageError("--frames: only a sequence has frames; write A and B like a.####.png");
    if (kind == Kind::file)
        return {make_pair(a.filename().string(), a, b)};
    auto pairs = kind == Kind::folder ? pair_folders(a, b) : pair_sequences(a, b, frames);
    if (pairs.empty())
        throw FileError(fmt::format("{}, {}: there are no pictures", a.string(), b.string()));
    return pairs;
}

} // namespace proxima
