// SPDX-License-Identifier: Apache-2.0
// What each rule of the grammar hands to the TokenWriter.
#pragma once
#include "parser/grammar.h"
#include "parser/token_writer.h"

#include <string_view>

namespace proxima::grammar {

template <class Rule> struct action : pegtl::nothing<Rule> {};

/// The action of a rule that is a token by itself.
template <TokenKind kind> struct add_token {
    template <class Input> static void apply(const Input& in, TokenWriter& writer) {
        writer.add(kind, in.string_view());
    }
};

// clang-format off
template <> struct action<left_brace> : add_token<TokenKind::left_brace> {};
template <> struct action<right_brace> : add_token<TokenKind::right_brace> {};
template <> struct action<left_paren> : add_token<TokenKind::left_paren> {};
template <> struct action<right_paren> : add_token<TokenKind::right_paren> {};
template <> struct action<left_bracket> : add_token<TokenKind::left_bracket> {};
template <> struct action<right_bracket> : add_token<TokenKind::right_bracket> {};
template <> struct action<less_equal> : add_token<TokenKind::less_equal> {};
template <> struct action<greater_equal> : add_token<TokenKind::greater_equal> {};
template <> struct action<not_equal> : add_token<TokenKind::not_equal> {};
template <> struct action<left_angle> : add_token<TokenKind::left_angle> {};
template <> struct action<right_angle> : add_token<TokenKind::right_angle> {};
template <> struct action<equal> : add_token<TokenKind::equal> {};
template <> struct action<plus> : add_token<TokenKind::plus> {};
template <> struct action<minus> : add_token<TokenKind::minus> {};
template <> struct action<star> : add_token<TokenKind::star> {};
template <> struct action<slash> : add_token<TokenKind::slash> {};
template <> struct action<bang> : add_token<TokenKind::bang> {};
template <> struct action<ampersand> : add_token<TokenKind::ampersand> {};
template <> struct action<bar> : add_token<TokenKind::bar> {};
template <> struct action<question> : add_token<TokenKind::question> {};
template <> struct action<colon> : add_token<TokenKind::colon> {};
template <> struct action<comma> : add_token<TokenKind::comma> {};
template <> struct action<semicolon> : add_token<TokenKind::semicolon> {};
template <> struct action<dot> : add_token<TokenKind::dot> {};
// clang-format on

template <> struct action<identifier> {
    template <class Input> static void apply(const Input& in, TokenWriter& writer) {
        writer.add_identifier(in.string_view());
    }
};

template <> struct action<whole_number> {
    template <class Input> static void apply(const Input& in, TokenWriter& writer) {
        writer.add_number(in.string_view());
    }
};

template <> struct action<text> {
    template <class Input> static void apply(const Input& in, TokenWriter& writer) {
        writer.add_string(in.string_view());
    }
};

template <> struct action<directive> {
    template <class Input> static void apply(const Input& in, TokenWriter& writer) {
        const std::string_view piece = in.string_view();
        writer.add_directive(piece, piece.substr(piece.find_last_of("# \t") + 1));
    }
};

template <> struct action<unexpected> {
    template <class Input> static void apply(const Input& in, TokenWriter& writer) {
        writer.unexpected(in.string_view());
    }
};

template <> struct action<literal_begin> {
    static void apply0(TokenWriter& writer) { writer.begin_sphere(); }
};

template <> struct action<literal_texture_name> {
    template <class Input> static bool apply(const Input& in, TokenWriter& writer) {
        return writer.literal_texture(in.string_view());
    }
};

template <> struct action<literal_sphere> {
    template <class Input> static bool apply(const Input& in, TokenWriter& writer) {
        return writer.commit_sphere(in.string_view());
    }
};

} // namespace proxima::grammar
