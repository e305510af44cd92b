// SPDX-License-Identifier: Apache-2.0
// What stays from one evaluation to the next: the texts, their token programs and the names in them.
#pragma once
#include "parser/parse.h"
#include "parser/source_files.h"
#include "parser/symbols.h"
#include "parser/token.h"

#include <memory>
#include <vector>

namespace proxima {

struct ScriptSources {
    SourceFiles files;
    SymbolTable symbols;
    std::vector<std::unique_ptr<TokenProgram>> programs; ///< by file; parsed when first needed

    /// The file's program, or nullptr when it has mistakes (they are reported).
    TokenProgram* program(uint32_t file, Diagnostics& diagnostics);
};

} // namespace proxima
