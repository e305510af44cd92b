// SPDX-License-Identifier: Apache-2.0
// The tokens of the scene language as PEGTL rules. What the tokens mean together is the evaluator's matter: directives
// may stand between any two of them. Included by parse.cpp and by the grammar's test alone.
#pragma once
#include "parser/decimal.h"

#include <tao/pegtl.hpp>

namespace proxima::grammar {
namespace pegtl = tao::pegtl;
// clang-format off

// What separates tokens. Comments between /* and */ nest.
struct byte_order_mark : pegtl::string<'\xef', '\xbb', '\xbf'> {};
struct blank : pegtl::ranges<'\t', '\r', ' '> {}; // '\t' to '\r' are all that ASCII has besides the space
struct line_comment : pegtl::seq<pegtl::string<'/', '/'>, pegtl::until<pegtl::eolf>> {};
struct comment_rest; // a rule of its own, below: no depth of comments may exhaust the stack
struct nested_comment : pegtl::seq<pegtl::string<'/', '*'>, comment_rest> {};
struct comment : pegtl::seq<pegtl::at<pegtl::one<'/'>>, pegtl::sor<line_comment, nested_comment>> {};
struct space : pegtl::seq<pegtl::star<blank>, pegtl::star<comment, pegtl::star<blank>>> {};

// Names and reserved words.
struct identifier_start : pegtl::sor<pegtl::alpha, pegtl::one<'_'>> {};
struct identifier_part : pegtl::sor<pegtl::alnum, pegtl::one<'_'>> {};
struct identifier : pegtl::seq<identifier_start, pegtl::star<identifier_part>> {};

// Numbers have no sign of their own.
struct exponent : pegtl::seq<pegtl::one<'e', 'E'>, pegtl::opt<pegtl::one<'+', '-'>>, pegtl::plus<pegtl::digit>> {};
struct mantissa : pegtl::sor<pegtl::seq<pegtl::plus<pegtl::digit>, pegtl::opt<pegtl::one<'.'>, pegtl::star<pegtl::digit>>>,
                             pegtl::seq<pegtl::one<'.'>, pegtl::plus<pegtl::digit>>> {};
struct number : pegtl::seq<mantissa, pegtl::opt<exponent>> {};
struct number_end : pegtl::not_at<pegtl::sor<pegtl::one<'.'>, pegtl::one<'e', 'E'>>> {};
struct whole_number : pegtl::seq<number, number_end> {};

// Strings.
struct quote : pegtl::one<'"'> {};
struct string_part : pegtl::sor<pegtl::seq<pegtl::one<'\\'>, pegtl::any>, pegtl::not_one<'"', '\\', '\n'>> {};
struct string_rest : pegtl::until<quote, string_part> {};
struct text : pegtl::seq<quote, string_rest> {};

// Directives.
struct directive_name : identifier {};
struct directive : pegtl::seq<pegtl::one<'#'>, pegtl::star<pegtl::one<' ', '\t'>>, directive_name> {};

// Brackets, operators and separators.
struct left_brace : pegtl::one<'{'> {};
struct right_brace : pegtl::one<'}'> {};
struct left_paren : pegtl::one<'('> {};
struct right_paren : pegtl::one<')'> {};
struct left_bracket : pegtl::one<'['> {};
struct right_bracket : pegtl::one<']'> {};
struct less_equal : pegtl::string<'<', '='> {};
struct greater_equal : pegtl::string<'>', '='> {};
struct not_equal : pegtl::string<'!', '='> {};
struct left_angle : pegtl::one<'<'> {};
struct right_angle : pegtl::one<'>'> {};
struct equal : pegtl::one<'='> {};
struct plus : pegtl::one<'+'> {};
struct minus : pegtl::one<'-'> {};
struct star : pegtl::one<'*'> {};
struct slash : pegtl::one<'/'> {};
struct bang : pegtl::one<'!'> {};
struct ampersand : pegtl::one<'&'> {};
struct bar : pegtl::one<'|'> {};
struct question : pegtl::one<'?'> {};
struct colon : pegtl::one<':'> {};
struct comma : pegtl::one<','> {};
struct semicolon : pegtl::one<';'> {};
struct dot : pegtl::one<'.'> {};
struct bracket : pegtl::sor<left_brace, right_brace, left_paren, right_paren, left_bracket, right_bracket> {};
struct punctuation : pegtl::sor<comma, bracket, less_equal, greater_equal, not_equal, left_angle, right_angle, semicolon, minus,
                                plus, star, slash, equal, dot, bang, ampersand, bar, question, colon> {};

// A literal sphere: sphere { <number, number, number>, number } with texture { Name }, with
// pigment { rgb <number, number, number> } (color may stand before rgb) or with neither.
// Big scenes consist of them: this rule is tried first, and whatever it cannot match is read as ordinary tokens.
struct sphere_keyword : pegtl::seq<pegtl::string<'s', 'p', 'h', 'e', 'r', 'e'>, pegtl::not_at<identifier_part>> {};
struct texture_keyword : pegtl::string<'t', 'e', 'x', 't', 'u', 'r', 'e'> {};
struct literal_number; // a rule of its own, below: it reads the value while it matches
template <class Rule> struct spaced : pegtl::seq<Rule, space> {};
struct separator : pegtl::seq<space, pegtl::one<','>, space> {};
struct literal_vector : pegtl::seq<spaced<pegtl::one<'<'>>, literal_number, separator, literal_number, separator, literal_number,
                                   space, pegtl::one<'>'>> {};
struct literal_texture_name : identifier {};
struct literal_texture : pegtl::seq<spaced<texture_keyword>, spaced<pegtl::one<'{'>>, spaced<literal_texture_name>,
                                    spaced<pegtl::one<'}'>>> {};
struct pigment_keyword : pegtl::string<'p', 'i', 'g', 'm', 'e', 'n', 't'> {};
struct color_keyword : pegtl::seq<pegtl::string<'c', 'o', 'l', 'o', 'r'>, pegtl::plus<blank>> {};
struct rgb_keyword : pegtl::string<'r', 'g', 'b'> {};
struct literal_pigment : pegtl::seq<spaced<pigment_keyword>, spaced<pegtl::one<'{'>>, pegtl::opt<color_keyword>, spaced<rgb_keyword>,
                                    spaced<literal_vector>, spaced<pegtl::one<'}'>>> {};
struct literal_begin : pegtl::seq<sphere_keyword, space, pegtl::one<'{'>, space> {};
struct literal_sphere : pegtl::seq<literal_begin, literal_vector, separator, literal_number, space, pegtl::opt<pegtl::sor<literal_texture, literal_pigment>>,
                                   pegtl::one<'}'>> {};

struct unexpected : pegtl::any {};
struct token : pegtl::sor<literal_sphere, identifier, whole_number, punctuation, directive, text, unexpected> {};
struct scene : pegtl::seq<pegtl::opt<byte_order_mark>, space, pegtl::until<pegtl::eof, spaced<token>>> {};

// clang-format on

/// The rest of a comment after its opening.
struct comment_rest {
    using rule_t = comment_rest;
    using subs_t = pegtl::empty_list;

    template <class Input> static bool match(Input& in) {
        size_t depth = 1;
        const size_t size = in.size();
        for (size_t i = 0; i + 1 < size; ++i) {
            const bool opens = in.peek_char(i) == '/' && in.peek_char(i + 1) == '*';
            const bool closes = in.peek_char(i) == '*' && in.peek_char(i + 1) == '/';
            if (!opens && !closes)
                continue;
            depth = opens ? depth + 1 : depth - 1;
            ++i;
            if (depth == 0) {
                in.bump(i + 1);
                return true;
            }
        }
        return false;
    }
};

/// A number with an optional minus. Its value goes to the states' literal_number().
struct literal_number {
    using rule_t = literal_number;
    using subs_t = pegtl::empty_list;

    template <pegtl::apply_mode, pegtl::rewind_mode, template <class...> class, template <class...> class, class Input,
              class... States>
    static bool match(Input& in, States&&... states) {
        double value = 0;
        const char* const end = read_decimal(in.current(), in.end(), value);
        if (!end)
            return false;
        in.bump_in_this_line(size_t(end - in.current()));
        (states.literal_number(value), ...);
        return true;
    }
};

} // namespace proxima::grammar
