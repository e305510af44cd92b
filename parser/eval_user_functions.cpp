// SPDX-License-Identifier: Apache-2.0
// Calls of the functions and splines that a scene declares.
#include "parser/evaluator.h"
#include "parser/function_reader.h"
#include "parser/spline.h"

#include <fmt/format.h>

namespace proxima {

/// Stands in the body of a function while it is alive.
class Evaluator::FunctionCall {
public:
    FunctionCall(Evaluator& evaluator, UserFunction& function)
        : evaluator_(evaluator), program_(evaluator.program_), cursor_(evaluator.cursor_) {
        evaluator.scopes_.enter();
        evaluator.program_ = &function.body;
        evaluator.cursor_ = function.body.tokens.data();
    }
    FunctionCall(const FunctionCall&) = delete;
    ~FunctionCall() {
        evaluator_.scopes_.leave();
        evaluator_.program_ = program_;
        evaluator_.cursor_ = cursor_;
    }
    void bind(Symbol symbol, Value value) { evaluator_.scopes_.bind_parameter(symbol).value = std::move(value); }

private:
    Evaluator& evaluator_;
    TokenProgram* program_;
    const Token* cursor_;
};

/// `function (parameters) { expression }` after its word.
Value Evaluator::function_value() {
    return std::make_shared<UserFunction>(FunctionReader(*this).read());
}

bool Evaluator::is_callable(const Value* value) {
    return value && (std::holds_alternative<FunctionRef>(*value) || std::holds_alternative<SplineRef>(*value));
}

/// Whether the name under the cursor is that of a function or spline which is called.
bool Evaluator::starts_call(const Token& name) {
    return is_callable(named_value(name)) &&
           (element_.name == &name ? element_.after : &name + 1)->kind == TokenKind::left_paren;
}

/// The value of the function or spline whose name is under the cursor, at the arguments behind it.
Terms Evaluator::call_declared(const Token& name) {
    const Nesting nesting(*this);
    const Value callee = *named_value(name);
    advance();
    expect(TokenKind::left_paren);
    if (const FunctionRef* function = std::get_if<FunctionRef>(&callee))
        return call_user_function(name, **function);
    return call_spline(*std::get<SplineRef>(callee));
}

Terms Evaluator::call_user_function(const Token& name, UserFunction& function) {
    std::vector<Terms> arguments;
    for (const Symbol parameter : function.parameters) {
        if (!arguments.empty())
            separator();
        const SourceSpan place = span(peek());
        const Terms& argument = arguments.emplace_back(sum());
        if (argument.count != 1)
            throw SceneError(place,
                             fmt::format("the argument {} of this function is a number, not {}",
                                         sources_.symbols.name(parameter), value_description(argument)),
                             "take one term of it, like .x");
    }
    expect(TokenKind::right_paren);
    Terms result;
    {
        FunctionCall call(*this, function);
        for (const UserFunction::Capture& capture : function.captures)
            call.bind(capture.symbol, capture.value);
        for (size_t i = 0; i < arguments.size(); ++i)
            call.bind(function.parameters[i], arguments[i]);
        result = sum();
    }
    if (!result.finite())
        fail(name, fmt::format("'{}' has no finite value here", spelling(name)));
    return result;
}

/// A function does not change its value, and nothing else becomes a function.
void Evaluator::check_redeclaration(const Token& name, const Value& old, const Value& value) const {
    const bool was_function = std::holds_alternative<FunctionRef>(old);
    const bool has_value = !std::holds_alternative<std::monostate>(old) && !std::holds_alternative<Refused>(old);
    const bool is_function = std::holds_alternative<FunctionRef>(value);
    if ((was_function && !std::holds_alternative<std::monostate>(value)) || (is_function && has_value))
        fail(name, fmt::format("'{}' is {} already", spelling(name), value_description(old)),
             fmt::format("#undef {} before it becomes something else", spelling(name)));
}

} // namespace proxima
