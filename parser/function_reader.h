// SPDX-License-Identifier: Apache-2.0
// Reads a function's expression when it is declared. POV-Ray's grammar there is not that of other expressions: no
// vectors, no ! and ?:, relations and & | stand anywhere, & binds stronger than |, and none of them has a tolerance.
// So the expression is checked and translated here: what is written with relations becomes calls of select. Directives
// and macros in it run now.
#pragma once
#include "parser/evaluator.h"
#include "parser/user_function.h"

#include <span>

namespace proxima {

class Evaluator::FunctionReader {
public:
    explicit FunctionReader(Evaluator& evaluator);

    /// Reads `(parameters) { expression }`; the word `function` was read.
    UserFunction read();

private:
    // What the grammar has, strongest last. Each appends its translation.
    void disjunction();
    void conjunction();
    void relation();
    void sum();
    void product();
    void operand();
    void name();
    void word();
    void call(size_t least, size_t most);

    void parameters();
    Symbol parameter();
    bool is_parameter(Symbol symbol) const;
    void check_next(TokenKind kind, const char* expected);
    void capture(const Token& name, const Value& value);
    /// Makes the operand from `start` on 1 where it is not 0.
    void make_truth(size_t start);

    size_t here() const { return function_.body.tokens.size(); }
    /// Appends the token under the cursor, which is stepped over.
    void take();
    Token& append(Token token);
    Token made(TokenKind kind) const;
    Token made(Word word) const;
    void append(TokenKind kind) { append(made(kind)); }
    void append_numbers(std::span<const double> numbers);
    void open_call(Word function, size_t start);

    Evaluator& evaluator_;
    UserFunction function_;
    const TokenProgram* home_; ///< where the function is declared: tokens of other texts get a place in it
    Token last_;               ///< the last token of home_
};

} // namespace proxima
