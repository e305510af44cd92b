// SPDX-License-Identifier: Apache-2.0
#include "renderer/method_plan.h"
#include "kernels/grid.h"
#include "renderer/device_costs.h"
#include "renderer/method_choice.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>

namespace proxima {
namespace {

constexpr uint32_t pilot_width = 256;

/// A frame by one method as it was made, of a small picture; what its rays would take of a whole one is reckoned.
struct Pilot {
    FrameStatistics made;
    MethodWork work;

    double frame_ms(const MethodCosts& costs) const { return made.build_ms + made.cloud_ms + costs.trace(work); }
};

class Pilots {
public:
    Pilots(const FrameScenes& scenes, const FrameSettings& settings, const ChosenDevice& device)
        : renderer_(device.make()), whole_(settings), small_(settings) {
        if (!scenes.moments.empty())
            moments_ = {scenes.moments[scenes.moments.size() / 2]};
        whole_.precision = small_.precision = chosen_precision(settings.precision, scenes.fit.holds());
        small_.width = std::min(settings.width, pilot_width);
        small_.height = std::max(1u, uint32_t(uint64_t(settings.height) * small_.width / settings.width));
        small_.aovs.steps = true;
        renderer_->set_scene(*scenes.programs[scenes.programs.size() / 2], small_.precision);
    }

    /// A frame as it would be if nothing were asked for: it looks.
    FrameStatistics free() {
        FrameSettings settings = small_;
        settings.accelerator = Accelerator::automatic;
        settings.grid = {};
        return render(settings);
    }

    Pilot by(SearchMethod method, const EmptySpace& space) {
        FrameSettings settings = small_;
        settings.accelerator = method == SearchMethod::cloud ? Accelerator::cloud : Accelerator::grid;
        render(settings); // makes room
        Pilot pilot{render(settings), {}};
        double lookups = 0;
        for (const AovSample& sample : image_.aovs)
            lookups += sample.steps;
        const auto& [x, y, z] = pilot.made.grid;
        pilot.work = {.primitives = double(space.primitives),
                      .references = double(pilot.made.references),
                      .voxels =
                          method == SearchMethod::cloud ? 64.0 * double(space.bricks - space.empty) : double(x) * y * z,
                      .bricks = method == SearchMethod::cloud ? double(space.bricks) : 0,
                      .rays = MethodChoice::rays_of(whole_),
                      .lookups = lookups / double(image_.aovs.size())};
        return pilot;
    }

private:
    FrameStatistics render(const FrameSettings& settings) { return renderer_->render(settings, moments_, image_); }

    std::unique_ptr<FrameRenderer> renderer_;
    FrameSettings whole_, small_;
    std::vector<MotionTime> moments_;
    Image image_;
};

/// To four digits.
double rounded(double value) {
    return std::stod(fmt::format("{:.4g}", value));
}

/// Of voxels' heads, of lists, and of a cloud's ranks and two maps.
uint64_t bytes(const MethodWork& work) {
    return uint64_t(work.voxels * sizeof(uint32_t) + work.references * sizeof(GridLink) +
                    work.bricks * (sizeof(uint32_t) + 2));
}

/// "grid", "cloud" or "brute": what is picked for a first frame. `frame` was left to the choice and came out as `made`.
std::string pick(const FrameSettings& settings, const MethodChoice::Frame& frame, const FrameStatistics& made) {
    switch (settings.accelerator) {
    case Accelerator::grid:
        return "grid";
    case Accelerator::cloud:
        return "cloud";
    case Accelerator::brute:
        return "brute";
    case Accelerator::automatic:
        break;
    }
    if (made.method == "brute")
        return "brute";
    return settings.grid[0] == 0 && frame.method == SearchMethod::cloud ? "cloud" : "grid";
}

std::string decision(const FrameSettings& settings, const MethodRecord& record, const std::string& picked) {
    if (settings.accelerator != Accelerator::automatic || settings.grid[0] != 0)
        return picked + ": as asked for";
    if (picked == "brute")
        return "brute: so few are tested one by one";
    if (record.reason == MethodReason::few)
        return "grid: with so few there is nothing to gain by a cloud";
    const double ratio = record.predicted.cloud / record.predicted.grid;
    const std::string reason =
        fmt::format("{}: a look predicts that the cloud takes {:.2f} times as long as the grid", picked, ratio);
    return std::max(ratio, 1 / ratio) > MethodChoice::clear
               ? reason
               : reason + "; that is close, so animations try both and go by their times";
}

} // namespace

PlanSection method_plan(const FrameScenes& scenes, const FrameSettings& settings, const ChosenDevice& device) {
    const DeviceCosts& costs = device.is_gpu ? cuda_costs : cpu_costs;
    Pilots pilots(scenes, settings, device);
    const FrameStatistics made = pilots.free();
    const EmptySpace space = made.choice.space;
    MethodChoice::Frame frame; // of the whole picture
    MethodChoice(costs).decide_alone(frame, settings, space);
    const std::string picked = pick(settings, frame, made);
    PlanSection section{.name = "method", .decision = decision(settings, frame.record, picked), .values = {}};
    const auto add = [&](const std::string& name, PlanSection::Value value) {
        section.values.emplace_back(name, std::move(value));
    };
    add("device", device.name);
    add("picked", picked);
    if (space.bricks > 0) {
        add("occupied_bricks", rounded(space.occupied()));
        add("mean_distance", rounded(space.mean_distance));
        add("grid_predicted_ms", rounded(frame.record.predicted.grid));
        add("cloud_predicted_ms", rounded(frame.record.predicted.cloud));
    }
    if (made.method == "brute")
        return section;
    for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud}) {
        const Pilot pilot = pilots.by(method, space);
        const std::string name = method == SearchMethod::cloud ? "cloud_" : "grid_";
        const auto& [x, y, z] = pilot.made.grid;
        add(name + "voxels", fmt::format("{}x{}x{}", x, y, z));
        add(name + "references", pilot.made.references);
        add(name + "bytes", bytes(pilot.work));
        add(name + "lookups_a_ray", rounded(pilot.work.lookups));
        add(name + "build_ms", rounded(pilot.made.build_ms));
        if (method == SearchMethod::cloud)
            add(name + "map_ms", rounded(pilot.made.cloud_ms));
        add(name + "trace_ms", rounded(costs.of[method].trace(pilot.work)));
        add(name + "frame_ms", rounded(pilot.frame_ms(costs.of[method])));
    }
    return section;
}

} // namespace proxima
