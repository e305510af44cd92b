// SPDX-License-Identifier: Apache-2.0
// A text as the evaluator runs it: a program of tokens. Directives are tokens too and know where to jump, because
// POV-Ray allows them between any two tokens: the structure of a scene exists only after they ran.
#pragma once
#include "kernels/geometry.h"
#include "parser/symbols.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace proxima {

enum class TokenKind : uint8_t {
    number,
    string,
    name, ///< an identifier that is not reserved
    word, ///< a reserved word
    left_brace,
    right_brace,
    left_paren,
    right_paren,
    left_bracket,
    right_bracket,
    left_angle,
    right_angle,
    less_equal,
    greater_equal,
    equal,
    not_equal,
    plus,
    minus,
    star,
    slash,
    bang,
    ampersand,
    bar,
    question,
    colon,
    comma,
    semicolon,
    dot,
    sphere_run, ///< literal spheres, see SphereRun
    directive,  ///< this and the next kind are not seen by the grammar of the scene
    end_of_text,
};

/// What the evaluator has to do before it may look at a token.
enum class Directive : uint8_t {
    none,
    // clang-format off
    if_, ifdef, ifndef, elseif, else_, switch_, case_, range, break_, while_, for_, end, macro,
    declare, local, undef, include, version, default_, debug, warning, error, fopen, fclose, read, write,
    // clang-format on
    call,        ///< a name before a parenthesis: perhaps a macro's
    end_of_text, ///< go back to where the text was included
};

/// 16 bytes. What the payload means depends on the kind.
struct Token {
    static constexpr uint32_t no_target = 0xffffffffu;
    static constexpr uint32_t subscripted = 1; ///< target of a name before a bracket

    uint32_t offset = 0; ///< bytes from the start of the text
    uint16_t length = 1; ///< bytes, at most 65,535
    TokenKind kind = TokenKind::end_of_text;
    Directive directive = Directive::none;
    /// name, word: the symbol. string, sphere_run: index into TokenProgram. A directive that opens a block:
    /// the token of its #end; one inside of a block, #end included: the token that opened the block.
    uint32_t index = 0;
    /// An opening bracket: the token of the closing one, or no_target. A directive with a condition: the
    /// token of the branch to go on with when it is false.
    uint32_t target = 0;

    /// A number keeps its value where the others have index and target.
    double number() const { return std::bit_cast<double>(std::array{index, target}); }
    void set_number(double value) {
        const auto halves = std::bit_cast<std::array<uint32_t, 2>>(value);
        index = halves[0];
        target = halves[1];
    }
};
static_assert(sizeof(Token) == 16);

/// Literal spheres that follow each other, at most `capacity`: 36 bytes each, in the arrays' order of SceneProgram.
struct SphereRun {
    static constexpr size_t capacity = 65'536;
    static constexpr uint32_t no_surface = 0xffffffffu;
    static constexpr uint32_t color_flag = 0x80000000u;

    std::vector<Sphere<double>> spheres;
    /// The symbol in `texture { Name }`; or color_flag and an index into TokenProgram::colors; or no_surface.
    std::vector<uint32_t> surfaces;
};

struct TokenProgram {
    uint32_t file = 0;
    std::vector<Token> tokens; ///< the last is end_of_text
    std::vector<std::string> strings;
    std::vector<SphereRun> runs;
    std::vector<glm::vec3> colors; ///< of `pigment { rgb <r, g, b> }` in runs
    size_t literal_spheres = 0;
    bool valid = false; ///< has no mistakes and may be run
};

} // namespace proxima
