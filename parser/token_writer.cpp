// SPDX-License-Identifier: Apache-2.0
#include "parser/token_writer.h"

#include "parser/string_escapes.h"
#include "parser/words.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace proxima {
namespace {

constexpr std::pair<std::string_view, Directive> directive_names[] = {
    {"if", Directive::if_},           {"ifdef", Directive::ifdef},     {"ifndef", Directive::ifndef},
    {"elseif", Directive::elseif},    {"else", Directive::else_},      {"switch", Directive::switch_},
    {"case", Directive::case_},       {"range", Directive::range},     {"break", Directive::break_},
    {"while", Directive::while_},     {"for", Directive::for_},        {"end", Directive::end},
    {"macro", Directive::macro},      {"declare", Directive::declare}, {"local", Directive::local},
    {"undef", Directive::undef},      {"include", Directive::include}, {"version", Directive::version},
    {"default", Directive::default_}, {"debug", Directive::debug},     {"warning", Directive::warning},
    {"error", Directive::error},      {"render", Directive::debug},    {"statistics", Directive::debug},
    {"fopen", Directive::fopen},      {"fclose", Directive::fclose},   {"read", Directive::read},
    {"write", Directive::write},
};

bool opens_block(Directive directive) {
    switch (directive) {
    case Directive::if_:
    case Directive::ifdef:
    case Directive::ifndef:
    case Directive::switch_:
    case Directive::while_:
    case Directive::for_:
    case Directive::macro:
        return true;
    default:
        return false;
    }
}

bool is_if(Directive directive) {
    return directive == Directive::if_ || directive == Directive::ifdef || directive == Directive::ifndef;
}

} // namespace

TokenWriter::TokenWriter(TokenProgram& program, std::string_view text, SymbolTable& symbols, Diagnostics& diagnostics)
    : program_(program), text_(text), symbols_(symbols), diagnostics_(diagnostics) {}

Token& TokenWriter::append(TokenKind kind, std::string_view piece) {
    Token& token = program_.tokens.emplace_back();
    token.offset = uint32_t(piece.data() - text_.data());
    token.length = uint16_t(std::clamp<size_t>(piece.size(), 1, std::numeric_limits<uint16_t>::max()));
    token.kind = kind;
    return token;
}

SourceSpan TokenWriter::place(const Token& token) const {
    return {{program_.file, token.offset}, token.length};
}

void TokenWriter::fail(const Token& token, std::string message, std::string hint) const {
    throw SceneError(place(token), std::move(message), std::move(hint));
}

void TokenWriter::add(TokenKind kind, std::string_view piece) {
    Token& token = append(kind, piece);
    const uint32_t index = uint32_t(program_.tokens.size() - 1);
    switch (kind) {
    case TokenKind::left_brace:
    case TokenKind::left_paren:
    case TokenKind::left_bracket:
        token.index = token.target = Token::no_target;
        if (brackets_.size() >= depth_limit)
            fail(token, fmt::format("brackets stand in each other more than {} deep", depth_limit));
        brackets_.push_back(index);
        if (kind == TokenKind::left_paren && index > 0 && program_.tokens[index - 1].kind == TokenKind::name)
            program_.tokens[index - 1].directive = Directive::call;
        if (kind == TokenKind::left_bracket && index > 0 && program_.tokens[index - 1].kind == TokenKind::name)
            program_.tokens[index - 1].target = Token::subscripted;
        break;
    case TokenKind::right_brace:
    case TokenKind::right_paren:
    case TokenKind::right_bracket:
        // A macro may open a bracket that its caller closes: what does not fit is left to the evaluator.
        if (!brackets_.empty() && int(program_.tokens[brackets_.back()].kind) + 1 == int(kind)) {
            program_.tokens[brackets_.back()].target = index;
            brackets_.pop_back();
        }
        break;
    default:
        break;
    }
}

void TokenWriter::add_number(std::string_view piece) {
    Token& token = append(TokenKind::number, piece);
    double number = 0;
    const auto [end, error] = std::from_chars(piece.data(), piece.data() + piece.size(), number);
    token.set_number(number);
    if (error != std::errc() || end != piece.data() + piece.size())
        diagnostics_.error(place(token), "this number is too large or too small for a double");
}

void TokenWriter::add_string(std::string_view piece) {
    Token& token = append(TokenKind::string, piece);
    token.index = uint32_t(program_.strings.size());
    std::string& value = program_.strings.emplace_back();
    const size_t bad = unescape(piece.substr(1, piece.size() - 2), value);
    if (bad != std::string_view::npos)
        diagnostics_.error({{program_.file, token.offset + 1 + uint32_t(bad)}, 2},
                           "unknown escape sequence in a string", "expected \\n, \\t, \\\", \\' or \\\\");
}

void TokenWriter::add_identifier(std::string_view piece) {
    const Symbol symbol = symbols_.intern(piece);
    append(symbols_.is_reserved(symbol) ? TokenKind::word : TokenKind::name, piece).index = symbol;
}

void TokenWriter::unexpected(std::string_view piece) {
    Token token;
    token.offset = uint32_t(piece.data() - text_.data());
    const unsigned char c = static_cast<unsigned char>(piece.front());
    diagnostics_.error(place(token), c >= ' ' && c < 127 ? fmt::format("unexpected character '{}'", char(c))
                                                         : fmt::format("unexpected byte 0x{:02x}", unsigned(c)));
}

void TokenWriter::add_directive(std::string_view piece, std::string_view name) {
    Token& token = append(TokenKind::directive, piece);
    token.index = token.target = Token::no_target;
    const auto found = std::find_if(std::begin(directive_names), std::end(directive_names),
                                    [&](const auto& entry) { return entry.first == name; });
    if (found == std::end(directive_names)) {
        std::vector<std::string_view> known;
        for (const auto& entry : directive_names)
            known.push_back(entry.first);
        const std::string near = nearest_name(name, known);
        fail(token, fmt::format("there is no directive #{}", name),
             near.empty() ? "" : fmt::format("did you mean #{}?", near));
    }
    token.directive = found->second;
    const uint32_t index = uint32_t(program_.tokens.size() - 1);
    switch (token.directive) {
    case Directive::elseif:
    case Directive::else_:
    case Directive::case_:
    case Directive::range:
        branch(index);
        break;
    case Directive::break_:
        break_block(index);
        break;
    case Directive::end:
        close_block(index);
        break;
    default:
        if (opens_block(token.directive)) {
            if (blocks_.size() >= depth_limit)
                fail(token, fmt::format("directives stand in each other more than {} deep", depth_limit));
            blocks_.push_back({index, index});
        }
    }
}

void TokenWriter::branch(uint32_t index) {
    Token& token = program_.tokens[index];
    const bool of_switch = token.directive == Directive::case_ || token.directive == Directive::range;
    const Directive opener = blocks_.empty() ? Directive::none : program_.tokens[blocks_.back().opener].directive;
    const bool fits =
        (of_switch ? false : is_if(opener)) || (opener == Directive::switch_ && token.directive != Directive::elseif);
    if (!fits)
        fail(token, of_switch ? "this directive stands in no #switch" : "this directive belongs to no #if");
    check_condition(token);
    Token& last = program_.tokens[blocks_.back().last];
    if (last.directive == Directive::else_)
        fail(token, "nothing but #end may follow the #else of a block");
    last.target = index;
    token.index = blocks_.back().opener;
    blocks_.back().last = index;
}

/// A directive that ends a branch may not stand in the parentheses of the branch's own condition.
void TokenWriter::check_condition(const Token& token) const {
    if (!brackets_.empty() && brackets_.back() == blocks_.back().last + 1)
        fail(token, "the condition before this directive is not closed", "expected ')'");
}

void TokenWriter::break_block(uint32_t index) {
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block) {
        const Directive opener = program_.tokens[block->opener].directive;
        if (opener == Directive::macro)
            break;
        if (!is_if(opener)) {
            program_.tokens[index].index = block->opener;
            return;
        }
    }
    fail(program_.tokens[index], "#break stands in no #while, #for or #switch");
}

void TokenWriter::close_block(uint32_t index) {
    Token& token = program_.tokens[index];
    if (blocks_.empty())
        fail(token, "this #end closes nothing");
    check_condition(token);
    const Block block = blocks_.back();
    blocks_.pop_back();
    token.index = block.opener;
    program_.tokens[block.last].target = index;
    program_.tokens[block.opener].index = index;
}

bool TokenWriter::literal_texture(std::string_view name) {
    literal_surface_ = symbols_.intern(name);
    return !symbols_.is_reserved(literal_surface_);
}

bool TokenWriter::commit_sphere(std::string_view piece) {
    constexpr double limit = std::numeric_limits<float>::max();
    for (int i = 0; i < literal_count_; ++i)
        if (!(std::abs(literal_[i]) < limit))
            return false;
    if (!(literal_[3] > 0))
        return false;
    if (literal_count_ == 7) {
        const glm::vec3 color(literal_[4], literal_[5], literal_[6]);
        if (program_.colors.empty() || program_.colors.back() != color)
            program_.colors.push_back(color);
        literal_surface_ = SphereRun::color_flag | uint32_t(program_.colors.size() - 1);
    }
    if (program_.tokens.empty() || program_.tokens.back().kind != TokenKind::sphere_run ||
        program_.runs.back().spheres.size() >= SphereRun::capacity) {
        append(TokenKind::sphere_run, piece.substr(0, 6)).index = uint32_t(program_.runs.size());
        program_.runs.emplace_back();
    }
    SphereRun& run = program_.runs.back();
    run.spheres.push_back({{literal_[0], literal_[1], literal_[2]}, literal_[3]});
    run.surfaces.push_back(literal_surface_);
    ++program_.literal_spheres;
    return true;
}

void TokenWriter::finish() {
    for (const Block& block : blocks_) {
        const Token& opener = program_.tokens[block.opener];
        diagnostics_.error(place(opener), "this directive has no #end");
    }
    append(TokenKind::end_of_text, text_.substr(text_.size())).directive = Directive::end_of_text;
}

} // namespace proxima
