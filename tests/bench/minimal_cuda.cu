// SPDX-License-Identifier: Apache-2.0
#include "renderer/backend_cuda.cuh"
#include "tests/bench/minimal_bench.h"

namespace proxima::bench {

MinimalRun run_minimal_on_cuda(const MinimalGrid& grid, uint32_t width, uint32_t height, uint32_t repeats) {
    CudaBackend backend(0);
    backend.activate();
    return run_minimal(backend, grid, width, height, repeats);
}

} // namespace proxima::bench
