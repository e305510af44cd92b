// SPDX-License-Identifier: Apache-2.0
// Things that move, gathered by the shape of their expressions: what is left of a graph when its constants are taken
// out. A million spheres of a loop are one shape and its constants; their graphs may go as soon as they are added.
#pragma once
#include "kernels/motion.h"
#include "parser/motion_columns.h"
#include "parser/motion_graph.h"

#include <unordered_map>

namespace proxima {

/// What a step of a shape works with: nothing, an earlier step, the constant at a place, or a part of the time.
struct ShapeOperand {
    enum class Kind : uint8_t { none, step, constant, time };
    Kind kind = Kind::none;
    uint32_t index = 0; ///< of time: a MotionNode::Kind

    friend bool operator==(const ShapeOperand&, const ShapeOperand&) = default;
};

struct ShapeStep {
    bool is_choice = false;
    MotionOp op = MotionOp::copy;
    ShapeOperand operands[3]; ///< as of a MotionNode

    friend bool operator==(const ShapeStep&, const ShapeStep&) = default;
};

struct MotionShape {
    MotionTarget target = MotionTarget::number;
    std::vector<ShapeStep> steps; ///< each behind those that it works with
    std::vector<ShapeOperand> outputs;
    MotionColumns constants;
    std::vector<uint32_t> targets; ///< of the rows of `constants`
};

class MotionShapes {
public:
    static constexpr size_t most_steps = 5000; ///< of one shape
    static constexpr size_t most_steps_in_all = 2'000'000;

    /// Adds a thing with these results, in a graph or constant. False when its expression is too long.
    bool add(const MotionGraph& graph, MotionTarget target, uint32_t id, std::span<const Varying> results);

    std::span<const MotionShape> all() const { return shapes_; }
    void clear();

private:
    bool visit(const MotionGraph& graph, NodeId root);
    ShapeOperand operand(const MotionGraph& graph, const Varying& number);
    MotionShape& shape_of(MotionTarget target);

    std::vector<MotionShape> shapes_;
    std::unordered_multimap<uint64_t, size_t> by_hash_;
    size_t steps_in_all_ = 0;

    // Of the thing that is added.
    std::vector<ShapeStep> steps_;
    std::vector<ShapeOperand> outputs_;
    std::vector<double> constants_;
    std::vector<NodeId> pending_;
    std::vector<uint32_t> step_of_;  ///< of the graph's nodes
    std::vector<uint32_t> visit_of_; ///< the visit that step_of_ is of
    uint32_t visits_ = 0;
};

} // namespace proxima
