// SPDX-License-Identifier: Apache-2.0
// The CUDA devices of this host. A host without a driver has none, and that is no error.
#include "renderer/frame_renderer.h"

#include <cuda_runtime_api.h>

namespace proxima {

std::vector<DeviceDescription> list_cuda_devices(std::string& reason) {
    int count = 0;
    const cudaError_t error = cudaGetDeviceCount(&count);
    if (error == cudaErrorInsufficientDriver)
        reason = "this host has no NVIDIA driver, or one older than CUDA " + std::to_string(CUDART_VERSION / 1000) +
                 " needs";
    else if (error != cudaSuccess)
        reason = cudaGetErrorString(error);
    else if (count == 0)
        reason = "this host has no CUDA device";
    std::vector<DeviceDescription> devices;
    for (int i = 0; error == cudaSuccess && i < count; ++i) {
        cudaDeviceProp properties;
        if (cudaGetDeviceProperties(&properties, i) != cudaSuccess)
            continue;
        devices.push_back({"cuda:" + std::to_string(i), properties.name, properties.totalGlobalMem,
                           "compute capability " + std::to_string(properties.major) + "." +
                               std::to_string(properties.minor) + ", " +
                               std::to_string(properties.multiProcessorCount) + " multiprocessors"});
    }
    cudaGetLastError();
    return devices;
}

} // namespace proxima
