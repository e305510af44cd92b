// SPDX-License-Identifier: Apache-2.0
// #fopen, #read and #fclose: values from a data file. Scenes write no files.
#include "parser/data_file.h"
#include "parser/evaluator.h"

#include <fmt/format.h>

namespace proxima {

/// `#fopen Handle "name" read`
void Evaluator::run_fopen() {
    ++cursor_;
    const Token& name = *cursor_;
    const Symbol symbol = declared_name();
    if (const Binding* known = scopes_.find(symbol))
        fail(name, fmt::format("'{}' is {} already", spelling(name), value_description(known->value)),
             "expected a new name for the open file");
    failed_names_.insert(symbol); // until it is open
    const Token& at = peek();
    const std::string file_name = string();
    if (peek_is(Word::write) || peek_is(Word::append))
        fail(peek(), "a scene writes no files", "open it with read");
    if (!accept(Word::read))
        fail_unexpected("read");
    try {
        const std::optional<uint32_t> file = sources_.files.open_include(file_name);
        if (!file)
            fail(at, fmt::format("there is no file {}", file_name),
                 "it is searched beside the scene and in the include paths");
        Binding& binding = scopes_.declare(symbol);
        binding.value = std::make_shared<DataFile>(sources_.files.text(*file), *file);
        binding.declared = span(name);
        failed_names_.erase(symbol);
        ++changes_;
    } catch (const FileError& error) {
        fail(at, error.what());
    }
}

/// `#fclose Handle`. As in POV-Ray, closing what is not open does nothing.
void Evaluator::run_fclose() {
    ++cursor_;
    const Symbol symbol = declared_name();
    const Binding* binding = scopes_.find(symbol);
    if (!binding || !std::holds_alternative<DataFileRef>(binding->value))
        return;
    scopes_.undefine(symbol);
    ++changes_;
}

/// `#read (Handle, Name, ...)`: the names take the next values. At the end of the file the handle is closed, and the
/// names that are left keep what they have.
void Evaluator::run_read() {
    const Token& directive = *cursor_;
    try {
        read_values();
    } catch (const SceneError&) {
        for (const Token* token = &directive + 1;
             token->kind == TokenKind::left_paren || token->kind == TokenKind::name || token->kind == TokenKind::comma;
             ++token)
            if (token->kind == TokenKind::name)
                failed_names_.insert(token->index);
        throw;
    }
}

void Evaluator::read_values() {
    ++cursor_;
    expect(TokenKind::left_paren);
    const DataFileRef* found = identifier<DataFileRef>();
    if (!found)
        fail_unexpected("the name of an open file");
    const DataFileRef file = *found;
    const Symbol handle = peek().index;
    advance();
    accept(TokenKind::comma);
    while (!accept(TokenKind::right_paren)) {
        if (peek().kind != TokenKind::name)
            fail_unexpected("a name for the value, or ')'");
        read_into(*file);
        accept(TokenKind::comma);
    }
    if (file->ended())
        scopes_.undefine(handle);
    ++changes_;
}

/// Gives the name under the cursor the file's next value.
void Evaluator::read_into(DataFile& file) {
    const Token& name = *cursor_;
    Value value;
    const bool read = !file.ended() && file.read(value);
    // POV-Ray reads into a new name, or over a number, a vector of 3 terms or a string.
    Binding* const known = lookup(name);
    const Value* old = known ? named_value(name) : nullptr;
    const Terms* terms = old ? std::get_if<Terms>(old) : nullptr;
    if (old && !std::holds_alternative<std::string>(*old) && !(terms && (terms->count == 1 || terms->count == 3)))
        fail(name, fmt::format("unexpected '{}', which is {}", spelling(name), value_description(*old)),
             "expected a new name, or that of a number, a vector of 3 terms or a string");
    std::vector<uint32_t> path;
    if (element_.name == &name)
        path = element_.path;
    advance();
    if (!read)
        return;
    Binding& binding = known ? *known : scopes_.declare(name.index);
    if (!path.empty())
        return store_element(name, binding.value, path, std::move(value));
    binding.value = std::move(value);
    binding.declared = span(name);
    binding.predeclared = false;
}

} // namespace proxima
