// SPDX-License-Identifier: Apache-2.0
// Which grid or cloud the frames are made with: each method is looked at where it is cheapest, and the cheaper one is
// picked. What a way to render costs goes in; the choice comes out.
#pragma once
#include "renderer/frame_cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace proxima {

/// A look begins with where each method stood last and one resolution to either side, and goes on as long as the
/// cheapest is the finest or the coarsest that was seen: steps of 2 (grids) and 4 (clouds) voxels a primitive. It may be
/// spread over frames. It is made now and then only, less often as long as it changes nothing; and a choice is given
/// up for one that is clearly cheaper only. What frames really take corrects what was foretold of their method; the
/// other one is tried for a few frames, once, if it is in reach.
class PlanChooser {
public:
    static constexpr uint32_t interval = 64, longest_interval = 512; ///< frames from one look to the next
    static constexpr double clearly = 0.97;       ///< a cost over that of the present choice
    static constexpr double another_scene = 1.25; ///< times as many primitives, or as few
    static constexpr double out_of_reach = 1.5;   ///< a cloud that is not worth to be looked at in other resolutions
    static constexpr double first_grid = 2, first_cloud = 32; ///< voxels a primitive
    static constexpr uint32_t timed_frames = 3;               ///< whose fastest counts
    static constexpr double another_time = 1.5;               ///< times as long as then, or as short: time to look

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
        seen_ = {};
        is_looking_ = false;
        corrections_ = {};
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
        is_guess_ = true;
        interval_ = interval;
    }
    const GridPlan& choice() const { return *chosen_; }

    /// Whether nothing was looked at yet: the choice is a first guess.
    bool is_first_look() const { return chosen_ && is_guess_; }
    /// Once a frame: whether to look at something, because a look has not ended, or because it is time for another. A
    /// scene with many more or fewer primitives is another one.
    bool looks_on(uint32_t primitives) {
        if (is_looking_)
            return true;
        const double change = (double(primitives) + 1) / (double(primitives_) + 1);
        if (frames_left_ > 0 && change < another_scene && change * another_scene > 1) {
            --frames_left_;
            return false;
        }
        begin_look(primitives);
        return true;
    }

    /// A look begins; `at_everything`: at all resolutions.
    void begin_look(uint32_t primitives, bool at_everything = false) {
        is_looking_ = true;
        at_everything_ = at_everything;
        primitives_ = primitives;
        seen_ = {};
    }
    bool is_looking() const { return is_looking_; }
    /// What is to be looked at next, in any order, as far as can be told from what was seen; none: the look is over.
    std::vector<GridPlan> wanted() const {
        std::vector<GridPlan> plans;
        if (methods_.grid)
            climb(grid_plan(grid_start_), 2, coarsest_grid, finest_grid, plans);
        if (methods_.cloud && !is_out_of_reach())
            climb(cloud_plan(cloud_start_), 4, coarsest_cloud, finest_cloud, plans);
        return plans;
    }
    /// Those were seen.
    void see(const std::vector<PlannedMethod>& methods) {
        seen_.methods.insert(seen_.methods.end(), methods.begin(), methods.end());
    }
    /// Ends the look by a choice. Returns what was seen, with the new choice picked.
    FramePlan choose() {
        is_looking_ = false;
        const auto places = std::array{cheapest(false), cheapest(true)};
        size_t best = !places[1] || (places[0] && cost(*places[0]) <= cost(*places[1])) ? *places[0] : *places[1];
        for (size_t i = 0; i < seen_.methods.size(); ++i)
            if (chosen_ && seen_.methods[i].plan == *chosen_ && !(cost(best) < clearly * cost(i)))
                best = i;
        seen_.picked = best;
        for (const auto& place : places)
            if (place)
                (seen_.methods[*place].plan.has_cloud() ? cloud_start_ : grid_start_) =
                    seen_.methods[*place].plan.voxels_per_primitive;
        const bool is_as_before = !is_guess_ && chosen_ == seen_.methods[best].plan;
        interval_ = is_as_before ? std::min(2 * interval_, longest_interval) : interval;
        frames_left_ = interval_ - 1;
        take(best);
        is_guess_ = false;
        return seen_;
    }

    /// A frame was made by the present choice, and by nothing else, in so many milliseconds (build, map and trace).
    void time(double milliseconds) {
        if (is_looking_ || is_guess_ || !chosen_ || seen_.methods.empty())
            return;
        if (timed_ == timed_frames) {
            const bool is_off = milliseconds > another_time * fastest_ || milliseconds * another_time < fastest_;
            frames_off_ = is_off ? frames_off_ + 1 : 0;
            if (frames_off_ == timed_frames)
                frames_left_ = 0;
            return;
        }
        fastest_ = timed_ == 0 ? milliseconds : std::min(fastest_, milliseconds);
        if (++timed_ == timed_frames)
            reconsider();
    }
    /// By what is foretold of a method is multiplied. A method that was never timed is like the other.
    double correction(bool has_cloud) const {
        const auto &own = corrections_[has_cloud], &other = corrections_[!has_cloud];
        return own ? *own : other ? *other : 1.0;
    }

    /// Voxels a primitive that are looked at.
    static constexpr double coarsest_grid = 0.5, finest_grid = 32, coarsest_cloud = 2, finest_cloud = 2048;

private:
    double cost(size_t place) const {
        const PlannedMethod& method = seen_.methods[place];
        return method.cost.total() * correction(method.plan.has_cloud());
    }

    void take(size_t place) {
        chosen_ = seen_.methods[place].plan;
        taken_ = place;
        timed_ = frames_off_ = 0;
    }
    /// The present choice was timed: learns from that, and goes to the other method if that is cheaper or has yet to
    /// be timed.
    void reconsider() {
        const bool has_cloud = chosen_->has_cloud();
        corrections_[has_cloud] = fastest_ / seen_.methods[taken_].cost.total();
        const auto present = cheapest(has_cloud), other = cheapest(!has_cloud);
        if (!other)
            return;
        const bool is_unknown = !corrections_[!has_cloud];
        if (cost(*other) < (is_unknown ? out_of_reach : clearly) * cost(taken_))
            take(*other);
        else if (cost(*present) < clearly * cost(taken_))
            take(*present);
    }

    /// The place of the cheapest grid or cloud that was seen.
    std::optional<size_t> cheapest(bool has_cloud) const {
        std::optional<size_t> best;
        for (size_t i = 0; i < seen_.methods.size(); ++i)
            if (seen_.methods[i].plan.has_cloud() == has_cloud && (!best || cost(i) < cost(*best)))
                best = i;
        return best;
    }
    bool is_out_of_reach() const {
        const auto grid = cheapest(false), cloud = cheapest(true);
        return !at_everything_ && grid && cloud && cost(*cloud) > out_of_reach * cost(*grid);
    }

    /// Adds the plans like `start` that are to be looked at next.
    void climb(GridPlan start, double step, double coarsest, double finest, std::vector<GridPlan>& plans) const {
        const auto want = [&](double density) {
            GridPlan plan = start;
            plan.voxels_per_primitive = density;
            const bool is_seen = std::any_of(seen_.methods.begin(), seen_.methods.end(),
                                             [&](const PlannedMethod& method) { return method.plan == plan; });
            if (!is_seen && density >= coarsest && density <= finest)
                plans.push_back(plan);
        };
        if (at_everything_) {
            for (double density = coarsest; density <= finest; density *= step)
                want(density);
            return;
        }
        const auto best = cheapest(start.has_cloud());
        const double center = best ? seen_.methods[*best].plan.voxels_per_primitive : start.voxels_per_primitive;
        for (const double density : {center, center * step, center / step})
            want(density);
    }

    Methods methods_;
    std::optional<GridPlan> chosen_;
    double grid_start_ = first_grid, cloud_start_ = first_cloud;
    FramePlan seen_;   ///< in this look, or else the last one
    size_t taken_ = 0; ///< of what was seen
    std::array<std::optional<double>, 2> corrections_; ///< of grids and of clouds
    double fastest_ = 0;                               ///< of the frames that were timed, in milliseconds
    uint32_t timed_ = 0, frames_off_ = 0;
    bool is_guess_ = false, is_looking_ = false, at_everything_ = false;
    uint32_t interval_ = interval, frames_left_ = 0;
    uint32_t primitives_ = 0; ///< when it was looked last
};

} // namespace proxima
