// SPDX-License-Identifier: Apache-2.0
// Arrays: how they are made, and which element a name with subscripts stands for.
#include "parser/array.h"
#include "parser/evaluator.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

constexpr uint32_t depth_limit = 100; // of arrays in arrays: they are copied and freed by recursion

uint32_t depth_of(const Value& value) {
    const ArrayRef* array = std::get_if<ArrayRef>(&value);
    return array ? (*array)->depth : 0;
}

bool may_move(const Value& value) {
    const Terms* terms = std::get_if<Terms>(&value);
    return terms ? terms->nodes != 0
                 : !std::holds_alternative<std::monostate>(value) && !std::holds_alternative<std::string>(value);
}

std::string describe(const Value& value) {
    const Terms* terms = std::get_if<Terms>(&value);
    return terms && terms->count > 1 && terms->count < 5 ? fmt::format("a vector of {} terms", terms->count)
                                                         : value_description(value);
}

} // namespace

/// `array[size]... { initializer }` after its word.
Value Evaluator::array() {
    auto result = std::make_shared<Array>();
    double count = 1;
    do {
        if (!accept(TokenKind::left_bracket))
            fail_unexpected("'[' and the size of the array");
        const Token& at = peek();
        const double size = std::trunc(number());
        if (!(size >= 1))
            fail(at, fmt::format("an array has at least 1 element, not {}", size));
        count *= size;
        if (count > Array::element_limit)
            fail(at, fmt::format("an array has at most {} elements", Array::element_limit));
        if (result->sizes.size() == Array::dimension_limit)
            fail(at, fmt::format("an array has at most {} dimensions", Array::dimension_limit));
        result->sizes.push_back(uint32_t(size));
        expect(TokenKind::right_bracket);
    } while (after_value(TokenKind::left_bracket));
    charge(uint64_t(count) * sizeof(Value));
    if (after_value(TokenKind::left_brace)) {
        result->elements.reserve(size_t(count));
        initialize(*result, 0);
    } else {
        result->elements.resize(size_t(count));
    }
    return result;
}

/// The values in braces for one dimension, and in them the braces of the next. POV-Ray takes no directive or macro
/// where a value begins.
void Evaluator::initialize(Array& array, size_t dimension) {
    const Nesting nesting(*this);
    if (!after_value(TokenKind::left_brace))
        fail_unexpected("'{': an initializer has braces for every dimension");
    advance();
    const uint32_t size = array.sizes[dimension];
    for (uint32_t i = 0; i < size; ++i) {
        const Token& at = *cursor_;
        if (at.kind == TokenKind::right_brace)
            fail(at, fmt::format("this initializer has {} values and needs {}", i, size));
        if (dimension + 1 < array.sizes.size()) {
            initialize(array, dimension + 1);
        } else {
            if (&peek() != &at)
                fail(at, "a value in an initializer must not begin with a directive or a macro", "use #declare");
            add_element(at, array, array.elements.emplace_back(), right_hand_side());
        }
        if (after_value(TokenKind::comma))
            advance();
    }
    if (!after_value(TokenKind::right_brace))
        fail(*cursor_, fmt::format("unexpected '{}'", spelling(*cursor_)),
             fmt::format("expected '}}': this initializer needs {} values", size));
    advance();
}

/// Puts `value` into an element of `array`. All elements are of one kind.
void Evaluator::add_element(const Token& at, Array& array, Value& element, Value value) {
    const ValueKind kind = kind_of(value);
    if (kind.type != 0 && array.kind.type != 0 && kind != array.kind) {
        const auto other =
            std::ranges::find_if(array.elements, [&](const Value& e) { return kind_of(e) == array.kind; });
        fail(at, fmt::format("this element is {}", describe(value)),
             other == array.elements.end() ? "expected a value of the kind that the array had before"
                                           : fmt::format("expected {}, as the array has", describe(*other)));
    }
    if (kind.type != 0)
        array.kind = kind;
    array.depth = std::max(array.depth, depth_of(value) + 1);
    array.may_move = array.may_move || may_move(value);
    if (array.depth > depth_limit)
        fail(at, fmt::format("arrays stand in each other more than {} deep", depth_limit));
    element = std::move(value);
}

/// The element that a name stands for, or `whole` when it stands for the whole array.
const Value& Evaluator::element_value(const Token& name, const Value& whole) {
    if (element_.name != &name) {
        if (!stands_for_element(name))
            return whole;
        find_element(name, whole);
    }
    if (std::holds_alternative<std::monostate>(*element_.value))
        fail(name, "this element of the array has no value yet");
    return *element_.value;
}

bool Evaluator::stands_for_element(const Token& name) const {
    return name.target == Token::subscripted || scopes_.element_of(name.index);
}

/// Sets element_ to the element of `whole` that the name under the cursor stands for, whether it has a value or not.
void Evaluator::find_element(const Token& name, const Value& whole) {
    Element found{.name = &name, .after = nullptr, .path = {}, .array = std::get<ArrayRef>(whole), .value = &whole};
    const auto enter = [&](uint32_t index) {
        found.value = &found.array->elements[index];
        found.path.push_back(index);
    };
    if (const std::vector<uint32_t>* path = scopes_.element_of(name.index)) {
        for (const uint32_t index : *path) {
            const ArrayRef* inner = std::get_if<ArrayRef>(found.value);
            if (!inner || index >= (*inner)->elements.size())
                fail(name, "the element that this parameter stood for is gone");
            found.array = *inner;
            enter(index);
        }
    }
    ++cursor_;
    while (cursor_->kind == TokenKind::left_bracket && std::holds_alternative<ArrayRef>(*found.value)) {
        found.array = ArrayRef(std::get<ArrayRef>(*found.value)); // a copy first: the value may stand in the old array
        enter(subscript(*found.array));
    }
    found.after = cursor_;
    cursor_ = &name;
    element_ = std::move(found);
}

/// Steps from the name under the cursor behind its subscripts.
void Evaluator::leave_element() {
    cursor_ = element_.after;
    element_.name = nullptr;
    element_.array.reset();
}

/// `[number]` for each dimension: where the element stands in the array.
uint32_t Evaluator::subscript(const Array& array) {
    const Nesting nesting(*this);
    uint32_t index = 0;
    for (const uint32_t size : array.sizes) {
        if (cursor_->kind != TokenKind::left_bracket)
            fail(*cursor_, fmt::format("unexpected '{}'", spelling(*cursor_)),
                 fmt::format("expected '[': the array has {} dimensions", array.sizes.size()));
        advance();
        const Token& at = peek();
        const double value = number();
        if (value < 0)
            fail(at, fmt::format("the subscript {} is negative", value), "subscripts count from 0");
        if (value >= size)
            fail(at, fmt::format("the subscript {} is out of range", value),
                 fmt::format("subscripts count from 0; the last one here is {}", size - 1));
        index = index * size + uint32_t(value);
        expect(TokenKind::right_bracket);
    }
    return index;
}

/// Stores a value where a name with an element's path leads to in `whole`.
void Evaluator::store_element(const Token& name, Value& whole, const std::vector<uint32_t>& path, Value value) {
    Value* element = &whole;
    Array* array = nullptr;
    uint32_t depth = depth_of(value) + uint32_t(path.size());
    for (const uint32_t index : path) {
        const ArrayRef* inner = std::get_if<ArrayRef>(element);
        if (!inner || index >= (*inner)->elements.size())
            fail(name, "the array changed while the value of its element was found");
        if (inner->use_count() > 1)
            charge((*inner)->elements.size() * sizeof(Value));
        array = &own_array(*element);
        array->depth = std::max(array->depth, depth--);
        element = &array->elements[index];
    }
    check_redeclaration(name, *element, value);
    changes_ += value_changes(*element, value);
    add_element(name, *array, *element, std::move(value));
}

/// `dimensions(Array)`, `dimension_size(Array, number)` behind the parenthesis.
double Evaluator::array_function(const Token& word) {
    const ArrayRef* found = identifier<ArrayRef>();
    if (!found)
        fail_unexpected("the name of an array");
    const std::vector<uint32_t> sizes = (*found)->sizes;
    advance();
    if (Word(word.index) == Word::dimensions)
        return double(sizes.size());
    separator();
    const double dimension = number();
    return dimension >= 1 && dimension < double(sizes.size() + 1) ? sizes[size_t(dimension) - 1] : 0;
}

/// Whether the name under the cursor has a value; steps over it.
bool Evaluator::name_is_defined() {
    const Token& name = *cursor_;
    const Binding* binding = lookup(name);
    bool defined = binding != nullptr;
    if (defined && std::holds_alternative<ArrayRef>(binding->value) && stands_for_element(name)) {
        find_element(name, binding->value);
        defined = !std::holds_alternative<std::monostate>(*element_.value);
    }
    advance();
    return defined;
}

} // namespace proxima
