// SPDX-License-Identifier: Apache-2.0
// Names: the predeclared ones, those of the command line, #declare, #local, #undef and #default.
#include "parser/evaluator.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <utility>

namespace proxima {

void Evaluator::predeclare(std::string_view name, Value value) {
    Binding& binding = scopes_.declare(sources_.symbols.intern(name));
    binding.value = std::move(value);
    binding.predeclared = true;
}

void Evaluator::predeclare() {
    const SceneClock& time = settings_.time;
    const std::pair<std::string_view, Varying> times[] = {
        {"clock_delta", {time.clock_delta, graph_.time(MotionNode::Kind::clock_delta)}},
        {"frame_number", {time.frame_number, graph_.time(MotionNode::Kind::frame_number)}},
    };
    for (const auto& [name, value] : times) {
        predeclare(name, Terms(value));
        time_names_.insert(sources_.symbols.intern(name));
    }
    const std::pair<std::string_view, double> ends[] = {{"initial_frame", time.initial_frame},
                                                        {"final_frame", time.final_frame},
                                                        {"initial_clock", time.initial_clock},
                                                        {"final_clock", time.final_clock}};
    for (const auto& [name, value] : ends)
        predeclare(name, Terms(value));
    predeclare("image_width", Terms(double(settings_.image_width)));
    predeclare("image_height", Terms(double(settings_.image_height)));
    predeclare("input_file_name", std::filesystem::path(sources_.files.name(0)).filename().string());
    for (const auto& [name, text] : settings_.declares)
        declare_from_command_line(name, text);
}

void Evaluator::declare_from_command_line(const std::string& name, const std::string& text) {
    if (sources_.symbols.is_reserved(sources_.symbols.intern(name)))
        return diagnostics_.error({}, fmt::format("--declare {}: '{}' is a reserved word", name, name),
                                  "expected a name; one with a capital letter is never reserved");
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        return predeclare(name, text.substr(1, text.size() - 2));
    double number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    predeclare(name, Terms(number));
}

Binding* Evaluator::lookup(const Token& name) {
    Binding* binding = scopes_.find(name.index);
    if (!binding)
        return nullptr;
    binding->used = true;
    if (binding->predeclared && time_names_.contains(name.index))
        depends_on_time_ = true;
    return binding;
}

Symbol Evaluator::declared_name() {
    // The name is taken as it stands: no directive may come in between.
    const Token& token = *cursor_;
    if (token.kind == TokenKind::word)
        fail(token, fmt::format("'{}' is a reserved word", spelling(token)),
             "expected a name; one with a capital letter is never reserved");
    if (token.kind != TokenKind::name)
        fail(token, fmt::format("unexpected '{}'", spelling(token)), "expected a name");
    ++cursor_;
    return token.index;
}

/// Whether an assignment may change what a condition says.
bool Evaluator::value_changes(const Value& before, const Value& after) {
    const Terms* old_terms = std::get_if<Terms>(&before);
    const Terms* terms = std::get_if<Terms>(&after);
    return !old_terms || !terms || old_terms->count != terms->count ||
           !std::equal(terms->value, terms->value + terms->count, old_terms->value);
}

void Evaluator::run_declare(const Token& directive) {
    ++cursor_;
    const Token& name = *cursor_;
    const Symbol symbol = declared_name();
    const SourceSpan declared = span(name);
    const Binding* known = scopes_.find(symbol);
    if (known && std::holds_alternative<MacroRef>(known->value))
        fail(name, fmt::format("'{}' is a macro already", spelling(name)));
    const std::vector<uint32_t> element = declared_element(name, known, directive);
    try {
        expect(TokenKind::equal);
        const bool is_copy = peek().kind == TokenKind::name;
        Value value = right_hand_side();
        // POV-Ray insists on the semicolon after numbers, and on its standing right there.
        if (std::holds_alternative<Terms>(value) || (is_copy && is_callable(&value))) {
            if (!after_value(TokenKind::semicolon) || directive_before_)
                throw SceneError(declared, fmt::format("this {} lacks its ';'", spelling(directive)),
                                 "a #declare of a number, vector or color ends in ';', with no directive before it");
            advance();
        } else if (after_value(TokenKind::semicolon)) {
            advance();
        }
        // The local names in the macros of standard files are ours: they may hide functions of the scene.
        if (const Binding* before = scopes_.find(symbol);
            before && element.empty() && !sources_.is_standard(program_->file))
            check_redeclaration(name, before->value, value);
        Binding& binding = directive.directive == Directive::local && element.empty() ? scopes_.declare_local(symbol)
                                                                                      : scopes_.declare(symbol);
        if (!element.empty())
            return store_element(name, binding.value, element, std::move(value));
        changes_ += value_changes(binding.value, value);
        binding.value = std::move(value);
        binding.declared = declared;
        binding.predeclared = sources_.is_standard(program_->file);
    } catch (const SceneError&) {
        failed_names_.insert(symbol);
        throw;
    }
}

/// The element of an array that is to be declared: its path, or an empty one where a whole name is declared.
std::vector<uint32_t> Evaluator::declared_element(const Token& name, const Binding* known, const Token& directive) {
    if (!known || !std::holds_alternative<ArrayRef>(known->value)) {
        if (name.target == Token::subscripted)
            fail(name, fmt::format("'{}' is no array", spelling(name)), "declare it first: array[10], for example");
        return {};
    }
    if (!stands_for_element(name))
        return {};
    if (directive.directive == Directive::local && !scopes_.is_local(name.index))
        fail(name, fmt::format("#local cannot change '{}', which is declared elsewhere", spelling(name)),
             "use #declare");
    cursor_ = &name;
    find_element(name, known->value);
    if (directive.directive == Directive::undef && std::holds_alternative<std::monostate>(*element_.value))
        fail(name, "this element of the array has no value yet");
    std::vector<uint32_t> path = std::move(element_.path);
    leave_element();
    return path;
}

void Evaluator::run_undef() {
    const Token& directive = *cursor_;
    ++cursor_;
    const Token& name = *cursor_;
    const Symbol symbol = declared_name();
    Binding* const known = scopes_.find(symbol);
    const std::vector<uint32_t> element = declared_element(name, known, directive);
    if (element.empty())
        scopes_.undefine(symbol);
    else
        store_element(name, known->value, element, {});
    ++changes_;
}

Value Evaluator::right_hand_side() {
    const Token& token = peek();
    if (starts_object())
        return std::make_shared<const Shape>(object());
    if (starts_string())
        return string();
    if (token.kind == TokenKind::name) {
        const Value* named = named_value(token);
        if (named && (std::holds_alternative<MacroRef>(*named) || std::holds_alternative<DataFileRef>(*named)))
            fail_unexpected("a value");
        if (named && !std::holds_alternative<Terms>(*named) && !starts_call(token)) {
            Value value = *named;
            advance();
            return value;
        }
    }
    if (accept(Word::array))
        return array();
    if (accept(Word::function))
        return function_value();
    if (accept(Word::spline))
        return spline();
    if (peek_is(Word::t))
        fail_unexpected("a value; a lone t needs parentheses");
    if (peek_is(Word::texture)) {
        uint32_t result = Surface::none;
        do {
            advance();
            result = layered(result, texture().index);
        } while (after_value(TokenKind::word) && cursor_->index == uint32_t(Word::texture));
        return TextureRef{result};
    }
    if (accept(Word::pigment))
        return pigment(builder_.texture(default_texture_).back().pigment);
    if (accept(Word::finish))
        return finish(builder_.texture(default_texture_).back().finish);
    if (accept(Word::interior))
        return interior(0);
    if (accept(Word::material))
        return material();
    if (accept(Word::camera))
        return std::make_shared<const Camera<Varying>>(camera());
    if (accept(Word::color_map) || accept(Word::colour_map))
        return color_map();
    if (accept(Word::pigment_map))
        return pigment_map();
    if (accept(Word::sky_sphere))
        return std::make_shared<const Moving<SkySphere>>(sky_sphere());
    if (accept(Word::fog))
        return std::make_shared<const Moving<Fog<double>>>(fog());
    if (accept(Word::transform))
        return std::make_shared<const Transform>(transform_block());
    const size_t outer = std::exchange(bare_nesting_, nesting_);
    const Terms terms = token.kind == TokenKind::word && starts_color() ? color() : sum();
    bare_nesting_ = outer;
    return terms;
}

/// Whether this token follows a value. It is looked at as it stands: the directives behind the value may use the name
/// that is being declared.
bool Evaluator::after_value(TokenKind kind) {
    while (leave_macro()) {
    }
    return cursor_->kind == kind;
}

void Evaluator::run_default() {
    ++cursor_;
    expect(TokenKind::left_brace);
    for (;;) {
        if (accept(Word::texture))
            default_texture_ = texture().index;
        else if (accept(Word::pigment))
            default_texture_ = with_pigment(default_texture_);
        else if (accept(Word::finish))
            default_texture_ = with_finish(default_texture_);
        else
            break;
    }
    expect(TokenKind::right_brace);
}

} // namespace proxima
