// SPDX-License-Identifier: Apache-2.0
// What a frame costs with a grid or a cloud: its work, counted, times what a unit of it takes on a device.
#pragma once
#include "renderer/grid_plan.h"

#include <array>
#include <cstdint>
#include <vector>

namespace proxima {

/// What a frame would do. Lookups and tests are those of a pixel with all its rays, by the mean of the pilots;
/// `together` by the slowest of each group that goes through the grid as one (see PilotPattern).
struct FrameWork {
    struct Walk {
        double lookups = 0; ///< of voxels and bricks
        double tests = 0;   ///< of primitives
    };
    double primitives = 0;
    double cells = 0;     ///< voxels with a list, which begins empty
    double links = 0;     ///< entries of all lists
    double bricks = 0;    ///< of the cloud
    double distances = 0; ///< of all bricks, added up
    double pixels = 0;    ///< times samples
    Walk mean{}, together{};
};

/// Milliseconds.
struct FrameCost {
    double build = 0, map = 0, trace = 0;
    double total() const { return build + map + trace; }
};

/// Nanoseconds for each unit of work; the fixed ones for each frame. Fitted by tests/bench/choice_bench.cpp.
struct WorkCosts {
    double build_fixed = 0, primitive = 0, cell = 0, link = 0, mark = 0;
    double map_fixed = 0, brick = 0, distance = 0;
    double trace_fixed = 0, pixel = 0, lookup = 0, test = 0;
    bool goes_together = false; ///< rays are as slow as the slowest of their group

    FrameCost cost(const FrameWork& work) const {
        const FrameWork::Walk& walk = goes_together ? work.together : work.mean;
        constexpr double ns = 1e-6;
        return {ns * (build_fixed + primitive * work.primitives + cell * work.cells + link * work.links +
                      mark * work.bricks),
                ns * (map_fixed + brick * work.bricks + distance * work.distances),
                ns * (trace_fixed + work.pixels * (pixel + lookup * walk.lookups + test * walk.tests))};
    }
    /// The same work by several cores at once.
    WorkCosts shared_by(int cores) const {
        WorkCosts costs = *this;
        for (double* each : {&costs.primitive, &costs.cell, &costs.link, &costs.mark, &costs.brick, &costs.distance,
                             &costs.pixel, &costs.lookup, &costs.test})
            *each /= cores;
        return costs;
    }
};

struct CostCoefficients {
    WorkCosts grid, cloud;

    const WorkCosts& of(const GridPlan& plan) const { return plan.has_cloud() ? cloud : grid; }
};

/// A way to render a frame, and what is known of it before it is taken.
struct PlannedMethod {
    GridPlan plan;
    std::array<uint32_t, 3> size{0, 0, 0}; ///< voxels
    FrameWork work{};
    double occupied_bricks = 0;
    double mean_distance = 0; ///< over the empty bricks, in bricks
    uint64_t bytes = 0;       ///< of the grid and the cloud on the device
    FrameCost cost{};
};

/// All that were looked at, and which one was picked.
struct FramePlan {
    std::vector<PlannedMethod> methods;
    size_t picked = 0;
};

} // namespace proxima
