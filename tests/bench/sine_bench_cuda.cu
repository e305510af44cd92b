// SPDX-License-Identifier: Apache-2.0
#include "renderer/backend_cuda.cuh"
#include "tests/bench/portable_sine.h"

namespace proxima::bench {

std::vector<double> measure_cuda_sines() {
    int devices = 0;
    if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0)
        return {};
    CudaBackend backend(0);
    backend.activate();
    return measure_sines(backend);
}

} // namespace proxima::bench
