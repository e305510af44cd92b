// SPDX-License-Identifier: Apache-2.0
// Builds a TokenProgram from what the grammar finds: gives each identifier its symbol, packs literal spheres into runs,
// and connects brackets and the directives of a block.
#pragma once
#include "parser/diagnostics.h"
#include "parser/token.h"

#include <string_view>

namespace proxima {

class TokenWriter {
public:
    /// Brackets may stand in each other to this depth, and so may blocks of directives.
    static constexpr size_t depth_limit = 200;

    TokenWriter(TokenProgram& program, std::string_view text, SymbolTable& symbols, Diagnostics& diagnostics);

    // `piece` is a part of the text.
    void add(TokenKind kind, std::string_view piece);
    void add_number(std::string_view piece);
    void add_string(std::string_view piece); ///< with its quotes
    void add_identifier(std::string_view piece);
    /// `name` is the word after the #. Throws SceneError when the blocks do not fit together.
    void add_directive(std::string_view piece, std::string_view name);
    void unexpected(std::string_view piece);

    // A literal sphere. Nothing is added before commit_sphere.
    void begin_sphere() {
        literal_count_ = 0;
        literal_surface_ = SphereRun::no_surface;
    }
    void literal_number(double value) { literal_[literal_count_++] = value; }
    /// False when the name is a reserved word: then this is no literal sphere.
    bool literal_texture(std::string_view name);
    /// False when the sphere is one that the evaluator has to complain about.
    bool commit_sphere(std::string_view piece);

    /// Ends the program. Reports the directives that lack an #end.
    void finish();

private:
    struct Block {
        uint32_t opener; ///< token
        uint32_t last;   ///< the token whose target is the next branch
    };

    Token& append(TokenKind kind, std::string_view piece);
    SourceSpan place(const Token& token) const;
    void open_bracket(TokenKind kind, std::string_view piece);
    void close_bracket(TokenKind kind, std::string_view piece);
    void branch(uint32_t token);
    void check_condition(const Token& token) const;
    void break_block(uint32_t token);
    void close_block(uint32_t token);
    [[noreturn]] void fail(const Token& token, std::string message, std::string hint = {}) const;

    TokenProgram& program_;
    std::string_view text_;
    SymbolTable& symbols_;
    Diagnostics& diagnostics_;
    std::vector<uint32_t> brackets_; ///< open ones
    std::vector<Block> blocks_;      ///< open ones

    double literal_[7] = {}; // centre, radius, colour
    int literal_count_ = 0;
    uint32_t literal_surface_ = SphereRun::no_surface;
};

} // namespace proxima
