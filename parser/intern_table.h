// SPDX-License-Identifier: Apache-2.0
// Stores equal records once: an index by content over a vector of plain records, in which others may stand as well.
#pragma once
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace proxima {

/// Records are compared byte by byte: they have no padding.
template <class Record> class InternTable {
    static_assert(std::is_trivially_copyable_v<Record> && sizeof(Record) % sizeof(uint32_t) == 0);

public:
    /// The index of a record equal to `record`, which is appended to `records` when there is none.
    uint32_t intern(std::vector<Record>& records, const Record& record) {
        if (count_ * 2 >= slots_.size())
            grow(records);
        const uint32_t mask = uint32_t(slots_.size() - 1);
        uint32_t slot = hash(record) & mask;
        for (; slots_[slot] != empty; slot = (slot + 1) & mask)
            if (std::memcmp(&records[slots_[slot]], &record, sizeof(Record)) == 0)
                return slots_[slot];
        slots_[slot] = uint32_t(records.size());
        ++count_;
        records.push_back(record);
        return slots_[slot];
    }

private:
    static constexpr uint32_t empty = 0xffffffffu;

    /// Multiply and fold, a word at a time.
    static uint32_t hash(const Record& record) {
        uint32_t words[sizeof(Record) / sizeof(uint32_t)];
        std::memcpy(words, &record, sizeof(Record));
        uint64_t value = 0x9e3779b97f4a7c15u;
        for (const uint32_t word : words) {
            value = (value ^ word) * 0xd6e8feb86659fd93u;
            value ^= value >> 32;
        }
        return uint32_t(value);
    }

    void grow(const std::vector<Record>& records) {
        const std::vector<uint32_t> old =
            std::exchange(slots_, std::vector<uint32_t>(slots_.empty() ? 64 : slots_.size() * 2, empty));
        const uint32_t mask = uint32_t(slots_.size() - 1);
        for (const uint32_t index : old) {
            if (index == empty)
                continue;
            uint32_t slot = hash(records[index]) & mask;
            while (slots_[slot] != empty)
                slot = (slot + 1) & mask;
            slots_[slot] = index;
        }
    }

    std::vector<uint32_t> slots_; // a power of two
    size_t count_ = 0;            // of records that are indexed
};

} // namespace proxima
