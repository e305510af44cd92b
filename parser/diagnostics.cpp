// SPDX-License-Identifier: Apache-2.0
#include "parser/diagnostics.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace proxima {
namespace {

const char* severity_name(Severity severity) {
    switch (severity) {
    case Severity::error:
        return "error";
    case Severity::warning:
        return "warning";
    default:
        return "note";
    }
}

/// The part of a line that is shown: long lines are cut around the place.
struct Excerpt {
    std::string text;
    size_t caret = 0;
};

Excerpt excerpt(std::string_view line, size_t column) {
    constexpr size_t width = 120;
    constexpr size_t before = 60;
    Excerpt result;
    size_t start = 0;
    if (line.size() > width && column > before) {
        start = column - before;
        result.text = "...";
    }
    result.caret = result.text.size() + (column - start);
    for (const char c : line.substr(start, width))
        result.text += c >= ' ' && c < 127 ? c : c == '\t' ? ' ' : '?'; // one column a byte, for the caret
    if (line.size() > start + width)
        result.text += "...";
    return result;
}

/// Levenshtein's distance, with a swap of neighbours as one step (Damerau), or `limit` + 1 when it is larger.
size_t edit_distance(std::string_view a, std::string_view b, size_t limit) {
    if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > limit)
        return limit + 1;
    std::vector<size_t> before_last(b.size() + 1), last(b.size() + 1), current(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j)
        last[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t change = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({last[j] + 1, current[j - 1] + 1, change});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before_last[j - 2] + 1);
        }
        before_last.swap(last);
        last.swap(current);
    }
    return last[b.size()];
}

bool same_place(const Diagnostic& a, const Diagnostic& b) {
    return a.severity == b.severity && a.place.location.file == b.place.location.file &&
           a.place.location.offset == b.place.location.offset &&
           (a.severity == Severity::error || a.message == b.message);
}

} // namespace

SceneError::SceneError(SourceSpan place, std::string message, std::string hint)
    : diagnostic{Severity::error, place, std::move(message), std::move(hint)} {}

void Diagnostics::report(Diagnostic diagnostic) {
    if (std::any_of(all_.begin(), all_.end(), [&](const Diagnostic& other) { return same_place(diagnostic, other); }))
        return;
    if (diagnostic.severity == Severity::error)
        ++error_count_;
    else if (all_.size() >= kept_limit)
        return;
    all_.push_back(std::move(diagnostic));
}

void Diagnostics::error(SourceSpan place, std::string message, std::string hint) {
    report({Severity::error, place, std::move(message), std::move(hint)});
}

void Diagnostics::warning(SourceSpan place, std::string message, std::string hint) {
    report({Severity::warning, place, std::move(message), std::move(hint)});
}

void Diagnostics::note(SourceSpan place, std::string message, std::string hint) {
    report({Severity::note, place, std::move(message), std::move(hint)});
}

std::string Diagnostics::format(const SourceFiles& files) const {
    std::string result;
    std::array<size_t, 3> count{};
    for (const Diagnostic& diagnostic : all_)
        if (++count[size_t(diagnostic.severity)] <= shown_limit)
            result += format_diagnostic(diagnostic, files);
    if (count[0] > shown_limit)
        result += fmt::format("{} more mistakes are not shown\n", count[0] - shown_limit);
    return result;
}

std::string format_diagnostic(const Diagnostic& diagnostic, const SourceFiles& files) {
    const SourceLocation location = diagnostic.place.location;
    const LineColumn at = files.line_column(location);
    const std::string_view line = files.line_text(location);
    const size_t column = std::min<size_t>(at.column - 1, line.size());
    const Excerpt shown = excerpt(line, column);
    const size_t room = shown.text.size() > shown.caret ? shown.text.size() - shown.caret : 1;
    const size_t length = std::clamp<size_t>(diagnostic.place.length, 1, room);

    std::string result = fmt::format("{}:{}:{}: {}: {}\n", files.name(location.file), at.line, at.column,
                                     severity_name(diagnostic.severity), diagnostic.message);
    result += fmt::format("  {}\n  {}^{}\n", shown.text, std::string(shown.caret, ' '), std::string(length - 1, '~'));
    if (!diagnostic.hint.empty())
        result += fmt::format("  {}\n", diagnostic.hint);
    return result;
}

std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates) {
    size_t best = name.size() <= 2 ? 0 : name.size() <= 5 ? 1 : name.size() <= 8 ? 2 : 3;
    std::string_view nearest;
    for (const std::string_view candidate : candidates) {
        const size_t distance = edit_distance(name, candidate, best);
        if (distance > 0 && distance <= best && distance < candidate.size() && (nearest.empty() || distance < best)) {
            best = distance;
            nearest = candidate;
        }
    }
    return std::string(nearest);
}

} // namespace proxima
