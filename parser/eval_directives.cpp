// SPDX-License-Identifier: Apache-2.0
// Directives: conditions and loops. They run when the token after them is asked for.
#include "parser/evaluator.h"

#include <cmath>
#include <fmt/format.h>

namespace proxima {

bool Evaluator::Loop::goes_on(double value) const {
    return step > 0 ? value - end < epsilon : value - end > -epsilon; // a sum would round it away at large ends
}

/// Does what has to be done before the token under the cursor may be looked at. False when that is nothing.
bool Evaluator::interrupt() {
    const Token& token = *cursor_;
    if (token.kind == TokenKind::name) {
        const Binding* binding = scopes_.find(token.index);
        if (!binding || !std::holds_alternative<MacroRef>(binding->value))
            return false;
        call_macro(token);
    } else if (token.kind == TokenKind::end_of_text) {
        if (frames_.empty())
            return false;
        leave_frame();
    } else {
        run_directive(token);
        directive_before_ = true;
    }
    return true;
}

void Evaluator::run_directive(const Token& directive) {
    if (++steps_ > next_check_)
        check_budget();
    if (graph_.is_crowded())
        collect_nodes();
    const Nesting nesting(*this);
    if (!in_item_)
        item_start_ = cursor_;
    switch (directive.directive) {
    case Directive::if_:
    case Directive::ifdef:
    case Directive::ifndef:
        return run_if(directive);
    case Directive::elseif:
    case Directive::else_:
        // The branch before this one was taken, or the cases before it fell through.
        if (directive.directive == Directive::else_ &&
            program_->tokens[directive.index].directive == Directive::switch_) {
            ++cursor_;
            return;
        }
        cursor_ = &program_->tokens[program_->tokens[directive.index].index];
        return;
    case Directive::switch_:
        return run_switch(directive);
    case Directive::case_:
    case Directive::range:
        // Fallen through from the case before: its condition does not matter, but POV-Ray reads it.
        ++cursor_;
        case_values(directive);
        return;
    case Directive::break_: {
        const Token& opener = program_->tokens[directive.index];
        if (opener.directive != Directive::switch_)
            leave_loop(opener);
        cursor_ = &program_->tokens[opener.index + 1];
        return;
    }
    case Directive::while_:
        return run_while(directive);
    case Directive::for_:
        return run_for(directive);
    case Directive::end:
        return run_end(directive);
    case Directive::macro:
        return run_macro(directive);
    case Directive::declare:
    case Directive::local:
        return run_declare(directive);
    case Directive::undef:
        return run_undef();
    case Directive::include:
        return run_include(directive);
    case Directive::version:
        return run_version();
    case Directive::default_:
        return run_default();
    case Directive::debug:
    case Directive::warning:
    case Directive::error:
        return run_message(directive);
    case Directive::fopen:
        return run_fopen();
    case Directive::fclose:
        return run_fclose();
    case Directive::read:
        return run_read();
    default:
        fail(directive, fmt::format("Proxima does not support {}", spelling(directive)), "a scene writes no files");
    }
}

bool Evaluator::condition(const Token& directive) {
    ++cursor_;
    if (directive.directive == Directive::if_ || directive.directive == Directive::elseif ||
        directive.directive == Directive::while_) {
        expect(TokenKind::left_paren);
        const Token& at = peek();
        const Terms value = expression();
        if (value.count != 1)
            fail(at, "a condition must be a number");
        if (value.nodes)
            look_at(span(directive), directive, value.nodes);
        expect(TokenKind::right_paren);
        return std::abs(value.value[0]) > epsilon;
    }
    // #ifdef and #ifndef take a name as it stands.
    const auto expect_here = [&](TokenKind kind) {
        if (cursor_->kind != kind)
            fail(*cursor_, fmt::format("unexpected '{}'", spelling(*cursor_)), "expected a name in parentheses");
    };
    expect_here(TokenKind::left_paren);
    ++cursor_;
    expect_here(TokenKind::name);
    const bool defined = name_is_defined();
    expect_here(TokenKind::right_paren);
    ++cursor_;
    return defined == (directive.directive == Directive::ifdef);
}

void Evaluator::run_if(const Token& directive) {
    const Token* branch = &directive;
    while (!condition(*branch)) {
        branch = &program_->tokens[branch->target];
        cursor_ = branch;
        if (branch->directive != Directive::elseif) {
            ++cursor_;
            return;
        }
    }
}

/// The numbers in the parentheses of a #case or #range.
std::pair<double, double> Evaluator::case_values(const Token& directive) {
    expect(TokenKind::left_paren);
    const double first = number();
    double last = first;
    if (directive.directive == Directive::range) {
        separator();
        last = number();
    }
    expect(TokenKind::right_paren);
    return {first, last};
}

void Evaluator::run_switch(const Token& directive) {
    ++cursor_;
    expect(TokenKind::left_paren);
    const double value = number();
    expect(TokenKind::right_paren);
    const Token* branch = &program_->tokens[directive.target];
    if (branch != cursor_ || (branch->directive != Directive::case_ && branch->directive != Directive::range))
        fail(directive, "a #case or #range must follow the #switch");
    for (; branch->directive == Directive::case_ || branch->directive == Directive::range;
         branch = &program_->tokens[branch->target]) {
        cursor_ = branch + 1;
        const auto [first, last] = case_values(*branch);
        if (branch->directive == Directive::case_ ? std::abs(value - first) < epsilon : value >= first && value <= last)
            return;
    }
    cursor_ = branch + 1;
}

void Evaluator::run_while(const Token& directive) {
    const uint64_t changes = changes_;
    if (condition(directive))
        loops_.push_back({.opener = &directive, .changes = changes});
    else
        cursor_ = &program_->tokens[directive.index + 1];
}

void Evaluator::run_for(const Token& directive) {
    ++cursor_;
    if (cursor_->kind != TokenKind::left_paren)
        fail(*cursor_, fmt::format("unexpected '{}'", spelling(*cursor_)), "expected '('");
    ++cursor_;
    const Token& variable_name = *cursor_;
    const Symbol variable = declared_name();
    const SourceSpan declared = span(variable_name);
    separator();
    const double start = number();
    Loop loop{.opener = &directive, .variable = variable, .start = start};
    separator();
    loop.end = number();
    if (accept(TokenKind::comma))
        loop.step = number();
    const Token& closing = peek();
    expect(TokenKind::right_paren);
    if (std::abs(loop.step) < epsilon)
        fail(closing, "the step of a loop must not be 0");
    if (const Binding* before = scopes_.find(variable); before && !sources_.is_standard(program_->file))
        check_redeclaration(variable_name, before->value, Terms(start));
    Binding& binding = scopes_.declare_local(variable);
    binding.value = Terms(start);
    binding.declared = declared;
    binding.used = true;
    loop.body = cursor_;
    if (loop.goes_on(start))
        loops_.push_back(loop);
    else
        cursor_ = &program_->tokens[directive.index + 1];
}

void Evaluator::run_end(const Token& directive) {
    ++cursor_;
    const Token& opener = program_->tokens[directive.index];
    if (opener.directive == Directive::macro && !frames_.empty() && frames_.back().macro == &opener)
        return leave_frame();
    if ((opener.directive != Directive::while_ && opener.directive != Directive::for_) || loops_.empty() ||
        loops_.back().opener != &opener)
        return;
    Loop& loop = loops_.back();
    if (loop.stopped) {
        loops_.pop_back();
        return;
    }
    if (opener.directive == Directive::while_) {
        if (loop.changes == changes_)
            fail(opener, "this loop never ends: nothing that its condition could depend on changes in it");
        loops_.pop_back();
        cursor_ = &opener;
        return;
    }
    // The script may have changed the variable: POV-Ray goes on from what it finds.
    Binding* binding = scopes_.find(loop.variable);
    Terms* variable = binding ? std::get_if<Terms>(&binding->value) : nullptr;
    if (!variable || variable->count != 1)
        fail(opener, "the variable of this loop is no number any more");
    if (variable->nodes) {
        look_at(span(opener), opener, variable->nodes);
        variable->nodes = 0;
    }
    variable->value[0] += loop.step;
    ++changes_;
    if (loop.goes_on(variable->value[0]))
        cursor_ = loop.body;
    else
        loops_.pop_back();
}

void Evaluator::leave_loop(const Token& opener) {
    while (!loops_.empty() && loops_.back().opener != &opener)
        loops_.pop_back();
    if (!loops_.empty())
        loops_.pop_back();
}

} // namespace proxima
