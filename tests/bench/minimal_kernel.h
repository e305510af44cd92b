// SPDX-License-Identifier: Apache-2.0
// The least that draws opaque spheres: a camera ray, a walk through a grid, Lambert's law and a shadow ray for one
// point light. Nothing is robust, no tie is broken, and there is one material: what it takes is what the renderer's
// kernels for plain scenes are held against. The walk is Amanatides and Woo's ("A Fast Voxel Traversal Algorithm for
// Ray Tracing", 1987).
#pragma once
#include "kernels/camera.h"
#include "kernels/film.h"

#include <span>

namespace proxima::bench {

struct MinimalScene {
    std::span<const Sphere<float>> spheres;
    std::span<const uint32_t> starts; ///< of each voxel's list in `ids`, and the end of the last
    std::span<const uint32_t> ids;
    Box<float> bounds;
    glm::vec3 voxel{1.0f}; ///< a voxel's sides
    glm::ivec3 size{1};    ///< voxels along the axes
    Camera<float> camera;
    glm::vec3 light{0.0f};
    glm::vec3 ambient{0.0f}; ///< of the one material, times its colour
    glm::vec3 diffuse{0.0f}; ///< times its colour and the light's
    glm::vec3 background{0.0f};
};

struct MinimalHit {
    float t = infinity<float>;
    uint32_t sphere = 0xffffffffu;
};

/// The nearest hit in front of `farthest`; with `any` the first that is found.
template <bool any> HD MinimalHit minimal_walk(const MinimalScene& scene, const Ray<float>& ray, float farthest) {
    const glm::vec3 inverse = 1.0f / ray.direction;
    const glm::vec3 to_lower = (scene.bounds.lower - ray.origin) * inverse;
    const glm::vec3 to_upper = (scene.bounds.upper - ray.origin) * inverse;
    const glm::vec3 near = glm::min(to_lower, to_upper), far = glm::max(to_lower, to_upper);
    const float enter = larger(larger(near.x, near.y), larger(near.z, 0.0f));
    const float exit = smaller(smaller(far.x, far.y), smaller(far.z, farthest));
    MinimalHit best{farthest, 0xffffffffu};
    if (enter > exit)
        return best;
    const glm::vec3 place = (ray.origin + enter * ray.direction - scene.bounds.lower) / scene.voxel;
    int cell[3], step[3];
    float next[3], delta[3];
    for (int i = 0; i < 3; ++i) {
        cell[i] = int(place[i]);
        cell[i] = cell[i] < 0 ? 0 : cell[i] >= scene.size[i] ? scene.size[i] - 1 : cell[i];
        const bool forward = ray.direction[i] > 0;
        step[i] = forward ? 1 : -1;
        delta[i] = magnitude(scene.voxel[i] * inverse[i]);
        const float plane = scene.bounds.lower[i] + float(cell[i] + (forward ? 1 : 0)) * scene.voxel[i];
        next[i] = ray.direction[i] != 0 ? (plane - ray.origin[i]) * inverse[i] : infinity<float>;
    }
    for (;;) {
        const uint32_t index = uint32_t((cell[2] * scene.size.y + cell[1]) * scene.size.x + cell[0]);
        for (uint32_t i = scene.starts[index]; i < scene.starts[index + 1]; ++i) {
            const uint32_t id = scene.ids[i];
            const Sphere<float> sphere = scene.spheres[id];
            const glm::vec3 offset = sphere.center - ray.origin;
            const float along = glm::dot(offset, ray.direction);
            const glm::vec3 across = offset - along * ray.direction;
            const float half2 = sphere.radius * sphere.radius - glm::dot(across, across);
            if (half2 <= 0)
                continue;
            const float t = along - square_root(half2);
            if (t > 0 && t < best.t) {
                best = {t, id};
                if (any)
                    return best;
            }
        }
        const int axis = next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
        if (best.t <= next[axis] || next[axis] > exit)
            return best;
        cell[axis] += step[axis];
        if (cell[axis] < 0 || cell[axis] >= scene.size[axis])
            return best;
        next[axis] += delta[axis];
    }
}

/// Pixel -> its light, in the renderer's order of pixels.
struct MinimalPixel {
    static constexpr uint32_t blocks_together = 12;

    MinimalScene scene;
    std::span<glm::vec3> pixels;
    uint32_t width = 0, height = 0;

    HD void operator()(uint32_t index) const {
        const PixelPosition pixel = tiled_pixel(index, width);
        if (pixel.x >= width || pixel.y >= height)
            return;
        const Ray<float> ray = camera_ray(scene.camera, (float(pixel.x) + 0.5f) / float(width) - 0.5f,
                                          0.5f - (float(pixel.y) + 0.5f) / float(height));
        const MinimalHit hit = minimal_walk<false>(scene, ray, infinity<float>);
        pixels[size_t(pixel.y) * width + pixel.x] = hit.sphere == 0xffffffffu ? scene.background : shade(ray, hit);
    }

private:
    HD glm::vec3 shade(const Ray<float>& ray, const MinimalHit& hit) const {
        const Sphere<float> sphere = scene.spheres[hit.sphere];
        const glm::vec3 normal = glm::normalize(ray.origin + hit.t * ray.direction - sphere.center);
        const glm::vec3 point = sphere.center + (sphere.radius * 1.0001f) * normal;
        const glm::vec3 way = scene.light - point;
        const float distance = glm::length(way);
        const glm::vec3 to_light = way / distance;
        const float cosine = glm::dot(normal, to_light);
        if (cosine <= 0 || minimal_walk<true>(scene, {point, to_light}, distance).sphere != 0xffffffffu)
            return scene.ambient;
        return scene.ambient + cosine * scene.diffuse;
    }
};

} // namespace proxima::bench
