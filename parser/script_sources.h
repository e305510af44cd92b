// SPDX-License-Identifier: Apache-2.0
// What stays from one evaluation to the next: the texts, their token programs and the names in them.
#pragma once
#include "parser/parse.h"
#include "parser/source_files.h"
#include "parser/standard_includes.h"
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

    /// The index of a standard include file's text, which is no file.
    uint32_t standard_file(const StandardFile& standard);
    bool is_standard(uint32_t file) const { return file < standard.size() && standard[file]; }

    std::vector<const StandardFile*> standard; ///< by file; nullptr for the scene's own
};

} // namespace proxima
