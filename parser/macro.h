// SPDX-License-Identifier: Apache-2.0
// A macro: where its tokens are, and the names of its parameters.
#pragma once
#include "parser/token.h"

#include <vector>

namespace proxima {

struct Macro {
    TokenProgram* program = nullptr;
    const Token* opener = nullptr; ///< its #macro
    const Token* body = nullptr;
    std::vector<Symbol> parameters;
};

} // namespace proxima
