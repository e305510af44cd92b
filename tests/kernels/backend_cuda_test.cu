// SPDX-License-Identifier: Apache-2.0
#include "renderer/backend_cuda.cuh"
#define BACKENDS CudaBackend
#include "tests/kernels/backend_tests.h"
#include "tests/kernels/motion_backend_tests.h"

#include "tests/kernels/aov_backend_tests.h"
#include "tests/kernels/baseline_backend_tests.h"

template <> std::unique_ptr<FrameRenderer> proxima::test::make_renderer<CudaBackend>() {
    return make_cuda_renderer(0);
}
