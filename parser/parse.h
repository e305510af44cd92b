// SPDX-License-Identifier: Apache-2.0
// Text -> TokenProgram, once for each file.
#pragma once
#include "parser/diagnostics.h"
#include "parser/source_files.h"
#include "parser/token.h"

namespace proxima {

/// Parses one text. Mistakes go to `diagnostics`; then the program is not valid.
TokenProgram parse_text(const SourceFiles& files, uint32_t file, SymbolTable& symbols, Diagnostics& diagnostics);

} // namespace proxima
