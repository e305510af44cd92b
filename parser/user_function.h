// SPDX-License-Identifier: Apache-2.0
// A function that a scene declares: its expression, translated into one that the evaluator's reader of expressions
// reads anew at each call, with the parameters bound to the arguments.
#pragma once
#include "parser/token.h"
#include "parser/value.h"

#include <vector>

namespace proxima {

struct UserFunction {
    static constexpr size_t token_limit = 20'000; ///< of the translated expression

    /// A value that a name had when the function was declared.
    struct Capture {
        Symbol symbol = 0;
        Value value;
    };

    TokenProgram body; ///< one expression and a token that ends it
    std::vector<Symbol> parameters;
    std::vector<Capture> captures;
};

} // namespace proxima
