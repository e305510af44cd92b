// SPDX-License-Identifier: Apache-2.0
// What is wrong with a scene, gathered while it is parsed and evaluated, and shown as a compiler does: the place, the
// line with a caret, what was expected, and a near name.
#pragma once
#include "parser/source_files.h"
#include "parser/source_location.h"

#include <cstdint>
#include <exception>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace proxima {

enum class Severity { error, warning, note };

/// A stretch of one text.
struct SourceSpan {
    SourceLocation location;
    uint32_t length = 1; ///< bytes; at least 1
};

struct Diagnostic {
    Severity severity = Severity::error;
    SourceSpan place;
    std::string message;
    std::string hint; ///< a second line ("expected ...", "did you mean ..."); may be empty
};

/// A mistake in the scene; thrown where it is found and caught at the end of the item that holds it.
class SceneError : public std::exception {
public:
    SceneError(SourceSpan place, std::string message, std::string hint = {});
    const char* what() const noexcept override { return diagnostic.message.c_str(); }

    Diagnostic diagnostic;
};

/// Mistakes, warnings and notes in the order that they were found. Mistakes at one place are one, and so are equal
/// warnings.
class Diagnostics {
public:
    static constexpr size_t shown_limit = 20;  ///< of each severity, when formatted
    static constexpr size_t kept_limit = 1000; ///< past it, warnings and notes are dropped

    void report(Diagnostic diagnostic);
    void error(SourceSpan place, std::string message, std::string hint = {});
    void warning(SourceSpan place, std::string message, std::string hint = {});
    void note(SourceSpan place, std::string message, std::string hint = {});

    bool has_errors() const { return error_count_ > 0; }
    size_t error_count() const { return error_count_; }
    const std::vector<Diagnostic>& all() const { return all_; }

    /// Everything as text: `file:line:column: error: message`, the line, a caret, the hint.
    std::string format(const SourceFiles& files) const;

private:
    std::vector<Diagnostic> all_;
    size_t error_count_ = 0;
};

/// One diagnostic as text, ending in a line's end.
std::string format_diagnostic(const Diagnostic& diagnostic, const SourceFiles& files);

/// The candidate nearest to `name` by edit distance, or "" when none is near.
std::string nearest_name(std::string_view name, std::span<const std::string_view> candidates);

} // namespace proxima
