// SPDX-License-Identifier: Apache-2.0
// What the evaluator does about numbers that follow from the time: notices when the script looks at one, so that each
// frame needs an evaluation of its own, and throws away expressions that nobody needs any more.
#include "parser/evaluator.h"
#include "parser/motion_roots.h"

#include <fmt/format.h>

namespace proxima {
namespace {

constexpr size_t most_nodes = 50'000'000; // 16 bytes each

bool opens(TokenKind kind) {
    return kind == TokenKind::left_paren || kind == TokenKind::left_brace || kind == TokenKind::left_bracket;
}
bool closes(TokenKind kind) {
    return kind == TokenKind::right_paren || kind == TokenKind::right_brace || kind == TokenKind::right_bracket;
}

} // namespace

/// The script looks at a number's value, for a condition, a size, a name and the like: `first` is its first token, or
/// the directive that looks. What follows from clock_delta alone is the same in all frames of an animation.
void Evaluator::look_at(SourceSpan place, const Token& first, NodeId nodes) {
    if (!graph_.records() || !graph_.changes_between_frames(nodes))
        return;
    std::string word = first.kind == TokenKind::directive ? std::string(spelling(first)) : word_before(first);
    std::string reason = fmt::format("'{}' looks at a number that follows from the time", word);
    stop_recording(place, std::move(word), std::move(reason));
}

/// The word, directive or function that a number stands behind.
std::string Evaluator::word_before(const Token& number) const {
    const std::vector<Token>& tokens = program_->tokens;
    if (&number < tokens.data() || &number >= tokens.data() + tokens.size())
        return "a macro"; // which the reader has left by now
    int depth = 0;
    for (const Token* token = &number; token-- != tokens.data();) {
        if (closes(token->kind))
            ++depth;
        else if (opens(token->kind))
            --depth;
        if (depth > 0)
            continue;
        if (token->kind == TokenKind::left_bracket)
            return "[";
        const bool is_call = token->kind == TokenKind::name && token[1].kind == TokenKind::left_paren;
        if (token->kind == TokenKind::word || token->kind == TokenKind::directive || is_call)
            return std::string(spelling(*token));
    }
    return "the script";
}

void Evaluator::stop_recording(SourceSpan place, std::string word, std::string reason) {
    if (!graph_.records())
        return;
    graph_.stop();
    const LineColumn at = sources_.files.line_column(place.location);
    obstacle_ = MotionObstacle{.file = sources_.files.name(place.location.file),
                               .line = at.line,
                               .column = at.column,
                               .word = std::move(word),
                               .reason = std::move(reason)};
    if (settings_.needs_motion)
        throw MotionImpossible{*obstacle_};
}

/// Frees the nodes that nothing needs any more. Only where no expression or object is half read.
void Evaluator::collect_nodes() {
    if (nesting_ > 0 || in_item_) {
        if (graph_.size() > most_nodes)
            stop_recording(span(*item_start_), "", "one object holds too many expressions that follow from the time");
        return;
    }
    mark_names(scopes_, graph_);
    builder_.mark_nodes();
    graph_.sweep();
    if (graph_.size() > most_nodes)
        stop_recording(span(*cursor_), "", "the script keeps too many numbers that follow from the time");
}

} // namespace proxima
