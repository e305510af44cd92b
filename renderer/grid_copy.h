// SPDX-License-Identifier: Apache-2.0
// A grid that another device has built: its arrays are copied from there, and a scene on this device gets them.
#pragma once
#include "kernels/scene_view.h"

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>

namespace proxima {

template <class Backend> class GridCopy {
public:
    explicit GridCopy(Backend& backend)
        : arrays_{Buffer(backend), Buffer(backend), Buffer(backend), Buffer(backend),
                  Buffer(backend), Buffer(backend), Buffer(backend)} {}

    /// `built` is the same scene on `other`, with its grid.
    template <class Real> void take(SceneView<Real>& scene, const SceneView<Real>& built, Backend& other) {
        scene.geometry.large_radius = built.geometry.large_radius;
        scene.geometry.bounds = built.geometry.bounds;
        scene.geometry.slack = built.geometry.slack;
        scene.geometry.large = built.geometry.large;
        scene.grid = built.grid;
        scene.outskirts = built.outskirts;
        copy(0, scene.geometry.large, other);
        copy(1, scene.grid.heads, other);
        copy(2, scene.grid.links, other);
        copy(3, scene.grid.cloud.distances, other);
        copy(4, scene.grid.cloud.ranks, other);
        copy(5, scene.outskirts.heads, other);
        copy(6, scene.outskirts.links, other);
    }

private:
    using Buffer = typename Backend::template Buffer<std::byte>;

    template <class T> void copy(size_t place, std::span<T>& array, Backend& other) {
        arrays_[place].copy_from(other, std::as_bytes(array));
        array = {reinterpret_cast<T*>(arrays_[place].view().data()), array.size()};
    }

    std::array<Buffer, 7> arrays_;
};

} // namespace proxima
