// SPDX-License-Identifier: Apache-2.0
// The steps that a ray makes, counted anew: from the voxels that it passes, and by a visitor that is asked in each.
#include "kernels/aov.h"
#include "renderer/backend_cpu.h"
#include "renderer/grid_builder.h"

#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <vector>

using namespace proxima;

namespace {

constexpr uint32_t width = 96, height = 72;

/// A NearestHit that counts how often it is asked whether it is done.
struct CountingVisitor {
    NearestHit<double> nearest;
    mutable uint32_t asked = 0;

    bool meet(uint32_t id) { return nearest.meet(id); }
    bool meet_sphere(uint32_t id) { return nearest.meet_sphere(id); }
    bool is_done(double reached) const {
        ++asked;
        return nearest.is_done(reached);
    }
};

struct Field {
    std::vector<Sphere<double>> spheres;
    std::vector<uint32_t> materials;
    std::vector<Material> surfaces{1};
    SceneView<double> view;

    explicit Field(int count) : materials(size_t(count), 0) {
        std::mt19937 engine(3);
        const auto uniform = [&] { return 2 * engine() / 4294967296.0 - 1; };
        for (int i = 0; i < count; ++i)
            spheres.push_back({{uniform(), uniform(), uniform()}, 0.05});
        view.geometry.spheres = spheres;
        view.geometry.sphere_materials = materials;
        view.surfaces.materials = surfaces;
        view.camera.location = {0.3, 0.2, -4};
    }

    std::vector<AovSample> samples() const {
        std::vector<AovSample> aovs(size_t(width) * height);
        FilmView film;
        film.width = width;
        film.height = height;
        const TraceAovs<double, double> trace{view, film, {}, aovs};
        for (uint32_t i = 0; i < tiled_pixel_count(width, height); ++i)
            trace(i);
        return aovs;
    }

    /// Calls visit(based ray, place) for each pixel.
    template <class Visit> void for_each_ray(const Visit& visit) const {
        FilmView film;
        film.width = width;
        film.height = height;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                visit(rebase(SourcedRay<double>{pixel_ray(view.camera, film, {x, y}, 0), {}}, view.geometry.bounds),
                      size_t(y) * width + x);
    }
};

} // namespace

TEST_CASE("aov: the steps of a grid are the voxels from the bounds to the surface") {
    Field field(400);
    CpuBackend backend;
    GridBuilder<CpuBackend, double> builder(backend);
    builder.find_bounds(field.view.geometry);
    builder.build(field.view, {.size = {23, 31, 17}});
    const std::vector<AovSample> samples = field.samples();
    const GridView<double>& grid = field.view.grid;
    uint32_t hits = 0, passed = 0;
    field.for_each_ray([&](const BasedRay<double>& based, size_t place) {
        if (!based.meets_bounds) {
            CHECK(samples[place].steps == 0);
            return;
        }
        const Hit<double> hit = find_nearest(field.view, based, {}, 0.0, infinity<double>, 0);
        const bool is_hit = hit.primitive != no_primitive;
        (is_hit ? hits : passed) += 1;
        const double end = is_hit ? hit.t : intersect(field.view.geometry.bounds, based.ray).exit;
        const Vec3<int32_t> from = grid.cell_at(based.ray.origin),
                            to = grid.cell_at(based.ray.origin + end * based.ray.direction);
        const uint32_t voxels =
            uint32_t(1 + std::abs(to.x - from.x) + std::abs(to.y - from.y) + std::abs(to.z - from.z));
        REQUIRE(samples[place].steps == voxels);
    });
    CHECK(hits > 500);
    CHECK(passed > 500);
}

TEST_CASE("aov: the steps of every grid and cloud are the times that a visitor is asked") {
    Field field(400);
    const std::vector<AovSample> brute = field.samples();
    CpuBackend backend;
    GridBuilder<CpuBackend, double> builder(backend);
    builder.find_bounds(field.view.geometry);
    const auto sum_with = [&](const GridPlan& plan) {
        CAPTURE(plan.brick);
        CAPTURE(int(plan.metric));
        builder.build(field.view, plan);
        if (plan.brick > 0)
            builder.build_distances(field.view);
        const std::vector<AovSample> samples = field.samples();
        uint64_t sum = 0;
        field.for_each_ray([&](const BasedRay<double>& based, size_t place) {
            REQUIRE(samples[place].id == brute[place].id);
            REQUIRE(samples[place].depth == brute[place].depth);
            CountingVisitor visitor{NearestHit<double>({field.view, based, -based.offset}, 0, infinity<double>)};
            if (based.meets_bounds)
                walk<RoundShapes::all>(field.view.grid, based.ray, visitor);
            // A leap out of the grid is the end: nobody is asked any more.
            const bool leapt_out = plan.brick > 0 && based.meets_bounds && samples[place].steps == visitor.asked + 1;
            REQUIRE((leapt_out || samples[place].steps == visitor.asked));
            sum += samples[place].steps;
        });
        return sum;
    };
    const uint64_t by_grid = sum_with({.size = {64, 64, 64}});
    for (const Metric metric : {Metric::chessboard, Metric::city_block, Metric::euclidean, Metric::octant})
        for (const uint32_t brick : {1u, 2u, 4u, 8u}) {
            CAPTURE(brick);
            CHECK(sum_with({.size = {64, 64, 64}, .brick = brick, .metric = metric}) < by_grid);
        }
    CHECK(2 * sum_with({.size = {64, 64, 64}, .brick = 4}) < by_grid); // what the cloud saves
}
