// SPDX-License-Identifier: Apache-2.0
// An array: its sizes, and its elements in the order of the initializer. Values that share one are copies of each
// other: who writes makes its own first.
#pragma once
#include "parser/value.h"

#include <vector>

namespace proxima {

struct Array {
    static constexpr size_t dimension_limit = 5; ///< POV-Ray's
    static constexpr double element_limit = 100'000'000;

    std::vector<uint32_t> sizes;
    std::vector<Value> elements; ///< the last subscript is the fastest; std::monostate: no value yet
    ValueKind kind;              ///< of every element that has a value
    bool may_move = false;       ///< some element may follow from the time
    uint32_t depth = 1;          ///< at least that of arrays in arrays, this one included
};

/// The array in `value`, which is one, for writing.
inline Array& own_array(Value& value) {
    ArrayRef& array = std::get<ArrayRef>(value);
    if (array.use_count() > 1)
        array = std::make_shared<Array>(*array);
    return *array;
}

} // namespace proxima
