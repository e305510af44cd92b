// SPDX-License-Identifier: Apache-2.0
// Stores records that follow from the time beside those that do not: equal ones are stored once, and moving ones are
// equal when their nodes are the same.
#pragma once
#include "parser/intern_table.h"
#include "parser/moving_record.h"

#include <map>
#include <string>
#include <utility>

namespace proxima {

template <class Record> class MovingTable {
public:
    uint32_t add(std::vector<Record>& records, const Record& record) { return still_.intern(records, record); }
    uint32_t add(std::vector<Record>& records, const Moving<Record>& moving) {
        if (moving.nodes.empty())
            return add(records, moving.record);
        Key key(bytes_of(moving.record), moving.nodes);
        const auto [place, is_new] = known_.emplace(std::move(key), uint32_t(records.size()));
        if (is_new) {
            records.push_back(moving.record);
            nodes_.emplace(place->second, moving.nodes);
        }
        return place->second;
    }
    Moving<Record> get(const std::vector<Record>& records, uint32_t index) const {
        if (nodes_.empty())
            return records[index];
        const auto moving = nodes_.find(index);
        return {records[index], moving == nodes_.end() ? FieldNodes() : moving->second};
    }
    bool moves(uint32_t index) const { return nodes_.contains(index); }
    /// The nodes of the records that move, by index.
    const std::map<uint32_t, FieldNodes>& moving() const { return nodes_; }
    void mark(MotionGraph& graph) const {
        for (const auto& [index, nodes] : nodes_)
            nodes.mark(graph);
    }

private:
    using Key = std::pair<std::string, FieldNodes>;

    static std::string bytes_of(const Record& record) {
        return {reinterpret_cast<const char*>(&record), sizeof record};
    }

    InternTable<Record> still_;
    std::map<Key, uint32_t> known_;
    std::map<uint32_t, FieldNodes> nodes_;
};

} // namespace proxima
