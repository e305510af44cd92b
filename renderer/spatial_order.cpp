// SPDX-License-Identifier: Apache-2.0
#include "renderer/spatial_order.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <utility>

namespace proxima {
namespace {

constexpr uint32_t side = 32; // buckets along an axis
constexpr uint32_t bucket_count = side * side * side + 1;

using Spheres = std::span<const Sphere<double>>;
using Range = tbb::blocked_range<size_t>;

/// The mean centre and the mean distance from it along each axis, robust enough against a far ground sphere: extremes
/// are only moved to the outer buckets.
struct Extent {
    Vec3<double> center{0.0};
    Vec3<double> reach{0.0};
};

Vec3<double> mean(Spheres spheres, const auto& value) {
    const Vec3<double> sum = tbb::parallel_deterministic_reduce(
        Range(0, spheres.size(), 1 << 14), Vec3<double>(0.0),
        [&](const Range& range, Vec3<double> part) {
            for (size_t i = range.begin(); i != range.end(); ++i)
                part += value(spheres[i].center);
            return part;
        },
        [](const Vec3<double>& a, const Vec3<double>& b) { return a + b; });
    return sum / double(spheres.size());
}

Extent extent_of(Spheres spheres) {
    Extent extent;
    extent.center = mean(spheres, [](const Vec3<double>& c) { return c; });
    extent.reach = mean(spheres, [&](const Vec3<double>& c) { return glm::abs(c - extent.center); });
    return extent;
}

/// Bucket 0 is for spheres around the camera, the others are a grid of the part of space where most centres are.
struct Buckets {
    Vec3<double> lower;
    Vec3<double> scale;
    Vec3<double> camera;

    Buckets(const Extent& extent, const Vec3<double>& camera) : camera(camera) {
        const Vec3<double> half = 2.0 * extent.reach; // a uniform distribution fits exactly
        lower = extent.center - half;
        for (int i = 0; i < 3; ++i)
            scale[i] = half[i] > 0 ? side / (2 * half[i]) : 0.0;
    }
    uint32_t operator()(const Sphere<double>& sphere) const {
        const Vec3<double> away = sphere.center - camera;
        if (glm::dot(away, away) <= sphere.radius * sphere.radius)
            return 0;
        const Vec3<double> p = (sphere.center - lower) * scale;
        const auto cell = [](double v) { return uint32_t(std::clamp(v, 0.0, double(side - 1))); };
        return 1 + cell(p.x) + side * (cell(p.y) + side * cell(p.z));
    }
};

} // namespace

std::vector<uint32_t> spatial_order(const SceneProgram& scene) {
    constexpr size_t worth_it = 4096;
    const Spheres spheres = scene.spheres;
    if (spheres.size() < worth_it || scene.camera.kind == CameraKind::orthographic)
        return {};
    const Buckets bucket(extent_of(spheres), scene.camera.location);

    // A stable counting sort: each block counts its own, then each knows where its spheres go.
    constexpr size_t blocks = 8;
    const size_t block = (spheres.size() + blocks - 1) / blocks;
    std::vector<uint32_t> places(blocks * bucket_count);
    const auto for_each_block = [&](const auto& visit) {
        tbb::parallel_for(size_t(0), blocks, [&](size_t b) {
            uint32_t* own = places.data() + b * bucket_count;
            for (size_t i = b * block; i < std::min(spheres.size(), (b + 1) * block); ++i)
                visit(own[bucket(spheres[i])], uint32_t(i));
        });
    };
    for_each_block([](uint32_t& count, uint32_t) { ++count; });
    uint32_t before = 0;
    for (uint32_t k = 0; k < bucket_count; ++k)
        for (size_t b = 0; b < blocks; ++b)
            before += std::exchange(places[b * bucket_count + k], before);
    std::vector<uint32_t> order(spheres.size());
    for_each_block([&](uint32_t& place, uint32_t sphere) { order[place++] = sphere; });
    return order;
}

} // namespace proxima
