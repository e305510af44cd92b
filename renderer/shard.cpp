// SPDX-License-Identifier: Apache-2.0
#include "renderer/shard.h"
#include "renderer/errors.h"

#include <charconv>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>

namespace proxima {
namespace {

std::optional<uint32_t> read_number(std::string_view text) {
    uint32_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size())
        return std::nullopt;
    return value;
}

uint32_t slurm_number(const char* name) {
    const char* const text = std::getenv(name);
    const auto value = read_number(text ? text : "");
    if (!value)
        throw UsageError(
            fmt::format("--shard slurm: {} is {}; start it from a job array (sbatch --array), or write --shard I/N",
                        name, text ? fmt::format("'{}', which is no number", text) : "not set"));
    return *value;
}

/// Tasks of an array may begin anywhere and leave out numbers, as long as they do so evenly.
Shard slurm_shard() {
    const uint32_t id = slurm_number("SLURM_ARRAY_TASK_ID"), first = slurm_number("SLURM_ARRAY_TASK_MIN"),
                   last = slurm_number("SLURM_ARRAY_TASK_MAX"), count = slurm_number("SLURM_ARRAY_TASK_COUNT");
    const uint32_t step = count > 1 && last > first ? (last - first) / (count - 1) : 1;
    if (count == 0 || step == 0 || last != first + step * (count - 1) || id < first || id > last ||
        (id - first) % step != 0)
        throw UsageError(
            fmt::format("--shard slurm: the array has {} tasks from {} to {}, which are not evenly spaced; "
                        "write sbatch --array=0-{}",
                        count, first, last, count > 0 ? count - 1 : 0));
    return {(id - first) / step, count};
}

} // namespace

std::vector<int64_t> Shard::of(const std::vector<int64_t>& frames) const {
    std::vector<int64_t> own;
    for (size_t i = index; i < frames.size(); i += count)
        own.push_back(frames[i]);
    return own;
}

Shard parse_shard(std::string_view text) {
    if (text == "slurm")
        return slurm_shard();
    const size_t slash = std::min(text.find('/'), text.size());
    const auto part = read_number(text.substr(0, slash));
    const auto count = read_number(text.substr(std::min(slash + 1, text.size())));
    if (!part || !count || *part < 1 || *part > *count)
        throw UsageError(fmt::format("--shard {}: write I/N with I from 1 to N, like 2/5, or slurm", text));
    return {*part - 1, *count};
}

} // namespace proxima
