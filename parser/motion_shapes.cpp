// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_shapes.h"

namespace proxima {
namespace {

uint64_t mixed(uint64_t hash, uint64_t word) {
    hash = (hash ^ word) * 0xd6e8feb86659fd93u;
    return hash ^ hash >> 32;
}

uint64_t word_of(const ShapeOperand& operand) {
    return uint64_t(operand.kind) << 32 | operand.index;
}

uint64_t hash_of(MotionTarget target, std::span<const ShapeStep> steps, std::span<const ShapeOperand> outputs) {
    uint64_t hash = mixed(0x9e3779b97f4a7c15u, uint64_t(target));
    for (const ShapeStep& step : steps) {
        hash = mixed(hash, uint64_t(step.op) << 1 | uint64_t(step.is_choice));
        for (const ShapeOperand& operand : step.operands)
            hash = mixed(hash, word_of(operand));
    }
    for (const ShapeOperand& output : outputs)
        hash = mixed(hash, word_of(output));
    return hash;
}

} // namespace

bool MotionShapes::add(const MotionGraph& graph, MotionTarget target, uint32_t id, std::span<const Varying> results) {
    steps_.clear();
    outputs_.clear();
    constants_.clear();
    step_of_.resize(graph.size());
    visit_of_.resize(graph.size());
    ++visits_;
    for (const Varying& result : results)
        if (!visit(graph, result.node))
            return false;
    for (const Varying& result : results)
        outputs_.push_back(operand(graph, result));
    MotionShape& shape = shape_of(target);
    shape.constants.add(constants_);
    shape.targets.push_back(id);
    return steps_in_all_ <= most_steps_in_all;
}

/// Appends the steps that lead to a node, each behind those that it works with.
bool MotionShapes::visit(const MotionGraph& graph, NodeId root) {
    const auto is_step = [&](NodeId id) { return graph.node(id).kind >= MotionNode::Kind::operation; };
    const auto is_done = [&](NodeId id) { return !is_step(id) || visit_of_[id] == visits_; };
    pending_.assign(1, root);
    while (!pending_.empty()) {
        const NodeId id = pending_.back();
        const MotionNode& node = graph.node(id);
        const size_t before = pending_.size();
        if (!is_done(id))
            for (size_t i = 3; i-- > 0;)
                if (!is_done(node.operands[i]))
                    pending_.push_back(node.operands[i]);
        if (pending_.size() > before)
            continue;
        pending_.pop_back();
        if (is_done(id))
            continue;
        ShapeStep step{.is_choice = node.kind == MotionNode::Kind::choice, .op = node.op, .operands = {}};
        for (size_t i = 0; i < 3; ++i)
            if (node.operands[i])
                step.operands[i] = operand(graph, {0, node.operands[i]});
        visit_of_[id] = visits_;
        step_of_[id] = uint32_t(steps_.size());
        steps_.push_back(step);
        if (steps_.size() > most_steps)
            return false;
    }
    return true;
}

/// Constants are not looked for among those that are there: the shape must not depend on their values.
ShapeOperand MotionShapes::operand(const MotionGraph& graph, const Varying& number) {
    const MotionNode& node = graph.node(number.node);
    const bool is_constant = !number.node || node.kind == MotionNode::Kind::constant;
    if (is_constant) {
        constants_.push_back(number.node ? node.constant() : number.value);
        return {ShapeOperand::Kind::constant, uint32_t(constants_.size() - 1)};
    }
    if (node.kind < MotionNode::Kind::constant)
        return {ShapeOperand::Kind::time, uint32_t(node.kind)};
    return {ShapeOperand::Kind::step, step_of_[number.node]};
}

MotionShape& MotionShapes::shape_of(MotionTarget target) {
    const uint64_t hash = hash_of(target, steps_, outputs_);
    const auto [first, last] = by_hash_.equal_range(hash);
    for (auto known = first; known != last; ++known) {
        MotionShape& shape = shapes_[known->second];
        if (shape.target == target && shape.steps == steps_ && shape.outputs == outputs_)
            return shape;
    }
    by_hash_.emplace(hash, shapes_.size());
    steps_in_all_ += steps_.size();
    return shapes_.emplace_back(MotionShape{target, steps_, outputs_, MotionColumns(constants_.size()), {}});
}

void MotionShapes::clear() {
    shapes_.clear();
    by_hash_.clear();
    steps_in_all_ = 0;
}

} // namespace proxima
