// SPDX-License-Identifier: Apache-2.0
#include "renderer/device_error.h"
#include "tests/bench/minimal_bench.h"

namespace proxima::bench {

MinimalRun run_minimal_on_cuda(const MinimalGrid&, uint32_t, uint32_t, uint32_t) {
    throw DeviceError(DeviceError::Kind::unavailable, "this build has no CUDA");
}

} // namespace proxima::bench
