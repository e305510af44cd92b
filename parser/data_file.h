// SPDX-License-Identifier: Apache-2.0
// A file of values for #read. In goes its text; out come numbers, vectors and strings, one after the other.
#pragma once
#include "parser/diagnostics.h"
#include "parser/value.h"

#include <string_view>

namespace proxima {

/// Values stand between commas; spaces, line ends and comments do not matter. POV-Ray drops whatever token stands
/// behind a value, be it the next value: anything but a comma is a mistake here.
class DataFile {
public:
    /// `text` is that of the SourceFiles' `file` and outlives this.
    DataFile(std::string_view text, uint32_t file) : text_(text), file_(file) {}

    /// Reads the next value and the comma behind it. False when there is none: `value` stays as it is.
    /// Throws SceneError with the place in the data file.
    bool read(Value& value);
    /// The last value was read, or was looked for in vain. A comma behind the last value hides the end, as in POV-Ray.
    bool ended() const { return ended_; }

private:
    void skip_space();
    void skip_comment();
    double number();
    Terms vector();
    std::string string();
    bool accept(char c);
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    [[noreturn]] void fail(const char* message, const char* hint = "") const;

    std::string_view text_;
    size_t at_ = 0;
    uint32_t file_ = 0;
    bool ended_ = false;
};

} // namespace proxima
