// SPDX-License-Identifier: Apache-2.0
// The motion of a scene's spheres on a device: programs and constants, uploaded once; a kernel moves the spheres to any
// time.
#pragma once
#include "kernels/motion.h"
#include "parser/motion_programs.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace proxima {

template <class Backend> class DeviceMotion {
public:
    explicit DeviceMotion(Backend& backend)
        : backend_(backend), programs_(backend), instructions_(backend), outputs_(backend), shared_(backend),
          constants_(backend), targets_(backend), splines_(backend), failures_(backend) {}

    /// Takes over the programs of spheres. `order[place]` is the id of the sphere that stands at a place of the
    /// device's array; empty when places are ids.
    void upload(const MotionPrograms& motion, std::span<const uint32_t> order) {
        moving_ = uint32_t(motion.moving_spheres());
        uniforms_.uniforms = motion.uniforms;
        uniforms_.spheres.shared = motion.spheres.shared;
        uniforms_.splines = motion.splines;
        if (moving_ == 0)
            return;
        const MotionCode& code = motion.spheres;
        const std::vector<uint32_t> instances = in_order(code, order);
        std::vector<uint32_t> place_of(order.size());
        for (uint32_t place = 0; place < order.size(); ++place)
            place_of[order[place]] = place;
        targets_.upload(moving_, [&](size_t i) {
            const uint32_t id = code.targets[instances[i]];
            return order.empty() ? id : place_of[id];
        });
        upload_constants(code, instances);
        programs_.upload(code.programs.size(), [&](size_t i) { return code.programs[i]; });
        instructions_.upload(code.instructions.size(), [&](size_t i) { return code.instructions[i]; });
        outputs_.upload(code.outputs.size(), [&](size_t i) { return code.outputs[i]; });
        upload_shared(code.shared);
        has_splines_ = std::ranges::any_of(code.instructions, is_spline, &MotionInstruction::op);
        if (has_splines_)
            splines_.upload(motion.splines.size(), [&](size_t i) { return motion.splines[i]; });
        failures_.resize(1);
        failures_.fill_bytes(0);
    }

    bool empty() const { return moving_ == 0; }

    /// Starts moving the spheres. `exact` is empty or the same spheres in double. False when a number that spheres
    /// share is not finite.
    template <class Real>
    [[nodiscard]] bool move(const MotionTime& time, std::span<Sphere<Real>> spheres, std::span<Sphere<double>> exact) {
        if (!uniforms_.uniforms.empty()) {
            std::vector<double> shared = uniforms_.spheres.shared;
            if (!evaluate_uniforms(uniforms_, time, shared))
                return false;
            upload_shared(shared);
        }
        const MotionView view{programs_.view(),  instructions_.view(), outputs_.view(), shared_.view(),
                              constants_.view(), targets_.view(),      splines_.view()};
        if (has_splines_)
            backend_.for_each(moving_, MoveSpheres<Real, true>{view, time, spheres, exact, failures_.view()});
        else
            backend_.for_each(moving_, MoveSpheres<Real, false>{view, time, spheres, exact, failures_.view()});
        return true;
    }

    /// Whether a sphere met a number that is not finite since the last call. Waits for the device.
    bool take_failure() {
        if (moving_ == 0 || failures_.read(0) == 0)
            return false;
        failures_.fill_bytes(0);
        return true;
    }

private:
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    /// The instances of each program in the order of their spheres' places, so that neighbours write to neighbours.
    static std::vector<uint32_t> in_order(const MotionCode& motion, std::span<const uint32_t> order) {
        const uint32_t moving = uint32_t(motion.targets.size());
        std::vector<uint32_t> instances(moving);
        std::iota(instances.begin(), instances.end(), 0u);
        if (order.empty())
            return instances;
        constexpr uint32_t none = 0xffffffffu;
        std::vector<uint32_t> instance_of(order.size(), none);
        for (uint32_t i = 0; i < moving; ++i)
            instance_of[motion.targets[i]] = i;
        std::vector<uint32_t> next(motion.programs.size());
        const auto first = [&](uint32_t program) { return motion.programs[program].first_instance; };
        for (uint32_t program = 0; program < next.size(); ++program)
            next[program] = first(program);
        const std::span<const MotionProgram> programs = motion.programs;
        for (const uint32_t id : order) {
            const uint32_t instance = instance_of[id];
            if (instance == none)
                continue;
            const auto behind = std::ranges::upper_bound(programs, instance, {}, &MotionProgram::first_instance);
            instances[next[behind - programs.begin() - 1]++] = instance;
        }
        return instances;
    }

    void upload_constants(const MotionCode& motion, std::span<const uint32_t> instances) {
        const uint64_t count = motion.constants.size();
        std::vector<double> constants(count);
        for (const MotionProgram& program : motion.programs)
            for (uint32_t k = 0; k < program.own_constants; ++k) {
                const uint64_t row = program.first_constant + uint64_t(k) * program.instances;
                for (uint32_t i = 0; i < program.instances; ++i)
                    constants[row + i] =
                        motion.constants[row + instances[program.first_instance + i] - program.first_instance];
            }
        constants_.upload(count, [&](size_t i) { return constants[i]; });
    }

    void upload_shared(const std::vector<double>& shared) {
        shared_.upload(shared.size(), [&](size_t i) { return shared[i]; });
    }

    Backend& backend_;
    MotionPrograms uniforms_; ///< and the shared constants that they are put into
    Buffer<MotionProgram> programs_;
    Buffer<MotionInstruction> instructions_;
    Buffer<uint8_t> outputs_;
    Buffer<double> shared_;
    Buffer<double> constants_;
    Buffer<uint32_t> targets_;
    Buffer<double> splines_;
    Buffer<uint32_t> failures_;
    uint32_t moving_ = 0;
    bool has_splines_ = false; ///< of the programs for spheres
};

} // namespace proxima
