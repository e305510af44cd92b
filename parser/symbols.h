// SPDX-License-Identifier: Apache-2.0
// Identifiers as small numbers. The reserved words come first and have the numbers of Word.
#pragma once
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace proxima {

using Symbol = uint32_t;

class SymbolTable {
public:
    /// Holds the reserved words.
    SymbolTable();

    Symbol intern(std::string_view name);
    std::string_view name(Symbol symbol) const { return names_[symbol]; }
    bool is_reserved(Symbol symbol) const { return symbol < reserved_count_; }
    uint32_t size() const { return uint32_t(names_.size()); }

private:
    void grow();

    std::deque<std::string> names_; // a deque: the views into it stay valid
    std::vector<Symbol> slots_;     // open addressing; a power of two
    std::vector<uint32_t> hashes_;  // of names_
    uint32_t reserved_count_ = 0;
};

} // namespace proxima
