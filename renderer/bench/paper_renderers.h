// SPDX-License-Identifier: Apache-2.0
// The devices that render as the seed paper does: see paper_renderer.h. For `proxima bench` alone.
#pragma once
#include "renderer/frame_renderer.h"

namespace proxima::baselines {

/// `threads` 0 is one for each core that the process may use.
std::unique_ptr<FrameRenderer> make_paper_cpu_renderer(unsigned threads);
/// Throws DeviceError when this build has no CUDA or the host has no such device.
std::unique_ptr<FrameRenderer> make_paper_cuda_renderer(int ordinal);

} // namespace proxima::baselines
