// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_graph.h"

#include <algorithm>

namespace proxima {

thread_local MotionGraph* MotionGraph::current_ = nullptr;

NodeId recorded(MotionOp op, const Varying& a) {
    MotionGraph* const graph = MotionGraph::current();
    return graph ? graph->operation(op, a) : 0;
}

NodeId recorded(MotionOp op, const Varying& a, const Varying& b) {
    MotionGraph* const graph = MotionGraph::current();
    return graph ? graph->operation(op, a, b) : 0;
}

Varying choose(const Varying& condition, const Varying& chosen, const Varying& other) {
    const Varying truth = apply(MotionOp::truth, condition);
    const Varying& now = truth.value != 0 ? chosen : other;
    MotionGraph* const graph = MotionGraph::current();
    return truth.node && graph ? Varying(now.value, graph->choice(truth.node, chosen, other)) : now;
}

bool decide(const Varying& condition) {
    const bool holds = is_true(condition.value);
    if (MotionGraph* const graph = MotionGraph::current(); condition.node && graph)
        graph->guard(apply(holds ? MotionOp::truth : MotionOp::logical_not, condition).node);
    return holds;
}

MotionGraph::MotionGraph() : nodes_(size_t(MotionNode::Kind::clock_delta) + 1) {
    for (const auto kind : {MotionNode::Kind::clock, MotionNode::Kind::frame_number, MotionNode::Kind::clock_delta})
        nodes_[size_t(kind)].kind = kind;
}

MotionGraph::Scratch::Scratch(MotionGraph& graph) : graph_(graph), size_(graph.nodes_.size()), outer_(graph.scratch_) {
    graph.scratch_ = true;
}

MotionGraph::Scratch::~Scratch() {
    graph_.made_ -= graph_.nodes_.size() - size_;
    graph_.nodes_.resize(size_);
    graph_.scratch_ = outer_;
}

NodeId MotionGraph::add(const MotionNode& node) {
    ++made_;
    if (scratch_ || free_.empty()) {
        nodes_.push_back(node);
        return NodeId(nodes_.size() - 1);
    }
    const NodeId id = free_.back();
    free_.pop_back();
    nodes_[id] = node;
    return id;
}

NodeId MotionGraph::node_of(const Varying& number) {
    if (number.node)
        return number.node;
    const uint64_t bits = std::bit_cast<uint64_t>(number.value);
    return add({.kind = MotionNode::Kind::constant, .operands = {0, uint32_t(bits), uint32_t(bits >> 32)}});
}

NodeId MotionGraph::operation(MotionOp op, const Varying& a) {
    return records_ ? add({.kind = MotionNode::Kind::operation, .op = op, .operands = {node_of(a), 0, 0}}) : 0;
}

NodeId MotionGraph::operation(MotionOp op, const Varying& a, const Varying& b) {
    if (!records_)
        return 0;
    const NodeId left = node_of(a), right = node_of(b);
    return add({.kind = MotionNode::Kind::operation, .op = op, .operands = {left, right, 0}});
}

NodeId MotionGraph::choice(NodeId condition, const Varying& chosen, const Varying& other) {
    if (!records_)
        return 0;
    const NodeId left = node_of(chosen), right = node_of(other);
    return add({.kind = MotionNode::Kind::choice, .operands = {condition, left, right}});
}

NodeId MotionGraph::terms(const NodeId (&n)[5]) {
    if (!records_ || !(n[0] | n[1] | n[2] | n[3] | n[4]))
        return 0;
    if (!(n[3] | n[4]))
        return add({.kind = MotionNode::Kind::terms, .operands = {n[0], n[1], n[2]}});
    const NodeId last = add({.kind = MotionNode::Kind::terms, .operands = {n[2], n[3], n[4]}});
    return add({.kind = MotionNode::Kind::terms, .five = true, .operands = {n[0], n[1], last}});
}

NodeId MotionGraph::term(NodeId nodes, int index) const {
    const MotionNode& node = nodes_[nodes];
    if (node.kind != MotionNode::Kind::terms)
        return nodes;
    if (index < 2 || !node.five)
        return index < 3 ? node.operands[index] : 0;
    return nodes_[node.operands[2]].operands[index - 2];
}

uint64_t MotionGraph::keep(std::span<const double> table) {
    const uint64_t place = splines_.size();
    splines_.insert(splines_.end(), table.begin(), table.end());
    return place;
}

bool MotionGraph::changes_between_frames(NodeId id) const {
    std::vector<NodeId> pending{id};
    std::vector<bool> seen(nodes_.size());
    while (!pending.empty()) {
        const NodeId next = pending.back();
        pending.pop_back();
        if (next == 0 || seen[next])
            continue;
        seen[next] = true;
        const MotionNode& node = nodes_[next];
        if (node.kind == MotionNode::Kind::clock || node.kind == MotionNode::Kind::frame_number)
            return true;
        if (node.kind != MotionNode::Kind::constant)
            pending.insert(pending.end(), node.operands, node.operands + 3);
    }
    return false;
}

void MotionGraph::mark(NodeId id) {
    pending_.assign(1, id);
    while (!pending_.empty()) {
        MotionNode& node = nodes_[pending_.back()];
        pending_.pop_back();
        if (node.marked)
            continue;
        node.marked = true;
        if (node.kind >= MotionNode::Kind::operation)
            for (const NodeId operand : node.operands)
                if (operand && !nodes_[operand].marked)
                    pending_.push_back(operand);
    }
}

void MotionGraph::sweep() {
    for (const NodeId guard : guards_)
        mark(guard);
    free_.clear();
    for (size_t id = nodes_.size() - 1; id > size_t(MotionNode::Kind::clock_delta); --id) {
        if (!nodes_[id].marked) {
            nodes_[id] = {};
            free_.push_back(NodeId(id));
        }
        nodes_[id].marked = false;
    }
    made_ = nodes_.size() - free_.size();
    limit_ = std::max<uint64_t>(1 << 18, 2 * made_);
}

} // namespace proxima
