// SPDX-License-Identifier: Apache-2.0
#include "renderer/numbered_name.h"
#include "renderer/errors.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>

namespace proxima {
namespace {

constexpr int digits_of_one_hash = 4;
constexpr int max_digits = 32;

struct Placeholder {
    size_t begin = 0, length = 0;
    int digits = 0;
};

/// The first `###` or `%0Nd` at or after `from`.
std::optional<Placeholder> find_placeholder(const std::string& name, size_t from) {
    for (size_t i = from; i < name.size(); ++i) {
        if (name[i] == '#') {
            const size_t end = std::min(name.find_first_not_of('#', i), name.size());
            return Placeholder{i, end - i, end - i == 1 ? digits_of_one_hash : int(end - i)};
        }
        if (name[i] != '%')
            continue;
        size_t end = i + 1;
        int digits = 0;
        while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])) && digits <= max_digits)
            digits = digits * 10 + (name[end++] - '0');
        if (end < name.size() && name[end] == 'd' && (digits == 0 || name[i + 1] == '0'))
            return Placeholder{i, end + 1 - i, digits};
    }
    return std::nullopt;
}

} // namespace

NumberedName::NumberedName(std::string_view option, const std::filesystem::path& pattern)
    : folder_(pattern.parent_path()) {
    const std::string name = pattern.filename().string();
    const auto placeholder = find_placeholder(name, 0);
    if (!placeholder) {
        before_ = name;
        return;
    }
    before_ = name.substr(0, placeholder->begin);
    after_ = name.substr(placeholder->begin + placeholder->length);
    digits_ = placeholder->digits;
    has_number_ = true;
    if (digits_ > max_digits)
        throw UsageError(
            fmt::format("{} {}: a frame number has at most {} digits; write #### or %04d", option, name, max_digits));
    if (find_placeholder(name, placeholder->begin + placeholder->length))
        throw UsageError(
            fmt::format("{} {}: the name has two places for the frame number; leave one of them", option, name));
}

std::filesystem::path NumberedName::path(int64_t number) const {
    if (!has_number_)
        return folder_ / before_;
    const uint64_t magnitude = number < 0 ? 0 - uint64_t(number) : uint64_t(number);
    return folder_ / fmt::format("{}{}{:0{}}{}", before_, number < 0 ? "-" : "", magnitude, digits_, after_);
}

std::optional<int64_t> NumberedName::number_of(std::string_view file_name) const {
    if (!has_number_ || file_name.size() <= before_.size() + after_.size() || !file_name.starts_with(before_) ||
        !file_name.ends_with(after_))
        return std::nullopt;
    const std::string_view digits = file_name.substr(before_.size(), file_name.size() - before_.size() - after_.size());
    int64_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    // 12 is not a number of four digits, nor is 00012.
    if (error != std::errc() || path(number).filename() != file_name)
        return std::nullopt;
    return number;
}

} // namespace proxima
