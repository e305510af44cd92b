// SPDX-License-Identifier: Apache-2.0
#include "renderer/backend_cpu.h"
#include "renderer/grid_resolution.h"
#include "renderer/spatial_order.h"
#include "tests/bench/minimal_bench.h"

#include <algorithm>
#include <glm/common.hpp>
#include <stdexcept>

namespace proxima::bench {
namespace {

void refuse_what_is_not_minimal(const SceneProgram& scene) {
    const auto is_other = [&](uint32_t material) { return material != scene.sphere_materials[0]; };
    if (scene.spheres.empty() || !scene.planes.empty() || !scene.ellipsoids.empty() || scene.lights.size() != 1 ||
        std::ranges::any_of(scene.sphere_materials, is_other))
        throw std::runtime_error("the scene must have spheres of one colour and one light, and nothing else");
}

/// Calls visit(voxel) for each voxel that the sphere touches.
template <class Visit> void for_each_voxel(const MinimalScene& grid, const Sphere<float>& sphere, const Visit& visit) {
    int low[3], high[3];
    for (int i = 0; i < 3; ++i) {
        const auto cell = [&](float x) {
            return std::clamp(int((x - grid.bounds.lower[i]) / grid.voxel[i]), 0, grid.size[i] - 1);
        };
        low[i] = cell(sphere.center[i] - sphere.radius);
        high[i] = cell(sphere.center[i] + sphere.radius);
    }
    const float reach2 = 1.002f * sphere.radius * sphere.radius;
    for (int z = low[2]; z <= high[2]; ++z)
        for (int y = low[1]; y <= high[1]; ++y)
            for (int x = low[0]; x <= high[0]; ++x) {
                const glm::vec3 corner = grid.bounds.lower + glm::vec3(x, y, z) * grid.voxel;
                const glm::vec3 gap = sphere.center - glm::clamp(sphere.center, corner, corner + grid.voxel);
                if (glm::dot(gap, gap) <= reach2)
                    visit(size_t((z * grid.size.y + y) * grid.size.x + x));
            }
}

void fill_lists(MinimalGrid& grid) {
    const size_t voxels = size_t(grid.scene.size.x) * size_t(grid.scene.size.y) * size_t(grid.scene.size.z);
    grid.starts.assign(voxels + 1, 0);
    for (const Sphere<float>& sphere : grid.spheres)
        for_each_voxel(grid.scene, sphere, [&](size_t voxel) { ++grid.starts[voxel + 1]; });
    for (size_t i = 0; i < voxels; ++i)
        grid.starts[i + 1] += grid.starts[i];
    grid.ids.resize(grid.starts.back());
    std::vector<uint32_t> places(grid.starts.begin(), grid.starts.end() - 1);
    for (uint32_t id = 0; id < grid.spheres.size(); ++id)
        for_each_voxel(grid.scene, grid.spheres[id], [&](size_t voxel) { grid.ids[places[voxel]++] = id; });
}

} // namespace

MinimalGrid make_minimal_grid(const SceneProgram& scene) {
    refuse_what_is_not_minimal(scene);
    MinimalGrid grid;
    const std::vector<uint32_t> order = spatial_order(scene);
    Box<float> bounds{glm::vec3(infinity<float>), glm::vec3(-infinity<float>)};
    for (size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere<double>& sphere = scene.spheres[order.empty() ? i : order[i]];
        const Sphere<float> single{glm::vec3(sphere.center), float(sphere.radius)};
        grid.spheres.push_back(single);
        bounds = joined(bounds, {single.center - single.radius, single.center + single.radius});
    }
    const glm::vec3 extent = bounds.upper - bounds.lower;
    const auto size = grid_resolution({extent.x, extent.y, extent.z}, scene.spheres.size(), {});
    const Layer& layer = scene.layers[scene.materials[scene.sphere_materials[0]].first_layer];
    const Pigment& pigment = scene.pigments[layer.pigment];
    const Finish& finish = scene.finishes[layer.finish];
    grid.scene.bounds = bounds;
    grid.scene.size = {size[0], size[1], size[2]};
    grid.scene.voxel = extent / glm::vec3(grid.scene.size);
    grid.scene.camera = camera_in<float>(scene.camera);
    grid.scene.light = glm::vec3(scene.lights[0].position);
    grid.scene.ambient = finish.ambient * scene.ambient_light * pigment.color.rgb;
    grid.scene.diffuse = finish.diffuse * pigment.color.rgb * scene.lights[0].color;
    grid.scene.background = scene.background;
    fill_lists(grid);
    return grid;
}

MinimalRun run_minimal_on_cpu(const MinimalGrid& grid, uint32_t width, uint32_t height, uint32_t repeats) {
    CpuBackend backend;
    return run_minimal(backend, grid, width, height, repeats);
}

} // namespace proxima::bench
