// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_range.h"
#include "renderer/errors.h"

#include <charconv>
#include <fmt/format.h>
#include <optional>
#include <unordered_set>

namespace proxima {
namespace {

/// One comma-separated part of a frame range, read from the left.
class PartReader {
public:
    PartReader(std::string_view option, std::string_view part) : option_(option), part_(part), rest_(part) {}

    bool at_end() const { return rest_.empty(); }

    bool skip(std::string_view word) {
        if (!rest_.starts_with(word))
            return false;
        rest_.remove_prefix(word.size());
        return true;
    }

    int64_t number() {
        int64_t value = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error == std::errc::invalid_argument)
            fail("write frames like 1-100, 1-100x2 or 1,3,5..9");
        if (error == std::errc::result_out_of_range || value > max_frame_number || value < -max_frame_number)
            fail(fmt::format("frame numbers go from -{0} to {0}", max_frame_number));
        rest_.remove_prefix(size_t(end - rest_.data()));
        return value;
    }

    [[noreturn]] void fail(const std::string& remedy) const {
        throw UsageError(fmt::format("{}: '{}' is not a range of frames; {}", option_, part_, remedy));
    }

private:
    std::string_view option_, part_, rest_;
};

struct Range {
    int64_t first, last, step;
    int64_t count() const { return (last - first) / step + 1; }
};

Range parse_part(std::string_view option, std::string_view part) {
    PartReader reader(option, part);
    Range range{reader.number(), 0, 1};
    range.last = range.first;
    if (reader.skip("-") || reader.skip("..")) {
        range.last = reader.number();
        range.step = range.last < range.first ? -1 : 1;
        if (reader.skip("x") || reader.skip(":")) {
            const int64_t step = reader.number();
            if (step == 0)
                reader.fail("a step is not 0");
            if ((step < 0) != (range.step < 0) && range.first != range.last)
                reader.fail(fmt::format("its step leads away from {}: write x{}", range.last, -step));
            range.step = step;
        }
    }
    if (!reader.at_end())
        reader.fail("write frames like 1-100, 1-100x2 or 1,3,5..9");
    return range;
}

} // namespace

std::vector<int64_t> parse_frame_range(std::string_view option, std::string_view text) {
    std::vector<Range> ranges;
    int64_t total = 0;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(',', begin), text.size());
        ranges.push_back(parse_part(option, text.substr(begin, end - begin)));
        total += ranges.back().count();
        if (total > max_frame_count)
            throw UsageError(
                fmt::format("{}: more than {} frames; render them in several runs", option, max_frame_count));
        begin = end + 1;
    }

    std::vector<int64_t> frames;
    frames.reserve(size_t(total));
    std::unordered_set<int64_t> seen;
    for (const Range& range : ranges)
        for (int64_t i = 0; i < range.count(); ++i)
            if (const int64_t frame = range.first + i * range.step; seen.insert(frame).second)
                frames.push_back(frame);
    return frames;
}

} // namespace proxima
