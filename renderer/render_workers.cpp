// SPDX-License-Identifier: Apache-2.0
#include "renderer/render_workers.h"
#include "renderer/frame_assembly.h"

#include <algorithm>

namespace proxima {
namespace {

/// Two frames in flight on a GPU, one on the CPU, whose cores are busy with one.
unsigned in_flight(const ChosenDevice& device, const MultiGpuOptions& options) {
    if (options.in_flight > 0)
        return options.in_flight;
    return device.is_gpu ? 2 : 1;
}

std::vector<RenderWorker> workers_on(std::vector<StartedDevice> devices, const MultiGpuOptions& options, size_t tasks) {
    std::vector<RenderWorker> workers;
    for (StartedDevice& started : devices)
        workers.push_back({started.device.name, std::move(started.renderer), started.device.make});
    for (const StartedDevice& started : devices)
        for (unsigned i = 1; i < in_flight(started.device, options) && workers.size() < tasks; ++i)
            workers.push_back({started.device.name, nullptr, started.device.make});
    return workers;
}

} // namespace

WorkPlan plan_work(std::vector<StartedDevice> devices, const MultiGpuOptions& options, const FrameSettings& settings,
                   size_t frames) {
    WorkPlan plan;
    const uint64_t pixels = uint64_t(settings.width) * settings.height;
    if (choose_multi_gpu(options.mode, devices.size(), frames, pixels) == MultiGpu::tiles)
        plan.bands = options.tile_rows ? cut_into_bands(settings.band(), options.tile_rows)
                                       : cut_into_bands(settings.height, devices.size());
    plan.workers = workers_on(std::move(devices), options, frames * plan.bands.size());
    return plan;
}

} // namespace proxima
