// SPDX-License-Identifier: Apache-2.0
#include "renderer/temporary_name.h"

#include <fmt/format.h>
#include <fstream>
#include <random>
#include <string_view>

namespace proxima {
namespace {

constexpr size_t digits = 8; ///< of the machine, and of the number
constexpr std::string_view ending = ".tmp";

/// Of the running kernel, whatever the host or the container is called: another one has another. Empty if unknown.
const std::string& machine() {
    static const std::string id = [] {
        std::string text;
        std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), text);
        return text.size() < digits ? std::string() : text.substr(0, digits);
    }();
    return id;
}

} // namespace

std::string kept_part(const std::string& file) {
    return file.substr(0, 200); // a name has at most 255 bytes
}

std::filesystem::path temporary_name(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    return folder / fmt::format(".{}.{:0>8}{:08x}{}", kept_part(path.filename().string()), machine(),
                                std::random_device()(), ending);
}

std::optional<TemporaryName> parse_temporary_name(const std::string& name) {
    const size_t tail = 1 + 2 * digits + ending.size();
    if (name.size() < 2 + tail || name[0] != '.' || !name.ends_with(ending) || name[name.size() - tail] != '.')
        return std::nullopt;
    const std::string numbers = name.substr(name.size() - tail + 1, 2 * digits);
    if (numbers.find_first_not_of("0123456789abcdef") != std::string::npos)
        return std::nullopt;
    return TemporaryName{name.substr(1, name.size() - tail - 1), !machine().empty() && numbers.starts_with(machine())};
}

} // namespace proxima
