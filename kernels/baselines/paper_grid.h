// SPDX-License-Identifier: Apache-2.0
// A baseline for experiments, not the renderer's grid: voxels with lists of a fixed length, as R. Thomas and S. K.
// Semwal have them ("Ray Tracing using 3D Grid Simulations", 2014). A voxel is a struct of whether it holds something,
// an array of sphere numbers that -1 ends, and its position; one thread a column empties them, one a sphere fills them.
#pragma once
#include "kernels/scene_view.h"

namespace proxima::baselines {

/// Voxels one behind the other, each of 1 + capacity + 3 words: filled or not, the list, and x, y, z.
struct PaperGridView {
    static constexpr uint32_t no_sphere = 0xffffffffu; ///< -1 where a list has ended

    GridView<float> grid; ///< where the voxels lie; its own lists are not used. With its cloud once that is made
    std::span<uint32_t> words;
    uint32_t capacity = 1; ///< spheres a voxel

    HD uint32_t stride() const { return capacity + 4; }
    HD uint32_t* voxel(uint32_t index) const { return words.data() + size_t(index) * stride(); }
    HD bool is_filled(uint32_t index) const { return voxel(index)[0] != 0; }
    HD const uint32_t* list(uint32_t index) const { return voxel(index) + 1; }
    HD Vec3<int32_t> position(uint32_t index) const {
        const uint32_t* at = voxel(index) + 1 + capacity;
        return {int32_t(at[0]), int32_t(at[1]), int32_t(at[2])};
    }
};

/// Column (x, y) -> its voxels are empty.
struct ClearPaperVoxels {
    PaperGridView paper;

    HD void operator()(uint32_t column) const {
        const Vec3<int32_t> size = paper.grid.size;
        const uint32_t x = column % uint32_t(size.x), y = column / uint32_t(size.x);
        for (uint32_t z = 0; z < uint32_t(size.z); ++z) {
            uint32_t* words = paper.voxel(paper.grid.index(int32_t(x), int32_t(y), int32_t(z)));
            *words++ = 0;
            for (uint32_t k = 0; k < paper.capacity; ++k)
                *words++ = PaperGridView::no_sphere;
            words[0] = x, words[1] = y, words[2] = z;
        }
    }
};

/// Sphere -> it is listed in every voxel that its bounding box overlaps.
struct FillPaperVoxels {
    PaperGridView paper;
    GeometryView<float> geometry;
    std::span<uint32_t> overflows; ///< one counter: lists that were full

    HD void operator()(uint32_t id) const {
        const float radius = geometry.radius(id);
        if (!(radius > 0) || radius > geometry.large_radius)
            return;
        for_each_cell(paper.grid, geometry.box(id), [&](int32_t x, int32_t y, int32_t z) {
            uint32_t* words = paper.voxel(paper.grid.index(x, y, z));
            store_relaxed(words, 1u);
            for (uint32_t k = 0; k < paper.capacity; ++k)
                if (atomic_compare_exchange(words + 1 + k, PaperGridView::no_sphere, id) == PaperGridView::no_sphere)
                    return;
            atomic_add(overflows.data(), 1);
        });
    }
};

} // namespace proxima::baselines
