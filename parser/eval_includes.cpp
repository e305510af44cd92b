// SPDX-License-Identifier: Apache-2.0
// Directives: other files, the version, and messages.
#include "parser/evaluator.h"
#include "parser/standard_includes.h"

#include <fmt/format.h>

namespace proxima {

void Evaluator::run_include(const Token& directive) {
    ++cursor_;
    const Token& name_token = peek();
    const std::string name = string();
    if (includes_ >= include_depth_limit)
        fail(directive, fmt::format("files include each other more than {} deep", include_depth_limit));
    try {
        const std::optional<uint32_t> file = sources_.files.open_include(name);
        if (!file)
            return include_standard(name, name_token);
        enter_text(*file);
    } catch (const FileError& error) {
        fail(name_token, error.what());
    }
}

/// Goes on at the beginning of a text; its end leads back.
void Evaluator::enter_text(uint32_t file) {
    TokenProgram* const program = sources_.program(file, diagnostics_);
    if (!program)
        return;
    frames_.push_back({program_, cursor_, loops_.size(), nullptr});
    ++includes_;
    scopes_.enter();
    program_ = program;
    cursor_ = program->tokens.data();
}

/// Declares what a standard file of POV-Ray's would. The scene's own file of that name goes first.
void Evaluator::include_standard(const std::string& name, const Token& at) {
    const StandardFile* const standard = find_standard_file(name);
    if (!standard)
        fail(at, fmt::format("there is no file {}", name), "it is searched beside the scene and in the include paths");
    if (!standard->guard.empty()) {
        if (scopes_.find(sources_.symbols.intern(standard->guard)))
            return;
        predeclare(standard->guard, Terms(version_));
    }
    for (const RefusedNames& refused : standard->refused)
        for_each_name(refused, [&](std::string_view refused_name) { predeclare(refused_name, Refused{refused.word}); });
    enter_text(sources_.standard_file(*standard));
}

/// Goes back to the caller of the text or macro.
void Evaluator::leave_frame() {
    const Frame frame = frames_.back();
    includes_ -= frame.macro ? 0 : 1;
    frames_.pop_back();
    scopes_.leave();
    loops_.resize(frame.loops);
    program_ = frame.program;
    cursor_ = frame.return_to;
}

void Evaluator::run_version() {
    ++cursor_;
    const Token& at = peek();
    const double version = number();
    accept(TokenKind::semicolon);
    if (version > 3.7 + epsilon)
        fail(at, fmt::format("this is a scene for POV-Ray {}; 3.7 is the newest that Proxima knows", version));
    if (version < 3.5 - epsilon)
        fail(at, fmt::format("this is a scene for POV-Ray {}; 3.5 is the oldest that Proxima knows", version));
    version_ = version;
    has_version_ = true;
}

void Evaluator::run_message(const Token& directive) {
    ++cursor_;
    std::string message = string();
    if (directive.directive == Directive::error)
        fail(directive, std::move(message));
    if (directive.directive == Directive::warning)
        warn(directive, std::move(message));
    else if (settings_.debug)
        settings_.debug(message);
}

} // namespace proxima
