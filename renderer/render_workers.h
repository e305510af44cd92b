// SPDX-License-Identifier: Apache-2.0
// The devices of a run in, the workers that share its frames out.
#pragma once
#include "renderer/choose_devices.h"
#include "renderer/frame_scheduler.h"
#include "renderer/options.h"

#include <cstdint>
#include <vector>

namespace proxima {

struct WorkPlan {
    std::vector<RenderWorker> workers; ///< one of each device, then a second one of each, and so on
    size_t devices = 1;
    std::vector<Rows> bands{Rows{}}; ///< of every frame
};

/// Plans the work on `frames` frames. Throws UsageError when the devices cannot work together as `options` say.
WorkPlan plan_work(std::vector<StartedDevice> devices, const MultiGpuOptions& options, const FrameSettings& settings,
                   size_t frames);

} // namespace proxima
