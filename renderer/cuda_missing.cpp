// SPDX-License-Identifier: Apache-2.0
// Stands in for the CUDA backend in a build without it.
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"

namespace proxima {

std::unique_ptr<FrameRenderer> make_cuda_renderer(int) {
    throw DeviceError(DeviceError::Kind::unavailable, "this program was built without CUDA");
}

std::vector<DeviceDescription> list_cuda_devices(std::string& reason) {
    reason = "this program was built without CUDA";
    return {};
}

} // namespace proxima
