// SPDX-License-Identifier: Apache-2.0
#include "parser/motion_compiler.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

namespace proxima {
namespace {

/// A shape whose equal steps are one: the operands of kind `constant` are columns.
struct Steps {
    std::vector<ShapeStep> steps;
    std::vector<ShapeOperand> outputs;
    std::vector<bool> uniform; ///< of steps: the same for all things of the shape

    explicit Steps(const MotionShape& shape) {
        std::vector<uint32_t> merged(shape.steps.size());
        using Key = std::tuple<bool, MotionOp, std::array<uint64_t, 3>>;
        std::map<Key, uint32_t> known;
        const auto in_columns = [&](ShapeOperand operand) {
            if (operand.kind == ShapeOperand::Kind::step)
                operand.index = merged[operand.index];
            else if (operand.kind == ShapeOperand::Kind::constant)
                operand.index = shape.constants.column_of(operand.index);
            return operand;
        };
        const auto is_uniform = [&](const ShapeOperand& operand) {
            return operand.kind == ShapeOperand::Kind::step       ? bool(uniform[operand.index])
                   : operand.kind == ShapeOperand::Kind::constant ? !shape.constants.varies(operand.index)
                                                                  : true;
        };
        for (size_t i = 0; i < shape.steps.size(); ++i) {
            ShapeStep step = shape.steps[i];
            Key key{step.is_choice, step.op, {}};
            for (size_t k = 0; k < 3; ++k) {
                step.operands[k] = in_columns(step.operands[k]);
                std::get<2>(key)[k] = uint64_t(step.operands[k].kind) << 32 | step.operands[k].index;
            }
            const auto [place, is_new] = known.emplace(key, uint32_t(steps.size()));
            merged[i] = place->second;
            if (!is_new)
                continue;
            steps.push_back(step);
            uniform.push_back(std::ranges::all_of(step.operands, is_uniform));
        }
        for (const ShapeOperand& output : shape.outputs)
            outputs.push_back(in_columns(output));
    }
};

/// Writes the code of one program.
class Emitter {
public:
    Emitter(const MotionShape& shape, const Steps& steps, MotionCode& code)
        : shape_(shape), steps_(steps), code_(code) {}

    /// From now on a step's result is in the array of shared constants; its place there is filled in by others.
    void share(uint32_t step) { shared_steps_.emplace(step, 0); }

    bool emit(std::span<const ShapeOperand> outputs, std::span<const uint32_t> targets) {
        program_.target = shape_.target;
        program_.first_instruction = uint32_t(code_.instructions.size());
        program_.first_output = uint32_t(code_.outputs.size());
        program_.first_shared = uint32_t(code_.shared.size());
        program_.first_instance = uint32_t(code_.targets.size());
        program_.instances = uint32_t(targets.size());
        program_.first_constant = code_.constants.size();
        for (auto& [step, place] : shared_steps_)
            place = add_shared(0);
        find_last_uses(outputs);
        for (uint32_t step = 0; step < last_use_.size(); ++step)
            if (last_use_[step] != unused && !shared_steps_.contains(step))
                emit_step(step);
        for (const ShapeOperand& output : outputs)
            code_.outputs.push_back(operand(output));
        program_.instructions = uint32_t(code_.instructions.size()) - program_.first_instruction;
        program_.own_constants = own_;
        code_.targets.insert(code_.targets.end(), targets.begin(), targets.end());
        code_.programs.push_back(program_);
        return fits_;
    }

    /// Index into code.shared.
    uint32_t shared_place(uint32_t step) const { return program_.first_shared + shared_steps_.at(step); }

private:
    static constexpr uint32_t unused = 0xffffffffu;
    static constexpr uint32_t at_end = 0xfffffffeu;

    void find_last_uses(std::span<const ShapeOperand> outputs) {
        last_use_.assign(steps_.steps.size(), unused);
        register_of_.assign(steps_.steps.size(), 0);
        const auto use = [&](const ShapeOperand& operand, uint32_t by) {
            if (operand.kind == ShapeOperand::Kind::step && last_use_[operand.index] == unused)
                last_use_[operand.index] = by; // from the end: the first one found is the last use
        };
        for (const ShapeOperand& output : outputs)
            use(output, at_end);
        for (size_t step = steps_.steps.size(); step-- > 0;)
            if (last_use_[step] != unused && !shared_steps_.contains(uint32_t(step)))
                for (const ShapeOperand& operand : steps_.steps[step].operands)
                    use(operand, uint32_t(step));
    }

    void emit_step(uint32_t index) {
        const ShapeStep& step = steps_.steps[index];
        const auto release = [&](const ShapeOperand& operand) {
            if (operand.kind == ShapeOperand::Kind::step && last_use_[operand.index] == index &&
                !shared_steps_.contains(operand.index) && taken_[register_of_[operand.index]])
                taken_[register_of_[operand.index]] = false;
        };
        uint8_t codes[3] = {};
        for (int i = 0; i < 3; ++i)
            if (step.operands[i].kind != ShapeOperand::Kind::none)
                codes[i] = operand(step.operands[i]);
        if (!step.is_choice)
            for (const ShapeOperand& operand : step.operands)
                release(operand);
        const uint8_t result = take_register();
        register_of_[index] = result;
        if (step.is_choice) {
            code_.instructions.push_back({MotionOp::copy, result, codes[2], 0});
            code_.instructions.push_back({MotionOp::pick, result, codes[0], codes[1]});
            for (const ShapeOperand& operand : step.operands)
                release(operand);
        } else {
            code_.instructions.push_back({step.op, result, codes[0], codes[1]});
        }
    }

    uint8_t take_register() {
        for (uint8_t i = 0; i < MotionOperand::registers; ++i)
            if (!taken_[i]) {
                taken_[i] = true;
                return i;
            }
        fits_ = false;
        return 0;
    }

    uint8_t operand(const ShapeOperand& operand) {
        switch (operand.kind) {
        case ShapeOperand::Kind::time:
            return operand.index == uint32_t(MotionNode::Kind::clock)          ? MotionOperand::clock
                   : operand.index == uint32_t(MotionNode::Kind::frame_number) ? MotionOperand::frame_number
                                                                               : MotionOperand::clock_delta;
        case ShapeOperand::Kind::constant:
            return column(operand.index);
        default:
            break;
        }
        const auto shared = shared_steps_.find(operand.index);
        return shared == shared_steps_.end() ? register_of_[operand.index]
                                             : uint8_t(MotionOperand::first_shared + shared->second);
    }

    uint8_t column(uint32_t index) {
        const auto known = columns_.find(index);
        if (known != columns_.end())
            return known->second;
        const bool varies = shape_.constants.varies(index) && program_.instances > 1;
        const bool shares = !varies && shared_ < MotionOperand::shared_count;
        const uint8_t code =
            shares ? uint8_t(MotionOperand::first_shared + add_shared(shape_.constants.first(index))) : add_own(index);
        return columns_.emplace(index, code).first->second;
    }

    uint32_t add_shared(double number) {
        fits_ = fits_ && shared_ < MotionOperand::shared_count;
        code_.shared.push_back(number);
        return shared_++;
    }

    uint8_t add_own(uint32_t index) {
        fits_ = fits_ && own_ < MotionOperand::own_count;
        const std::span<const double> numbers = shape_.constants.numbers(index);
        if (shape_.constants.varies(index))
            code_.constants.insert(code_.constants.end(), numbers.begin(), numbers.end());
        else
            code_.constants.insert(code_.constants.end(), program_.instances, shape_.constants.first(index));
        return uint8_t(MotionOperand::first_own + own_++);
    }

    const MotionShape& shape_;
    const Steps& steps_;
    MotionCode& code_;
    MotionProgram program_;
    std::map<uint32_t, uint32_t> shared_steps_; ///< to their place among the shared constants
    std::map<uint32_t, uint8_t> columns_;       ///< to their operands
    std::vector<uint32_t> last_use_;
    std::vector<uint8_t> register_of_;
    bool taken_[MotionOperand::registers] = {};
    uint32_t shared_ = 0;
    uint32_t own_ = 0;
    bool fits_ = true;
};

/// The uniform steps that the others, or the outputs, work with.
std::vector<uint32_t> hoisted_steps(const Steps& steps) {
    std::vector<bool> needed(steps.steps.size()), hoisted(steps.steps.size());
    const auto need = [&](const ShapeOperand& operand) {
        if (operand.kind == ShapeOperand::Kind::step)
            (steps.uniform[operand.index] ? hoisted : needed)[operand.index] = true;
    };
    std::ranges::for_each(steps.outputs, need);
    for (size_t step = steps.steps.size(); step-- > 0;)
        if (needed[step])
            std::ranges::for_each(steps.steps[step].operands, need);
    std::vector<uint32_t> result;
    for (uint32_t step = 0; step < hoisted.size(); ++step)
        if (hoisted[step])
            result.push_back(step);
    return result;
}

} // namespace

bool compile(const MotionShape& shape, MotionPrograms& programs) {
    const Steps steps(shape);
    if (shape.target == MotionTarget::number)
        return Emitter(shape, steps, programs.numbers).emit(steps.outputs, shape.targets);
    Emitter emitter(shape, steps, programs.spheres);
    const std::vector<uint32_t> hoisted = hoisted_steps(steps);
    for (const uint32_t step : hoisted)
        emitter.share(step);
    bool fits = emitter.emit(steps.outputs, shape.targets);
    for (const uint32_t step : hoisted) {
        const ShapeOperand output[] = {{ShapeOperand::Kind::step, step}};
        const uint32_t target[] = {emitter.shared_place(step)};
        Emitter uniform(shape, steps, programs.uniforms);
        fits = uniform.emit(output, target) && fits;
        programs.uniforms.programs.back().target = MotionTarget::number;
    }
    return fits;
}

} // namespace proxima
