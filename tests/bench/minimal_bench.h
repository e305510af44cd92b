// SPDX-License-Identifier: Apache-2.0
// A scene of opaque spheres of one colour under one light in, milliseconds of the minimal kernel out; one template for
// both backends.
#pragma once
#include "parser/scene_program.h"
#include "tests/bench/minimal_kernel.h"

#include <chrono>
#include <vector>

namespace proxima::bench {

struct MinimalRun {
    std::vector<double> ms; ///< of each repeat
    std::vector<glm::vec3> pixels;
};

/// The grid of a minimal scene, on the host.
struct MinimalGrid {
    std::vector<Sphere<float>> spheres; ///< in the renderer's order
    std::vector<uint32_t> starts, ids;
    MinimalScene scene; ///< but for the arrays
};

/// With as many voxels as the renderer chooses. The scene must have spheres only, all of one material, and one plain
/// light; of the material the first layer counts.
MinimalGrid make_minimal_grid(const SceneProgram& scene);

template <class Backend>
MinimalRun run_minimal(Backend& backend, const MinimalGrid& grid, uint32_t width, uint32_t height, uint32_t repeats) {
    typename Backend::template Buffer<Sphere<float>> spheres(backend);
    typename Backend::template Buffer<uint32_t> starts(backend), ids(backend);
    typename Backend::template Buffer<glm::vec3> pixels(backend);
    spheres.upload(grid.spheres.size(), [&](size_t i) { return grid.spheres[i]; });
    starts.upload(grid.starts.size(), [&](size_t i) { return grid.starts[i]; });
    ids.upload(grid.ids.size(), [&](size_t i) { return grid.ids[i]; });
    pixels.resize(size_t(width) * height);
    MinimalScene scene = grid.scene;
    scene.spheres = spheres.view();
    scene.starts = starts.view();
    scene.ids = ids.view();
    const MinimalPixel kernel{scene, pixels.view(), width, height};
    const uint32_t count = uint32_t(tiled_pixel_count(width, height));
    MinimalRun run;
    for (uint32_t repeat = 0; repeat <= repeats; ++repeat) {
        const auto begin = std::chrono::steady_clock::now();
        backend.for_each(count, kernel);
        backend.synchronize();
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
        if (repeat > 0) // the first one warms up
            run.ms.push_back(taken.count());
    }
    run.pixels.resize(size_t(width) * height);
    pixels.download(run.pixels.data());
    return run;
}

MinimalRun run_minimal_on_cpu(const MinimalGrid& grid, uint32_t width, uint32_t height, uint32_t repeats);
/// On the first GPU; throws DeviceError without one, or in a build without CUDA.
MinimalRun run_minimal_on_cuda(const MinimalGrid& grid, uint32_t width, uint32_t height, uint32_t repeats);

} // namespace proxima::bench
