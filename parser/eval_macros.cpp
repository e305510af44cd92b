// SPDX-License-Identifier: Apache-2.0
// Macros. A call may stand wherever a token may: it is replaced by the macro's tokens, whatever they are.
#include "parser/evaluator.h"
#include "parser/macro.h"

#include <fmt/format.h>

namespace proxima {

/// `#macro Name(A, B) ... #end`
void Evaluator::run_macro(const Token& directive) {
    ++cursor_;
    const SourceSpan declared = span(*cursor_);
    const Symbol symbol = declared_name();
    if (const Binding* known = scopes_.find(symbol);
        known && !std::holds_alternative<MacroRef>(known->value) && !std::holds_alternative<Refused>(known->value))
        fail(cursor_[-1], fmt::format("'{}' is {} already", spelling(cursor_[-1]), value_description(known->value)));
    Macro macro{program_, &directive, nullptr, {}};
    const auto expect_here = [&](TokenKind kind, const char* expected) {
        if (cursor_->kind != kind)
            fail(*cursor_, fmt::format("unexpected '{}'", spelling(*cursor_)), expected);
        ++cursor_;
    };
    expect_here(TokenKind::left_paren, "expected '(' and the names of the parameters");
    while (cursor_->kind != TokenKind::right_paren) {
        macro.parameters.push_back(declared_name());
        if (cursor_->kind == TokenKind::comma)
            ++cursor_;
    }
    expect_here(TokenKind::right_paren, "expected ')'");
    macro.body = cursor_;
    Binding& binding = scopes_.declare(symbol);
    binding.value = std::make_shared<const Macro>(std::move(macro));
    binding.declared = declared;
    binding.predeclared = sources_.is_standard(program_->file);
    cursor_ = &program_->tokens[directive.index + 1];
}

/// Whether an argument is a name and nothing else, or an element of an array.
bool Evaluator::names_one_thing(const Token& token) {
    const Value* value = token.kind == TokenKind::name ? named_value(token) : nullptr;
    if (!value)
        return false;
    if (std::holds_alternative<DataFileRef>(*value))
        fail(token, "an open file cannot be passed to a macro", "use its name in the macro: it is known there");
    const TokenKind after = (element_.name == &token ? element_.after : &token + 1)->kind;
    return after == TokenKind::comma || after == TokenKind::right_paren;
}

/// Goes on in the macro's body. An argument that is a name alone is that name: the macro may change it.
void Evaluator::call_macro(const Token& name) {
    struct Argument {
        std::optional<BindingRef> reference;
        Value value;
        SourceSpan place;
    };
    const Nesting nesting(*this);
    const MacroRef macro = std::get<MacroRef>(lookup(name)->value);
    if (frames_.size() >= macro_depth_limit)
        fail(name, fmt::format("macros call each other more than {} deep", macro_depth_limit));
    cursor_ += 2; // the name and its parenthesis
    std::vector<Argument> arguments;
    for (size_t i = 0; i < macro->parameters.size(); ++i) {
        const Token& token = peek();
        if (token.kind == TokenKind::right_paren)
            fail(token, fmt::format("'{}' takes {} arguments, here are {}", sources_.symbols.name(name.index),
                                    macro->parameters.size(), i));
        Argument& argument = arguments.emplace_back();
        argument.place = span(token);
        if (names_one_thing(token)) {
            argument.reference = scopes_.reference_to(token.index);
            if (element_.name == &token)
                argument.reference->element = element_.path;
            advance();
        } else {
            argument.value = right_hand_side();
        }
        after_value(TokenKind::comma);
        accept(TokenKind::comma);
    }
    expect(TokenKind::right_paren);

    frames_.push_back({program_, cursor_, loops_.size(), macro->opener});
    scopes_.enter();
    for (size_t i = 0; i < arguments.size(); ++i) {
        Binding& binding = scopes_.bind_parameter(macro->parameters[i]);
        binding.value = std::move(arguments[i].value);
        binding.reference = arguments[i].reference;
        binding.declared = arguments[i].place;
    }
    program_ = macro->program;
    cursor_ = macro->body;
}

/// Leaves the macro whose end is under the cursor. POV-Ray does so without a thought even where no directive may stand.
bool Evaluator::leave_macro() {
    if (cursor_->directive != Directive::end || frames_.empty() || !frames_.back().macro ||
        &program_->tokens[cursor_->index] != frames_.back().macro)
        return false;
    leave_frame();
    return true;
}

} // namespace proxima
