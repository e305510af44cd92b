// SPDX-License-Identifier: Apache-2.0
#include "renderer/method_plan.h"

#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

const char* name_of(const PlannedMethod& method) {
    return method.plan.has_cloud() ? "cloud" : "grid";
}

/// The cheapest grid or cloud of those that were looked at; null if none was.
const PlannedMethod* best_of(const FramePlan& plan, bool has_cloud) {
    const PlannedMethod* best = nullptr;
    for (const PlannedMethod& method : plan.methods)
        if (method.plan.has_cloud() == has_cloud && (!best || method.cost.total() < best->cost.total()))
            best = &method;
    return best;
}

double in_hundredths(double value) {
    return std::round(100 * value) / 100;
}

void add_method(PlanSection& section, const PlannedMethod& method) {
    const FrameWork& work = method.work;
    const auto add = [&](const char* what, PlanSection::Value value) {
        section.values.emplace_back(fmt::format("{}_{}", name_of(method), what), std::move(value));
    };
    add("voxels", fmt::format("{}x{}x{}", method.size[0], method.size[1], method.size[2]));
    const double voxels = double(method.size[0]) * method.size[1] * method.size[2];
    add("voxels_a_primitive", in_hundredths(voxels / work.primitives));
    if (method.plan.has_cloud()) {
        add("bricks", uint64_t(work.bricks));
        add("occupied_percent", in_hundredths(100 * method.occupied_bricks / work.bricks));
        add("mean_distance", in_hundredths(method.mean_distance));
    }
    add("references", uint64_t(work.links));
    add("megabytes", in_hundredths(double(method.bytes) / 1e6));
    add("lookups_a_pixel", in_hundredths(work.mean.lookups));
    add("tests_a_pixel", in_hundredths(work.mean.tests));
    add("build_ms", in_hundredths(method.cost.build));
    if (method.plan.has_cloud())
        add("map_ms", in_hundredths(method.cost.map));
    add("trace_ms", in_hundredths(method.cost.trace));
    add("frame_ms", in_hundredths(method.cost.total()));
}

} // namespace

PlanSection method_plan(const FramePlan& plan, const std::string& device) {
    PlanSection section{.name = "rendering", .decision = "", .values = {}};
    if (plan.methods.empty()) {
        section.decision =
            fmt::format("{}, by testing every primitive: there is too little, or it is asked for", device);
        return section;
    }
    const PlannedMethod& picked = plan.methods[plan.picked];
    const PlannedMethod* other = best_of(plan, !picked.plan.has_cloud());
    section.decision =
        fmt::format("{}, by a {} of {}x{}x{} voxels, {:.2f} ms a frame by prediction", device, name_of(picked),
                    picked.size[0], picked.size[1], picked.size[2], picked.cost.total());
    if (other)
        section.decision += fmt::format("; by a {} {:.2f} ms", name_of(*other), other->cost.total());
    section.values.emplace_back("method", std::string(name_of(picked)));
    section.values.emplace_back("looked_at", uint64_t(plan.methods.size()));
    for (const bool has_cloud : {false, true})
        if (const PlannedMethod* best = picked.plan.has_cloud() == has_cloud ? &picked : best_of(plan, has_cloud))
            add_method(section, *best);
    return section;
}

} // namespace proxima
