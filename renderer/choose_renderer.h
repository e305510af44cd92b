// SPDX-License-Identifier: Apache-2.0
// The --device option in, the device that renders out.
#pragma once
#include "renderer/frame_renderer.h"
#include "renderer/options.h"

#include <memory>

namespace proxima {

/// A CUDA device when one is asked for, or may be chosen and is there; else the CPU with `threads` threads (0: all).
/// Throws UsageError when the device that was asked for is not there, DeviceError when it fails.
std::unique_ptr<FrameRenderer> choose_renderer(const DeviceChoice& choice, unsigned threads);

} // namespace proxima
