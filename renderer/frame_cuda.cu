// SPDX-License-Identifier: Apache-2.0
// The frame pipeline on a GPU.
#include "renderer/backend_cuda.cuh"
#include "renderer/pipeline_renderer.h"

namespace proxima {

std::unique_ptr<FrameRenderer> make_cuda_renderer(int ordinal, std::shared_ptr<MethodChoice> choice) {
    std::string reason;
    const size_t count = list_cuda_devices(reason).size();
    if (ordinal < 0 || size_t(ordinal) >= count)
        throw DeviceError(DeviceError::Kind::unavailable,
                          "there is no device cuda:" + std::to_string(ordinal) +
                              (count == 0 ? " (" + reason + ")" : "; the last is cuda:" + std::to_string(count - 1)));
    return std::make_unique<PipelineRenderer<CudaBackend>>(std::move(choice), ordinal);
}

} // namespace proxima
