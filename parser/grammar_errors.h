// SPDX-License-Identifier: Apache-2.0
// What to say when a rule of the grammar fails that has to match once its beginning did.
#pragma once
#include "parser/grammar.h"

namespace proxima::grammar {

template <class> inline constexpr const char* error_message = nullptr;
template <> inline constexpr const char* error_message<comment_rest> = "this comment is not closed";
template <> inline constexpr const char* error_message<string_rest> = "this string is not closed";
template <> inline constexpr const char* error_message<number_end> = "this is no number";
template <> inline constexpr const char* error_message<directive_name> = "a directive's name must follow the #";

struct Messages {
    template <class Rule> static constexpr const char* message = error_message<Rule>;
};

/// Throws pegtl::parse_error where a rule with a message fails.
template <class Rule> using control = pegtl::must_if<Messages, pegtl::normal, false>::control<Rule>;

} // namespace proxima::grammar
