// SPDX-License-Identifier: Apache-2.0
// Stands in for the CUDA backend in a build without it.
#include "renderer/bench/paper_renderers.h"
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"

namespace proxima {

std::unique_ptr<FrameRenderer> make_cuda_renderer(int, std::shared_ptr<MethodChoice>) {
    throw DeviceError(DeviceError::Kind::unavailable, "this program was built without CUDA");
}

std::unique_ptr<FrameRenderer> baselines::make_paper_cuda_renderer(int ordinal) {
    return make_cuda_renderer(ordinal);
}

std::vector<DeviceDescription> list_cuda_devices(std::string& reason) {
    reason = "this program was built without CUDA";
    return {};
}

} // namespace proxima
