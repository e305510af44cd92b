// SPDX-License-Identifier: Apache-2.0
// The evaluator's stream of tokens and the messages about what stands in it.
#include "parser/evaluator.h"
#include "parser/standard_includes.h"

#include <fmt/format.h>

namespace proxima {
namespace {

const char* kind_spelling(TokenKind kind) {
    switch (kind) {
    case TokenKind::left_brace:
        return "{";
    case TokenKind::right_brace:
        return "}";
    case TokenKind::left_paren:
        return "(";
    case TokenKind::right_paren:
        return ")";
    case TokenKind::left_bracket:
        return "[";
    case TokenKind::right_bracket:
        return "]";
    case TokenKind::left_angle:
        return "<";
    case TokenKind::right_angle:
        return ">";
    case TokenKind::equal:
        return "=";
    case TokenKind::comma:
        return ",";
    case TokenKind::semicolon:
        return ";";
    case TokenKind::colon:
        return ":";
    default:
        return "?";
    }
}

} // namespace

Evaluator::Nesting::Nesting(Evaluator& evaluator) : evaluator(evaluator) {
    if (evaluator.nesting_ >= nesting_limit)
        evaluator.fail(*evaluator.cursor_, fmt::format("this is nested more than {} deep", nesting_limit));
    ++evaluator.nesting_;
}

void Evaluator::fail_expected(TokenKind kind) {
    fail_unexpected(fmt::format("'{}'", kind_spelling(kind)));
}

std::string_view Evaluator::spelling(const Token& token) const {
    return sources_.files.text(program_->file).substr(token.offset, token.length);
}

void Evaluator::fail(const Token& token, std::string message, std::string hint) const {
    throw SceneError(span(token), std::move(message), std::move(hint));
}

void Evaluator::warn(const Token& token, std::string message, std::string hint) {
    diagnostics_.warning(span(token), std::move(message), std::move(hint));
}

void Evaluator::fail_unexpected(const std::string& expected) {
    const Token& token = peek();
    const std::string hint = "expected " + expected;
    const std::string_view text = spelling(token);
    switch (token.kind) {
    case TokenKind::end_of_text:
        fail(token, "the scene ends here", hint + unclosed_item());
    case TokenKind::sphere_run:
        fail(token, "unexpected 'sphere'", hint);
    case TokenKind::word:
        // Some words are supported in one place and refused in all others: cylinder.
        if (const std::string_view advice = word_advice(text);
            token.index >= uint32_t(Word::first_unsupported) || !advice.empty()) {
            fail(token, fmt::format("Proxima does not support '{}'", text),
                 advice.empty() ? hint : std::string(advice));
        }
        break;
    case TokenKind::name:
        if (const Binding* binding = scopes_.find(token.index)) {
            if (const Refused* refused = std::get_if<Refused>(&binding->value))
                fail_refused(token, text, *refused);
            fail(token, fmt::format("unexpected '{}', which is {}", text, value_description(binding->value)), hint);
        }
        fail_undeclared(token, text, expected);
    default:
        break;
    }
    fail(token, fmt::format("unexpected '{}'", text), hint);
}

void Evaluator::fail_refused(const Token& token, std::string_view name, const Refused& refused) {
    const std::string_view advice = word_advice(refused.word);
    fail(token, fmt::format("'{}' needs '{}', which Proxima does not support", name, refused.word),
         advice.empty() ? "declare something of your own instead" : std::string(advice));
}

void Evaluator::fail_undeclared(const Token& token, std::string_view name, const std::string& expected) {
    // The mistake in its declaration was reported: this one only follows from it.
    if (failed_names_.contains(sources_.symbols.intern(name)))
        throw SceneError(span(token), "");
    if (const StandardFile* standard = standard_file_of(name))
        fail(token, fmt::format("'{}' is not declared", name),
             fmt::format("it is in {0}: write #include \"{0}\" before it", standard->name));
    const std::string near = suggestion(name);
    fail(token, fmt::format("'{}' is not declared", name), near.empty() ? "expected " + expected : near);
}

/// For the message about a text that ends too soon.
std::string Evaluator::unclosed_item() const {
    if (!in_item_ || item_frames_ != frames_.size())
        return {};
    const uint32_t line = sources_.files.line_column(span(*item_start_).location).line;
    return fmt::format("; is the item that begins in line {} closed?", line);
}

std::string Evaluator::suggestion(std::string_view name) const {
    std::vector<std::string_view> candidates;
    for (Symbol symbol = 0; symbol < scopes_.bindings().size(); ++symbol)
        if (!scopes_.bindings()[symbol].empty())
            candidates.push_back(sources_.symbols.name(symbol));
    for (Symbol symbol = 0; symbol < uint32_t(Word::break_); ++symbol)
        candidates.push_back(sources_.symbols.name(symbol));
    const std::string near = nearest_name(name, candidates);
    return near.empty() ? "" : fmt::format("did you mean '{}'?", near);
}

} // namespace proxima
