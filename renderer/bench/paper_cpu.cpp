// SPDX-License-Identifier: Apache-2.0
// The seed paper's frames on the host's cores.
#include "renderer/backend_cpu.h"
#include "renderer/bench/paper_renderer.h"
#include "renderer/bench/paper_renderers.h"

namespace proxima::baselines {

std::unique_ptr<FrameRenderer> make_paper_cpu_renderer(unsigned threads) {
    return std::make_unique<PaperRenderer<CpuBackend>>(threads);
}

} // namespace proxima::baselines
