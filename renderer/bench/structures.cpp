// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/structures.h"
#include "kernels/film.h"
#include "renderer/grid_resolution.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <numeric>

namespace proxima {
namespace {

using Point = Vec3<double>;
using Bounds = Box<double>;
using Spheres = std::span<const Sphere<double>>;
using Ids = std::vector<uint32_t>;

constexpr double voxel_bytes = 4, reference_bytes = 4, node_bytes = 8;

/// What one ray costs, and the nearest hit so far.
struct Count {
    uint64_t lookups = 0, tests = 0;
    double nearest = infinity<double>;
};

void test(Spheres spheres, const Ids& ids, const Ray<double>& ray, Count& count) {
    for (const uint32_t id : ids)
        count.nearest = std::min(count.nearest, intersect(spheres[id], ray, 0.0, 0.0));
    count.tests += ids.size();
}

Bounds bounds_of(const Sphere<double>& sphere) {
    return {sphere.center - Point(sphere.radius), sphere.center + Point(sphere.radius)};
}

/// A little too often, which covers the rounding of walks.
bool overlaps(const Sphere<double>& sphere, const Bounds& box) {
    const Point nearest = glm::clamp(sphere.center, box.lower, box.upper);
    return glm::dot(nearest - sphere.center, nearest - sphere.center) <= sphere.radius * sphere.radius * (1 + 1e-9);
}

/// A grid over some of the spheres. Where a voxel has many of them and `deeper`, a grid of its own is in it.
class CountedGrid {
public:
    CountedGrid(Spheres spheres, const Ids& ids, const Bounds& bounds, double voxels_a_sphere, bool deeper)
        : spheres_(spheres), bounds_(bounds) {
        const Point extent = bounds.upper - bounds.lower;
        size_ = grid_resolution({extent.x, extent.y, extent.z}, ids.size(), {.voxels_per_primitive = voxels_a_sphere});
        for (int i = 0; i < 3; ++i)
            voxel_[i] = extent[i] / size_[size_t(i)];
        lists_.resize(size_t(size_[0]) * size_[1] * size_[2]);
        for (const uint32_t id : ids)
            for_each_voxel(bounds_of(spheres[id]), [&](size_t voxel, const Bounds& box) {
                if (overlaps(spheres[id], box))
                    lists_[voxel].push_back(id);
            });
        if (deeper)
            make_inner();
    }

    void trace(const Ray<double>& ray, Count& count) const {
        const Span<double> span = intersect(bounds_, ray);
        if (span.enter > span.exit)
            return;
        const Point entry = ray.origin + span.enter * ray.direction;
        std::array<int64_t, 3> cell;
        Point next, step;
        for (int i = 0; i < 3; ++i) {
            const double v = ray.direction[i];
            cell[size_t(i)] = std::clamp<int64_t>(int64_t((entry[i] - bounds_.lower[i]) / voxel_[i]), 0,
                                                  int64_t(size_[size_t(i)]) - 1);
            const double plane = bounds_.lower[i] + double(cell[size_t(i)] + (v > 0)) * voxel_[i];
            next[i] = v == 0 ? infinity<double> : (plane - ray.origin[i]) / v;
            step[i] = v == 0 ? infinity<double> : voxel_[i] / glm::abs(v);
        }
        for (;;) {
            const size_t voxel = index(cell[0], cell[1], cell[2]);
            ++count.lookups;
            if (!inner_.empty() && inner_[voxel])
                inner_[voxel]->trace(ray, count);
            else
                test(spheres_, lists_[voxel], ray, count);
            const int axis = next.x <= next.y && next.x <= next.z ? 0 : next.y <= next.z ? 1 : 2;
            int64_t& moved = cell[size_t(axis)];
            moved += ray.direction[axis] > 0 ? 1 : -1;
            if (count.nearest <= next[axis] || moved < 0 || moved >= int64_t(size_[size_t(axis)]))
                return;
            next[axis] += step[axis];
        }
    }

    double bytes() const {
        double sum = voxel_bytes * double(lists_.size());
        for (size_t voxel = 0; voxel < lists_.size(); ++voxel)
            sum += !inner_.empty() && inner_[voxel] ? inner_[voxel]->bytes()
                                                    : reference_bytes * double(lists_[voxel].size());
        return sum;
    }

private:
    static constexpr size_t worth_a_grid = 8; ///< spheres

    size_t index(int64_t x, int64_t y, int64_t z) const {
        return size_t(x) + size_[0] * (size_t(y) + size_t(size_[1]) * size_t(z));
    }
    Bounds box_of(const std::array<int64_t, 3>& cell) const {
        const Point lower = bounds_.lower + Point(double(cell[0]), double(cell[1]), double(cell[2])) * voxel_;
        return {lower, lower + voxel_};
    }
    template <class Visit> void for_each_voxel(const Bounds& box, const Visit& visit) const {
        std::array<int64_t, 3> low, high;
        for (int i = 0; i < 3; ++i) {
            const auto cell = [&](double v) {
                return std::clamp<int64_t>(int64_t((v - bounds_.lower[i]) / voxel_[i]), 0,
                                           int64_t(size_[size_t(i)]) - 1);
            };
            low[size_t(i)] = cell(box.lower[i]);
            high[size_t(i)] = cell(box.upper[i]);
        }
        for (int64_t z = low[2]; z <= high[2]; ++z)
            for (int64_t y = low[1]; y <= high[1]; ++y)
                for (int64_t x = low[0]; x <= high[0]; ++x)
                    visit(index(x, y, z), box_of({x, y, z}));
    }
    void make_inner() {
        inner_.resize(lists_.size());
        for_each_voxel(bounds_, [&](size_t voxel, const Bounds& box) {
            if (lists_[voxel].size() >= worth_a_grid)
                inner_[voxel] =
                    std::make_unique<CountedGrid>(spheres_, lists_[voxel], box, GridRule{}.voxels_per_primitive, false);
        });
    }

    Spheres spheres_;
    Bounds bounds_;
    std::array<uint32_t, 3> size_;
    Point voxel_;
    std::vector<Ids> lists_;
    std::vector<std::unique_ptr<CountedGrid>> inner_;
};

/// Boxes divided at their middles until few spheres are in them.
class CountedOctree {
public:
    CountedOctree(Spheres spheres, Ids ids, const Bounds& bounds, int depth = 0)
        : spheres_(spheres), bounds_(bounds), ids_(std::move(ids)) {
        if (ids_.size() <= few || depth == deepest)
            return;
        const Point middle = 0.5 * (bounds.lower + bounds.upper);
        std::array<Ids, 8> parts;
        std::array<Bounds, 8> boxes;
        size_t references = 0;
        for (size_t k = 0; k < 8; ++k) {
            boxes[k] = bounds;
            for (int i = 0; i < 3; ++i)
                (k >> i & 1 ? boxes[k].lower : boxes[k].upper)[i] = middle[i];
            for (const uint32_t id : ids_)
                if (overlaps(spheres[id], boxes[k]))
                    parts[k].push_back(id);
            references += parts[k].size();
        }
        if (references > 4 * ids_.size()) // they do not come apart
            return;
        ids_ = {};
        for (size_t k = 0; k < 8; ++k)
            children_.emplace_back(spheres, std::move(parts[k]), boxes[k], depth + 1);
    }

    void trace(const Ray<double>& ray, Count& count) const {
        ++count.lookups;
        if (children_.empty())
            return test(spheres_, ids_, ray, count);
        std::multimap<double, const CountedOctree*> order;
        for (const CountedOctree& child : children_) {
            const Span<double> span = intersect(child.bounds_, ray);
            if (span.enter <= span.exit)
                order.emplace(span.enter, &child);
        }
        for (const auto& [enter, child] : order)
            if (enter < count.nearest)
                child->trace(ray, count);
    }

    double bytes() const {
        double sum = node_bytes + reference_bytes * double(ids_.size());
        for (const CountedOctree& child : children_)
            sum += child.bytes();
        return sum;
    }

private:
    static constexpr size_t few = 4;
    static constexpr int deepest = 12;

    Spheres spheres_;
    Bounds bounds_;
    Ids ids_;
    std::vector<CountedOctree> children_;
};

template <class Structure>
StructureFigures figures_of(const char* name, const Structure& structure, std::span<const Ray<double>> rays) {
    StructureFigures figures{.name = name, .bytes = structure.bytes()};
    for (const Ray<double>& ray : rays) {
        Count count;
        structure.trace(ray, count);
        figures.lookups += double(count.lookups) / double(rays.size());
        figures.tests += double(count.tests) / double(rays.size());
        if (count.nearest < infinity<double>)
            figures.checksum += count.nearest;
    }
    return figures;
}

} // namespace

std::vector<StructureFigures> count_structures(const SceneProgram& scene, uint32_t columns, uint32_t rows) {
    const Spheres spheres = scene.spheres;
    Bounds bounds = bounds_of(spheres.front());
    for (const Sphere<double>& sphere : spheres)
        bounds = joined(bounds, bounds_of(sphere));
    const FilmView film{{}, columns, rows, 1};
    std::vector<Ray<double>> rays;
    for (uint32_t y = 0; y < rows; ++y)
        for (uint32_t x = 0; x < columns; ++x) {
            const Ray<double> ray = pixel_ray(scene.camera, film, {x, y}, 0);
            if (const Span<double> span = intersect(bounds, ray); span.enter <= span.exit)
                rays.push_back(ray);
        }
    Ids all(spheres.size());
    std::iota(all.begin(), all.end(), 0u);
    const double voxels = GridRule{}.voxels_per_primitive;
    // The top level's 0.12 voxels a sphere are those of Perard-Gayot, Kalojanov and Slusallek, "GPU Ray Tracing using
    // Irregular Grids", 2017.
    return {figures_of("grid", CountedGrid(spheres, all, bounds, voxels, false), rays),
            figures_of("two-level grid", CountedGrid(spheres, all, bounds, 0.12, true), rays),
            figures_of("octree", CountedOctree(spheres, all, bounds), rays)};
}

} // namespace proxima
