// SPDX-License-Identifier: Apache-2.0
// The seed paper's frames on a GPU.
#include "renderer/backend_cuda.cuh"
#include "renderer/bench/paper_renderer.h"
#include "renderer/bench/paper_renderers.h"

namespace proxima::baselines {

std::unique_ptr<FrameRenderer> make_paper_cuda_renderer(int ordinal) {
    return std::make_unique<PaperRenderer<CudaBackend>>(ordinal);
}

} // namespace proxima::baselines
