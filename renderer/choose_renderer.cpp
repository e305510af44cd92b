// SPDX-License-Identifier: Apache-2.0
#include "renderer/choose_renderer.h"
#include "renderer/device_error.h"
#include "renderer/errors.h"

#include <fmt/format.h>

namespace proxima {

std::unique_ptr<FrameRenderer> choose_renderer(const DeviceChoice& choice, unsigned threads) {
    if (choice.kind == DeviceChoice::Kind::cpu)
        return make_cpu_renderer(threads);
    std::string reason;
    if (choice.kind == DeviceChoice::Kind::automatic && list_cuda_devices(reason).empty())
        return make_cpu_renderer(threads);
    try {
        return make_cuda_renderer(choice.ordinal);
    } catch (const DeviceError& error) {
        if (error.kind != DeviceError::Kind::unavailable)
            throw;
        if (choice.kind == DeviceChoice::Kind::automatic)
            return make_cpu_renderer(threads);
        throw UsageError(
            fmt::format("--device cuda:{}: {}; `proxima devices` lists what there is, and --device cpu always "
                        "works",
                        choice.ordinal, error.what()));
    }
}

} // namespace proxima
