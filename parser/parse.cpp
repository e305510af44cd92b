// SPDX-License-Identifier: Apache-2.0
#include "parser/parse.h"

#include "parser/actions.h"
#include "parser/grammar_errors.h"

namespace proxima {

TokenProgram parse_text(const SourceFiles& files, uint32_t file, SymbolTable& symbols, Diagnostics& diagnostics) {
    using Input = grammar::pegtl::memory_input<grammar::pegtl::tracking_mode::lazy>;
    const std::string_view text = files.text(file);
    const size_t mistakes = diagnostics.error_count();
    TokenProgram program;
    program.file = file;
    TokenWriter writer(program, text, symbols, diagnostics);
    Input input(text.data(), text.data() + text.size(), "");
    try {
        grammar::pegtl::parse<grammar::scene, grammar::action, grammar::control>(input, writer);
        writer.finish();
    } catch (const grammar::pegtl::parse_error& error) {
        diagnostics.error({{file, uint32_t(error.positions().front().byte)}, 1}, std::string(error.message()));
    } catch (const SceneError& error) {
        diagnostics.report(error.diagnostic);
    }
    program.valid = diagnostics.error_count() == mistakes;
    return program;
}

} // namespace proxima
