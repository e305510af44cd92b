// SPDX-License-Identifier: Apache-2.0
// What a frame's grid is to be like: how fine, and whether there is a cloud over it.
#pragma once
#include "kernels/cloud.h"
#include "renderer/grid_resolution.h"

namespace proxima {

struct GridPlan {
    std::array<uint32_t, 3> size{0, 0, 0}; ///< voxels along each axis; 0: by voxels_per_primitive
    double voxels_per_primitive = GridRule{}.voxels_per_primitive;
    uint32_t brick = 0; ///< voxels along a brick of the cloud, a power of two; 0: no cloud
    Metric metric = Metric::chessboard;

    bool has_cloud() const { return brick > 0; }
    friend bool operator==(const GridPlan&, const GridPlan&) = default;
};

} // namespace proxima
