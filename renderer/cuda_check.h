// SPDX-License-Identifier: Apache-2.0
// Turns CUDA's error codes into DeviceErrors.
#pragma once
#include "renderer/device_error.h"

#include <cuda_runtime_api.h>
#include <string>

namespace proxima {

inline void cuda_check(cudaError_t error) {
    if (error == cudaSuccess)
        return;
    cudaGetLastError(); // an error that is not sticky shall not be reported twice
    const std::string message = std::string("CUDA: ") + cudaGetErrorString(error);
    switch (error) {
    case cudaErrorMemoryAllocation:
        throw DeviceError(DeviceError::Kind::out_of_memory, message);
    case cudaErrorNoDevice:
    case cudaErrorInsufficientDriver:
    case cudaErrorInvalidDevice:
    case cudaErrorDevicesUnavailable:
    case cudaErrorNoKernelImageForDevice:
        throw DeviceError(DeviceError::Kind::unavailable, message);
    default:
        throw DeviceError(DeviceError::Kind::lost, message);
    }
}

} // namespace proxima
