// SPDX-License-Identifier: Apache-2.0
// How many voxels a frame's grid has along each axis.
#pragma once
#include "kernels/vector_math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace proxima {

struct GridRule {
    /// The lambda of Cleary and Wyvill, "Analysis of an Algorithm for Fast Ray Tracing", 1988. Building and tracing a
    /// million spheres together take least at 2, on the CPU and on an H100.
    double voxels_per_primitive = 2;
    int32_t longest = 4096; ///< voxels along an axis at most: past it a walk's rounding outgrows a voxel's margin
    uint64_t most_voxels = 1ull << 31;
    double smallest_voxel = 0; ///< edge length: voxels are no finer along any axis
};

/// Voxels as close to cubes as they come, voxels_per_primitive * count of them. An axis along which the bounds are
/// thinner than a voxel gets one voxel, and the others share the number.
inline std::array<uint32_t, 3> grid_resolution(const std::array<double, 3>& extent, uint64_t count,
                                               const GridRule& rule) {
    const double wanted = std::min(double(count) * rule.voxels_per_primitive, double(rule.most_voxels));
    const double unit = std::max({extent[0], extent[1], extent[2]}); // a product of three extents may vanish
    if (!(unit > 0))
        return {1, 1, 1};
    std::array<bool, 3> thin{};
    double per_length = 0;
    for (bool settled = false; !settled;) {
        double volume = 1;
        int axes = 0;
        for (int i = 0; i < 3; ++i)
            if (!thin[i]) {
                volume *= extent[i] / unit;
                ++axes;
            }
        if (axes == 0)
            break;
        per_length = std::pow(wanted / volume, 1.0 / axes);
        settled = true;
        for (int i = 0; i < 3; ++i)
            if (!thin[i] && !(extent[i] / unit * per_length >= 1)) {
                thin[i] = true;
                settled = false;
            }
    }
    const auto finest = [&](double length) {
        const double most = rule.smallest_voxel > 0 ? length / rule.smallest_voxel : infinity<double>;
        return std::clamp(std::floor(most), 1.0, double(rule.longest));
    };
    std::array<uint32_t, 3> size{1, 1, 1};
    for (int i = 0; i < 3; ++i)
        if (!thin[i])
            size[i] = uint32_t(std::clamp(std::round(extent[i] / unit * per_length), 1.0, finest(extent[i])));
    return size;
}

} // namespace proxima
