// SPDX-License-Identifier: Apache-2.0
// Which grid or cloud the frames are made with: each method is looked at where it is cheapest, and the cheaper one is
// picked. What a way to render costs goes in; the choice comes out.
#pragma once
#include "renderer/frame_cost.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace proxima {

/// Resolutions are tried in steps of 2 (grids) and 4 (clouds) voxels a primitive, uphill and downhill from where the
/// method stood last. Looking costs pilot rays and, for clouds, their distances, so it is done now and then only, since
/// a scene changes slowly; and a choice is given up for one that is clearly cheaper only.
class PlanChooser {
public:
    static constexpr uint32_t interval = 64;      ///< frames from one look to the next
    static constexpr double clearly = 0.97;       ///< a cost over that of the present choice
    static constexpr double another_scene = 1.25; ///< times as many primitives, or as few
    static constexpr double out_of_reach = 1.5;   ///< a cloud that is not worth to be looked at in other resolutions
    static constexpr double first_grid = 2, first_cloud = 32; ///< voxels a primitive

    /// The ways that may be taken.
    struct Methods {
        bool grid = true, cloud = true;
        uint32_t brick = 4;
        Metric metric = Metric::chessboard;
        double pixels = 0; ///< times samples: what a choice was made for
        friend bool operator==(const Methods&, const Methods&) = default;
    };

    /// To be told before each frame: other methods than before are another choice.
    void allow(const Methods& methods) {
        if (methods == methods_)
            return;
        methods_ = methods;
        forget();
    }
    void forget() {
        chosen_.reset();
        grid_start_ = first_grid;
        cloud_start_ = first_cloud;
    }

    /// What to build before anything was looked at.
    GridPlan grid_plan(double density = first_grid) const { return {.voxels_per_primitive = density}; }
    GridPlan cloud_plan(double density = first_cloud) const {
        return {.voxels_per_primitive = density, .brick = methods_.brick, .metric = methods_.metric};
    }
    bool has_choice() const { return chosen_.has_value(); }
    void start_with(const GridPlan& plan) {
        chosen_ = plan;
        frames_left_ = 0;
    }
    const GridPlan& choice() const { return *chosen_; }

    /// Once a frame: whether it is time to look. Another number of primitives is another scene.
    bool is_due(uint32_t primitives) {
        const double change = (double(primitives) + 1) / (double(primitives_) + 1);
        if (frames_left_ > 0 && change < another_scene && change * another_scene > 1) {
            --frames_left_;
            return false;
        }
        frames_left_ = interval - 1;
        primitives_ = primitives;
        return true;
    }

    /// Looks: `measure(plan)` gives the PlannedMethod of a plan. Returns what was seen, with the new choice picked.
    template <class Measure> FramePlan look(const Measure& measure, bool at_everything = false) {
        FramePlan seen;
        std::optional<size_t> best;
        if (methods_.grid)
            best = climb(seen, measure, grid_plan(1), grid_start_, 2, at_everything, 0);
        if (methods_.cloud) {
            const double bound = best ? out_of_reach * seen.methods[*best].cost.total() : infinity<double>;
            const size_t cloud = climb(seen, measure, cloud_plan(1), cloud_start_, 4, at_everything, bound);
            if (!best || cost_of(seen, cloud) < cost_of(seen, *best))
                best = cloud;
        }
        const auto present = std::find_if(seen.methods.begin(), seen.methods.end(),
                                          [&](const PlannedMethod& m) { return chosen_ && m.plan == *chosen_; });
        if (present != seen.methods.end() && !(cost_of(seen, *best) < clearly * present->cost.total()))
            best = size_t(present - seen.methods.begin());
        seen.picked = *best;
        chosen_ = seen.methods[*best].plan;
        return seen;
    }

    /// Voxels a primitive that are looked at.
    static constexpr double coarsest_grid = 0.5, finest_grid = 32, coarsest_cloud = 2, finest_cloud = 2048;

private:
    static double cost_of(const FramePlan& seen, size_t place) { return seen.methods[place].cost.total(); }

    /// From `start` on, finer as long as that is cheaper, else coarser. Returns the place of the cheapest, which the
    /// next climb starts from.
    template <class Measure>
    size_t climb(FramePlan& seen, const Measure& measure, GridPlan plan, double& start, double step, bool at_everything,
                 double bound) {
        const auto look_at = [&](double density) {
            plan.voxels_per_primitive = density;
            seen.methods.push_back(measure(plan));
            return seen.methods.size() - 1;
        };
        const double coarsest = plan.has_cloud() ? coarsest_cloud : coarsest_grid;
        const double finest = plan.has_cloud() ? finest_cloud : finest_grid;
        const size_t first = look_at(start);
        size_t best = first;
        if (!at_everything && bound > 0 && cost_of(seen, first) > bound)
            return first;
        for (const double way : {step, 1 / step}) {
            for (double density = start * way; density >= coarsest && density <= finest; density *= way) {
                const size_t next = look_at(density);
                const bool is_better = cost_of(seen, next) < cost_of(seen, best);
                if (is_better)
                    best = next;
                else if (!at_everything)
                    break;
            }
            if (best != first && !at_everything)
                break;
        }
        start = seen.methods[best].plan.voxels_per_primitive;
        return best;
    }

    Methods methods_;
    std::optional<GridPlan> chosen_;
    double grid_start_ = first_grid, cloud_start_ = first_cloud;
    uint32_t frames_left_ = 0;
    uint32_t primitives_ = 0; ///< when it was looked last
};

} // namespace proxima
