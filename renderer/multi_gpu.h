// SPDX-License-Identifier: Apache-2.0
// The ways to use several devices on one run, and which of them suits it.
#pragma once
#include <cstddef>
#include <cstdint>

namespace proxima {

enum class MultiGpu {
    automatic,
    frames, ///< whole frames to devices: most frames an hour
    tiles,  ///< bands of one frame to devices, each of which builds the grid: the soonest frame
    relay,  ///< the first device builds the grids that the others trace
};

/// Frames for an animation, tiles where there are fewer frames than devices, or where two frames in flight on each
/// device would take more memory than pictures of 8K are worth.
inline MultiGpu choose_multi_gpu(MultiGpu asked, size_t devices, size_t frames, uint64_t pixels) {
    constexpr uint64_t large = 7680ull * 4320;
    if (asked != MultiGpu::automatic)
        return asked;
    return devices > 1 && (frames < devices || pixels >= large) ? MultiGpu::tiles : MultiGpu::frames;
}

} // namespace proxima
