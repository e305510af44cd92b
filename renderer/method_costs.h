// SPDX-License-Identifier: Apache-2.0
// What a frame's work takes on a kind of device, by grid and by cloud. Counts in, milliseconds out.
#pragma once
#include <cstdint>

namespace proxima {

/// How rays find spheres, where there is a choice.
enum class SearchMethod : uint8_t { grid, cloud };

constexpr SearchMethod other_than(SearchMethod method) {
    return method == SearchMethod::grid ? SearchMethod::cloud : SearchMethod::grid;
}

/// A value of each method.
template <class T> struct OfMethods {
    T grid{}, cloud{};

    constexpr T& operator[](SearchMethod method) { return method == SearchMethod::grid ? grid : cloud; }
    constexpr const T& operator[](SearchMethod method) const { return method == SearchMethod::grid ? grid : cloud; }
};

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

    constexpr double build(const MethodWork& work) const {
        return build_ms + 1e-6 * (primitive * work.primitives + reference * work.references + voxel * work.voxels);
    }
    constexpr double map(const MethodWork& work) const { return map_ms + 1e-6 * brick * work.bricks; }
    constexpr double trace(const MethodWork& work) const { return 1e-6 * work.rays * (ray + lookup * work.lookups); }
    constexpr double frame(const MethodWork& work) const { return build(work) + map(work) + trace(work); }
};

/// Those of a kind of device, see device_costs.h.
struct DeviceCosts {
    OfMethods<MethodCosts> of;
    uint32_t fewest = 0; ///< primitives below which a cloud is not thought of: what there is to gain is noise
};

} // namespace proxima
