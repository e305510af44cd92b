// SPDX-License-Identifier: Apache-2.0
// How numbers of a scene were computed from the time: a graph of operations, written while the script is evaluated.
// Equal operations are not merged here: so what is computed by one piece of script has one shape, whatever its numbers.
#pragma once
#include "parser/varying.h"

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace proxima {

struct MotionNode {
    enum class Kind : uint8_t {
        unused,
        clock,
        frame_number,
        clock_delta,
        constant,
        operation, ///< of one operand, or two
        choice,    ///< operands: the condition (0 or not), what is taken if it is not 0, what else
        terms,     ///< of a vector or colour: 3 nodes; or 5, the last operand being a node of terms that holds three
    };

    Kind kind = Kind::unused;
    MotionOp op = MotionOp::copy;
    bool five = false; ///< of terms
    bool marked = false;
    NodeId operands[3] = {}; ///< 0: none. A constant keeps its value in the last two.

    double constant() const { return std::bit_cast<double>(uint64_t(operands[1]) | uint64_t(operands[2]) << 32); }
    friend bool operator==(const MotionNode&, const MotionNode&) = default;
};

class MotionGraph {
public:
    MotionGraph();

    /// Makes a graph the one that this thread records, until the end of the scope.
    class Recording {
    public:
        explicit Recording(MotionGraph& graph) : outer_(current_) { current_ = &graph; }
        ~Recording() { current_ = outer_; }
        Recording(const Recording&) = delete;

    private:
        MotionGraph* outer_;
    };
    /// Nodes that are made in the scope are gone at its end.
    class Scratch {
    public:
        explicit Scratch(MotionGraph& graph);
        ~Scratch();
        Scratch(const Scratch&) = delete;

    private:
        MotionGraph& graph_;
        size_t size_;
        bool outer_;
    };
    static MotionGraph* current() { return current_; }

    /// Until stop(), numbers that follow from the time get nodes.
    void start() { records_ = true; }
    void stop() { records_ = false; }
    bool records() const { return records_; }

    /// One of the leaves; 0 when nothing is recorded.
    NodeId time(MotionNode::Kind kind) const { return records_ ? NodeId(kind) : 0; }
    NodeId operation(MotionOp op, const Varying& a);
    NodeId operation(MotionOp op, const Varying& a, const Varying& b);
    NodeId choice(NodeId condition, const Varying& chosen, const Varying& other);
    /// The node of a vector whose terms have these nodes: 0 when none has one.
    NodeId terms(const NodeId (&nodes)[5]);
    /// The node of one term of a vector: all of them may have the same.
    NodeId term(NodeId nodes, int index) const;

    const MotionNode& node(NodeId id) const { return nodes_[id]; }
    size_t size() const { return nodes_.size(); }
    /// Whether a number follows from clock or frame_number, not from clock_delta alone, which an animation keeps.
    bool changes_between_frames(NodeId id) const;

    /// Keeps a table for operations that look into it. Returns where it begins.
    uint64_t keep(std::span<const double> table);
    std::vector<double>& splines() { return splines_; }

    /// What must be true in every frame that is computed from this evaluation.
    const std::vector<NodeId>& guards() const { return guards_; }
    void guard(NodeId condition) {
        if (condition)
            guards_.push_back(condition);
    }

    /// So many nodes were made that those which nobody needs any more should go: mark those that are needed, then
    /// sweep.
    bool is_crowded() const { return made_ > limit_; }
    void mark(NodeId id);
    void sweep();

private:
    NodeId add(const MotionNode& node);
    NodeId node_of(const Varying& number);

    static thread_local MotionGraph* current_;

    std::vector<MotionNode> nodes_;
    std::vector<NodeId> free_;
    std::vector<NodeId> guards_;
    std::vector<double> splines_; ///< tables
    std::vector<NodeId> pending_; ///< of mark()
    uint64_t made_ = 0;           ///< nodes since the last sweep, and those that were left then
    uint64_t limit_ = 1 << 18;
    bool records_ = false;
    bool scratch_ = false;
};

/// Whether a condition is true; it must then be the same in every frame that is computed from this evaluation.
bool decide(const Varying& condition);

} // namespace proxima
