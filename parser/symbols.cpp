// SPDX-License-Identifier: Apache-2.0
#include "parser/symbols.h"

#include "parser/words.h"

namespace proxima {
namespace {

constexpr Symbol empty_slot = 0xffffffffu;

/// FNV-1a (Fowler, Noll, Vo, 1991); its low bits are mixed enough for a table of names.
uint32_t hash(std::string_view name) {
    uint32_t value = 2166136261u;
    for (const char c : name)
        value = (value ^ uint8_t(c)) * 16777619u;
    return value ^ (value >> 15);
}

} // namespace

SymbolTable::SymbolTable() : slots_(2048, empty_slot) {
    for (const std::string_view word : reserved_words())
        intern(word);
    reserved_count_ = size();
}

Symbol SymbolTable::intern(std::string_view name) {
    const uint32_t hashed = hash(name);
    const size_t mask = slots_.size() - 1;
    size_t slot = hashed & mask;
    for (; slots_[slot] != empty_slot; slot = (slot + 1) & mask)
        if (hashes_[slots_[slot]] == hashed && names_[slots_[slot]] == name)
            return slots_[slot];
    const Symbol symbol = size();
    slots_[slot] = symbol;
    names_.emplace_back(name);
    hashes_.push_back(hashed);
    if (names_.size() * 2 > slots_.size())
        grow();
    return symbol;
}

void SymbolTable::grow() {
    slots_.assign(slots_.size() * 2, empty_slot);
    const size_t mask = slots_.size() - 1;
    for (Symbol symbol = 0; symbol < size(); ++symbol) {
        size_t slot = hashes_[symbol] & mask;
        while (slots_[slot] != empty_slot)
            slot = (slot + 1) & mask;
        slots_[slot] = symbol;
    }
}

} // namespace proxima
