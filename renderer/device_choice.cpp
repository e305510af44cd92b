// SPDX-License-Identifier: Apache-2.0
#include "renderer/device_choice.h"
#include "renderer/errors.h"

#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace proxima {
namespace {

using Item = DeviceChoice::Item;

std::optional<int> read_ordinal(std::string_view text) {
    int value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || read.ec != std::errc{} || read.ptr != text.data() + text.size() || value < 0)
        return std::nullopt;
    return value;
}

/// One part of the list; `follows_number` when a cuda:N stands before it.
std::optional<Item> read_item(std::string_view text, bool follows_number) {
    if (text == "cpu")
        return Item{Item::Kind::cpu};
    if (text == "cuda")
        return Item{Item::Kind::every_cuda};
    std::optional<int> ordinal;
    if (text.starts_with("cuda:"))
        ordinal = read_ordinal(text.substr(5));
    else if (follows_number)
        ordinal = read_ordinal(text);
    if (!ordinal)
        return std::nullopt;
    return Item{Item::Kind::cuda, *ordinal};
}

} // namespace

DeviceChoice parse_device(std::string_view text) {
    DeviceChoice choice;
    if (text == "auto")
        return choice;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        const bool follows_number = !choice.items.empty() && choice.items.back().kind == Item::Kind::cuda;
        const auto item = read_item(text.substr(begin, end - begin), follows_number);
        if (!item)
            throw UsageError(fmt::format("--device {}: write auto, cpu, cuda, cuda:N or a list like cuda:0,2 or "
                                         "cuda,cpu; `proxima devices` lists them",
                                         text));
        choice.items.push_back(*item);
        begin = end + 1;
    }
    return choice;
}

} // namespace proxima
