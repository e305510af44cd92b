// SPDX-License-Identifier: Apache-2.0
// A plain record of the scene, and the nodes of those of its numbers that follow from the time.
#pragma once
#include "parser/motion_graph.h"
#include "parser/motion_programs.h"

#include <vector>

namespace proxima {

/// The node of the number that stands `offset` bytes into a record.
struct FieldNode {
    uint32_t offset = 0;
    MotionField::Type type = MotionField::Type::float64;
    NodeId node = 0;

    friend auto operator<=>(const FieldNode&, const FieldNode&) = default;
};

inline uint32_t offset_of(const void* record, const void* place) {
    return uint32_t(static_cast<const std::byte*>(place) - static_cast<const std::byte*>(record));
}

/// Of one record, in the order of their offsets.
class FieldNodes {
public:
    /// 0 takes a node away.
    void set(FieldNode field);
    NodeId at(uint32_t offset) const;

    // Sets a number or vector in the record at `record`, and its nodes.
    void put(const void* record, float& place, const Varying& v) {
        place = float(v.value);
        put_node(record, &place, MotionField::Type::float32, v.node);
    }
    void put(const void* record, double& place, const Varying& v) {
        place = v.value;
        put_node(record, &place, MotionField::Type::float64, v.node);
    }
    template <class Number> void put(const void* record, Vec3<Number>& place, const Vec3<Varying>& v) {
        for (int i = 0; i < 3; ++i)
            put(record, place[i], v[i]);
    }
    void put(const void* record, Affine<double>& place, const Affine<Varying>& v) {
        for (int i = 0; i < 3; ++i)
            put(record, place.linear[i], v.linear[i]);
        put(record, place.offset, v.offset);
    }

    bool empty() const { return fields_.empty(); }
    auto begin() const { return fields_.begin(); }
    auto end() const { return fields_.end(); }
    void mark(MotionGraph& graph) const;

    friend auto operator<=>(const FieldNodes&, const FieldNodes&) = default;

private:
    void put_node(const void* record, const void* place, MotionField::Type type, NodeId node) {
        if (node || !empty())
            set({offset_of(record, place), type, node});
    }

    std::vector<FieldNode> fields_;
};

template <class Record> struct Moving {
    Record record{};
    FieldNodes nodes;

    Moving() = default;
    Moving(const Record& record, FieldNodes nodes = {}) : record(record), nodes(std::move(nodes)) {}

    const Record* operator->() const { return &record; }

    /// `place` is a number or vector in the record.
    template <class Place, class Value> void set(Place& place, const Value& value) { nodes.put(&record, place, value); }
    bool moves(const float& place) const { return nodes.at(offset_of(&record, &place)) != 0; }

    Varying get(const float& place) const { // rounded, as the record has it
        const NodeId node = nodes.at(offset_of(&record, &place));
        return {double(place), node ? recorded(MotionOp::single, {double(place), node}) : 0};
    }
    Varying get(const double& place) const { return {place, nodes.empty() ? 0 : nodes.at(offset_of(&record, &place))}; }
    Vec3<Varying> get(const Vec3<double>& place) const { return {get(place.x), get(place.y), get(place.z)}; }
    Affine<Varying> get(const Affine<double>& place) const {
        return {Mat3<Varying>(get(place.linear[0]), get(place.linear[1]), get(place.linear[2])), get(place.offset)};
    }
};

} // namespace proxima
