// SPDX-License-Identifier: Apache-2.0
#include "parser/function_reader.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <optional>

namespace proxima {
namespace {

constexpr Symbol default_parameters[] = {Symbol(Word::x), Symbol(Word::y), Symbol(Word::z)};

/// How many arguments a function of numbers takes here; none: it may not stand in a function.
struct Arity {
    size_t least = 0;
    size_t most = 0;
};

Arity arity(Word word) {
    if (word < Word::abs || word > Word::tanh)
        return {};
    switch (word) {
    case Word::rand:
    case Word::seed:
        return {};
    case Word::atan2:
    case Word::div:
    case Word::mod:
    case Word::pow:
        return {2, 2};
    case Word::max:
    case Word::min:
        return {2, SIZE_MAX};
    case Word::select:
        return {3, 4};
    default:
        return {1, 1};
    }
}

using ThreeNumbers = std::array<double, 3>;

/// What select gives where the left side is below, equal to, and above the right one.
std::optional<ThreeNumbers> relation_values(TokenKind kind) {
    switch (kind) {
    case TokenKind::left_angle:
        return ThreeNumbers{1, 0, 0};
    case TokenKind::less_equal:
        return ThreeNumbers{1, 1, 0};
    case TokenKind::equal:
        return ThreeNumbers{0, 1, 0};
    case TokenKind::not_equal:
        return ThreeNumbers{1, 0, 1};
    case TokenKind::greater_equal:
        return ThreeNumbers{0, 1, 1};
    case TokenKind::right_angle:
        return ThreeNumbers{0, 0, 1};
    default:
        return std::nullopt;
    }
}

} // namespace

Evaluator::FunctionReader::FunctionReader(Evaluator& evaluator)
    : evaluator_(evaluator), home_(evaluator.program_), last_(*evaluator.cursor_) {
    function_.body.file = home_->file;
}

UserFunction Evaluator::FunctionReader::read() {
    if (evaluator_.peek().kind == TokenKind::left_paren)
        parameters();
    else
        function_.parameters.assign(std::begin(default_parameters), std::end(default_parameters));
    evaluator_.expect(TokenKind::left_brace);
    disjunction();
    check_next(TokenKind::right_brace, "'}'");
    evaluator_.advance();
    append(TokenKind::right_brace);
    return std::move(function_);
}

void Evaluator::FunctionReader::parameters() {
    evaluator_.advance();
    do {
        const Token& at = evaluator_.peek();
        const Symbol symbol = parameter();
        if (is_parameter(symbol))
            evaluator_.fail(at, fmt::format("there are two parameters '{}'", evaluator_.spelling(at)));
        function_.parameters.push_back(symbol);
        evaluator_.advance();
    } while (evaluator_.accept(TokenKind::comma));
    evaluator_.expect(TokenKind::right_paren);
    // POV-Ray takes u for the first parameter and v for the second where x and y are declared too.
    const auto has = [&](Word word) { return is_parameter(Symbol(word)); };
    if ((has(Word::u) || has(Word::v)) && (has(Word::x) || has(Word::y) || has(Word::z)))
        evaluator_.fail(evaluator_.peek(), "u and v cannot be parameters beside x, y and z");
}

/// The parameter under the cursor: a name without a value, or x, y, z, u or v.
Symbol Evaluator::FunctionReader::parameter() {
    const Token& token = evaluator_.peek();
    if (token.kind == TokenKind::word && token.index >= uint32_t(Word::x) && token.index <= uint32_t(Word::v) &&
        token.index != uint32_t(Word::t))
        return token.index;
    if (token.kind != TokenKind::name)
        evaluator_.fail_unexpected("the name of a parameter");
    if (const Binding* known = evaluator_.scopes_.find(token.index))
        evaluator_.fail(token,
                        fmt::format("'{}' is {} already", evaluator_.spelling(token), value_description(known->value)),
                        "a parameter needs a name that is not declared");
    return token.index;
}

bool Evaluator::FunctionReader::is_parameter(Symbol symbol) const {
    return std::ranges::find(function_.parameters, symbol) != function_.parameters.end();
}

void Evaluator::FunctionReader::disjunction() {
    const Nesting nesting(evaluator_);
    const size_t start = here();
    conjunction();
    if (evaluator_.peek().kind != TokenKind::bar)
        return;
    make_truth(start);
    open_call(Word::max, start);
    while (evaluator_.accept(TokenKind::bar)) {
        append(TokenKind::comma);
        const size_t next = here();
        conjunction();
        make_truth(next);
    }
    append(TokenKind::right_paren);
}

void Evaluator::FunctionReader::conjunction() {
    const size_t start = here();
    relation();
    if (evaluator_.peek().kind != TokenKind::ampersand)
        return;
    make_truth(start);
    open_call(Word::min, start);
    while (evaluator_.accept(TokenKind::ampersand)) {
        append(TokenKind::comma);
        const size_t next = here();
        relation();
        make_truth(next);
    }
    append(TokenKind::right_paren);
}

/// `a < b` becomes `select(a - (b), 1, 0, 0)`: the difference is 0 just where both are equal.
void Evaluator::FunctionReader::relation() {
    const size_t start = here();
    sum();
    if (const std::optional<ThreeNumbers> values = relation_values(evaluator_.peek().kind)) {
        evaluator_.advance();
        open_call(Word::select, start);
        append(TokenKind::minus);
        append(TokenKind::left_paren);
        sum();
        append(TokenKind::right_paren);
        append_numbers(*values);
    }
    if (relation_values(evaluator_.peek().kind)) // POV-Ray's order depends on which sides are constant
        evaluator_.fail(evaluator_.peek(), "two relations stand in a row", "write parentheses around one of them");
}

void Evaluator::FunctionReader::make_truth(size_t start) {
    open_call(Word::select, start);
    append_numbers(ThreeNumbers{1, 0, 1});
}

void Evaluator::FunctionReader::sum() {
    product();
    while (evaluator_.peek().kind == TokenKind::plus || evaluator_.peek().kind == TokenKind::minus) {
        take();
        product();
    }
}

void Evaluator::FunctionReader::product() {
    operand();
    while (evaluator_.peek().kind == TokenKind::star || evaluator_.peek().kind == TokenKind::slash) {
        take();
        operand();
    }
}

/// An operand has one sign at most.
void Evaluator::FunctionReader::operand() {
    if (const TokenKind kind = evaluator_.peek().kind; kind == TokenKind::plus || kind == TokenKind::minus)
        take();
    const Token& token = evaluator_.peek();
    switch (token.kind) {
    case TokenKind::number:
        return take();
    case TokenKind::name:
        return name();
    case TokenKind::word:
        return word();
    case TokenKind::left_paren:
        take();
        disjunction();
        check_next(TokenKind::right_paren, "')'");
        return take();
    case TokenKind::left_angle:
        evaluator_.fail(token, "a function has no vectors", "make a function for each term");
    default:
        evaluator_.fail_unexpected("a number");
    }
}

void Evaluator::FunctionReader::name() {
    const Token& token = *evaluator_.cursor_;
    if (is_parameter(token.index))
        return take();
    const Value* const value = evaluator_.named_value(token);
    if (const FunctionRef* function = value ? std::get_if<FunctionRef>(value) : nullptr) {
        const size_t count = (*function)->parameters.size();
        capture(token, *value);
        return call(count, count);
    }
    const Terms* const terms = value ? std::get_if<Terms>(value) : nullptr;
    if (!terms)
        evaluator_.fail_unexpected("a parameter, a number or a function");
    if (terms->count != 1)
        evaluator_.fail(token,
                        fmt::format("'{}' is {}: a function has numbers alone", evaluator_.spelling(token),
                                    value_description(*value)),
                        "declare the term that is needed as a number before the function");
    capture(token, *value);
}

void Evaluator::FunctionReader::word() {
    const Token& token = *evaluator_.cursor_;
    if (is_parameter(token.index)) {
        take();
        function_.body.tokens.back().kind = TokenKind::name;
        return;
    }
    if (token.index == uint32_t(Word::pi) || token.index == uint32_t(Word::clock))
        return take();
    if (const Arity count = arity(Word(token.index)); count.least > 0) {
        take();
        return call(count.least, count.most);
    }
    if (token.index >= uint32_t(Word::x) && token.index <= uint32_t(Word::val))
        evaluator_.fail(token, fmt::format("'{}' cannot stand in a function", evaluator_.spelling(token)),
                        token.index <= uint32_t(Word::v) ? "it is no parameter of this one"
                                                         : "declare its value as a number before the function");
    evaluator_.fail_unexpected("a number");
}

/// The arguments of the function whose name was appended.
void Evaluator::FunctionReader::call(size_t least, size_t most) {
    const Token at = function_.body.tokens.back();
    check_next(TokenKind::left_paren, "'('");
    take();
    size_t count = 0;
    for (bool more = true; more; ++count) {
        disjunction();
        more = evaluator_.peek().kind == TokenKind::comma;
        if (more)
            take();
    }
    if (count < least || count > most)
        throw SceneError({{home_->file, at.offset}, at.length},
                         fmt::format("this function takes {}{} arguments, here are {}",
                                     least == most   ? ""
                                     : count < least ? "at least "
                                                     : "at most ",
                                     count < least ? least : most, count));
    check_next(TokenKind::right_paren, "')'");
    take();
}

/// A parameter has no value yet: as an unexpected name it must not be called undeclared.
void Evaluator::FunctionReader::check_next(TokenKind kind, const char* expected) {
    const Token& token = evaluator_.peek();
    if (token.kind == kind)
        return;
    if (token.kind == TokenKind::name && is_parameter(token.index))
        evaluator_.fail(token, fmt::format("unexpected '{}'", evaluator_.spelling(token)),
                        fmt::format("expected {}", expected));
    evaluator_.fail_unexpected(expected);
}

/// Appends a name that keeps the value which the name under the cursor has now.
void Evaluator::FunctionReader::capture(const Token& name, const Value& value) {
    std::vector<UserFunction::Capture>& captures = function_.captures;
    Symbol symbol = name.index;
    if (evaluator_.element_.name == &name) // no name is spelled like this one
        symbol = evaluator_.sources_.symbols.intern(fmt::format("element {}", captures.size()));
    if (std::ranges::find(captures, symbol, &UserFunction::Capture::symbol) == captures.end())
        captures.push_back({symbol, value});
    take();
    Token& taken = function_.body.tokens.back();
    taken.index = symbol;
    taken.target = 0;
}

void Evaluator::FunctionReader::take() {
    Token token = evaluator_.peek();
    if (evaluator_.program_ == home_)
        last_ = token;
    token.offset = last_.offset;
    token.length = last_.length;
    append(token);
    evaluator_.advance();
}

Token& Evaluator::FunctionReader::append(Token token) {
    if (here() >= UserFunction::token_limit)
        evaluator_.fail(*evaluator_.cursor_, "the expression of this function is too long",
                        "make several functions of it that call each other");
    return function_.body.tokens.emplace_back(token);
}

Token Evaluator::FunctionReader::made(TokenKind kind) const {
    Token token;
    token.offset = last_.offset;
    token.length = last_.length;
    token.kind = kind;
    return token;
}

Token Evaluator::FunctionReader::made(Word word) const {
    Token token = made(TokenKind::word);
    token.index = uint32_t(word);
    return token;
}

/// Ends a call with these arguments after its first one.
void Evaluator::FunctionReader::append_numbers(std::span<const double> numbers) {
    for (const double number : numbers) {
        append(TokenKind::comma);
        append(made(TokenKind::number)).set_number(number);
    }
    append(TokenKind::right_paren);
}

/// Makes what was appended from `start` on the first argument of a call.
void Evaluator::FunctionReader::open_call(Word function, size_t start) {
    std::vector<Token>& tokens = function_.body.tokens;
    tokens.insert(tokens.begin() + ptrdiff_t(start), {made(function), made(TokenKind::left_paren)});
}

} // namespace proxima
