// SPDX-License-Identifier: Apache-2.0
#include "renderer/render_workers.h"
#include "renderer/errors.h"
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
    bool is_added = true;
    for (unsigned i = 1; is_added; ++i) {
        is_added = false;
        for (const StartedDevice& started : devices)
            if (i < in_flight(started.device, options) && workers.size() < tasks) {
                workers.push_back({started.device.name, nullptr, started.device.make});
                is_added = true;
            }
    }
    return workers;
}

/// The first device builds what the others trace: each worker has a tracer, and a builder of its own on the first one.
/// Two of them on every device, so that one frame is built while another is traced.
std::vector<RenderWorker> relay_workers(std::vector<StartedDevice> devices, const MultiGpuOptions& options) {
    const ChosenDevice builder = devices.front().device;
    if (devices.size() < 2)
        throw UsageError("--multi-gpu relay: one device builds for the others; give --device at least two");
    std::vector<RenderWorker> workers;
    for (auto tracer = devices.begin() + 1; tracer != devices.end(); ++tracer) {
        if (tracer->device.is_gpu != builder.is_gpu)
            throw UsageError(
                "--multi-gpu relay: a GPU and the CPU do not build for each other; give --device GPUs only");
        const auto make = [builder = builder.make, tracer = tracer->device.make] {
            std::unique_ptr<FrameRenderer> renderer = tracer();
            renderer->relay_from(builder());
            return renderer;
        };
        for (unsigned i = 0; i < std::max(2u, options.in_flight); ++i) {
            workers.push_back({tracer->device.name, nullptr, make});
            workers.back().builder = builder.name;
        }
    }
    return workers;
}

} // namespace

WorkPlan plan_work(std::vector<StartedDevice> devices, const MultiGpuOptions& options, const FrameSettings& settings,
                   size_t frames) {
    WorkPlan plan;
    plan.devices = devices.size();
    const uint64_t pixels = uint64_t(settings.width) * settings.height;
    const MultiGpu mode = choose_multi_gpu(options.mode, devices.size(), frames, pixels);
    if (mode == MultiGpu::relay) {
        plan.workers = relay_workers(std::move(devices), options);
        return plan;
    }
    if (mode == MultiGpu::tiles)
        plan.bands = options.tile_rows ? cut_into_bands(settings.band(), options.tile_rows)
                                       : cut_into_bands(settings.height, devices.size());
    plan.workers = workers_on(std::move(devices), options, frames * plan.bands.size());
    return plan;
}

} // namespace proxima
