// SPDX-License-Identifier: Apache-2.0
// What a frame's work takes on a kind of device, by grid and by cloud. Counts in, milliseconds out.
#pragma once
#include "renderer/method_record.h"

#include <cmath>

namespace proxima {

/// What a frame does by one method.
struct MethodWork {
    double primitives = 0;
    double references = 0; ///< entries in all voxels' lists
    double voxels = 0;     ///< that there is memory of: a cloud's are those of its occupied bricks
    double bricks = 0;     ///< of the cloud
    double rays = 0;       ///< of the camera
    double lookups = 0;    ///< voxels or bricks that one of them looks up, in the mean
};

/// Milliseconds a frame, and nanoseconds for each unit of work.
struct MethodCosts {
    double build_ms = 0, primitive = 0, reference = 0, voxel = 0;
    double map_ms = 0, brick = 0;
    double ray = 0, lookup = 0;
    double shared = 0; ///< rays to a voxel's face at which a lookup takes half: packets share them; 0: nothing does

    constexpr double build(const MethodWork& work) const {
        return build_ms + 1e-6 * (primitive * work.primitives + reference * work.references + voxel * work.voxels);
    }
    constexpr double map(const MethodWork& work) const { return map_ms + 1e-6 * brick * work.bricks; }
    double trace(const MethodWork& work) const {
        const double together = shared > 0 ? work.rays / std::pow(work.voxels, 2.0 / 3) / shared : 0;
        return 1e-6 * work.rays * (ray + lookup * work.lookups / (1 + together));
    }
    double frame(const MethodWork& work) const { return build(work) + map(work) + trace(work); }
};

/// Those of a kind of device, see device_costs.h.
struct DeviceCosts {
    OfMethods<MethodCosts> of;
    uint32_t fewest = 0; ///< primitives below which a cloud is not thought of: what there is to gain is noise
};

} // namespace proxima
