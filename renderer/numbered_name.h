// SPDX-License-Identifier: Apache-2.0
// A file name with a place for a frame number, and the way back from a name to its number.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace proxima {

class NumberedName {
public:
    /// The number stands where the file name has `####` (n >= 2 hashes are n digits, one hash is four) or `%04d`.
    /// Throws UsageError, naming `option`, when the name has two such places.
    NumberedName(std::string_view option, const std::filesystem::path& pattern);

    bool has_number() const { return has_number_; }

    /// The file of `number`; a negative one is a minus sign before its digits. Without a place for a number every
    /// number has the same name.
    std::filesystem::path path(int64_t number) const;

    /// The number that makes `file_name` (without folders), or nothing.
    std::optional<int64_t> number_of(std::string_view file_name) const;

private:
    std::filesystem::path folder_;
    std::string before_, after_; ///< the file name around the number
    bool has_number_ = false;
    int digits_ = 0;
};

} // namespace proxima
