// SPDX-License-Identifier: Apache-2.0
// The grid against brute force on single rays: the same primitive at the same distance, to the last bit.
#include "kernels/traverse.h"
#include "renderer/backend_cpu.h"
#include "renderer/grid_builder.h"

#include <doctest/doctest.h>
#include <random>
#include <vector>

using namespace proxima;

namespace {

struct RandomNumbers {
    std::mt19937 engine;
    double operator()(double low, double high) { return low + (high - low) * engine() / 4294967296.0; }
};

template <class Real>
std::vector<Sphere<Real>> spheres_of(RandomNumbers& random, int count, const Vec3<double>& spread) {
    std::vector<Sphere<Real>> spheres;
    for (int i = 0; i < count; ++i) {
        const Vec3<double> center = spread * Vec3<double>(random(-1, 1), random(-1, 1), random(-1, 1));
        spheres.push_back({Vec3<Real>(center), Real(random(0.001, 0.1))});
        if (i % 10 == 0)
            spheres.push_back(spheres.back()); // a duplicate: the smaller id must win
    }
    return spheres;
}

template <class Real>
SceneView<Real> scene_of(const std::vector<Sphere<Real>>& spheres, const std::vector<uint32_t>& materials,
                         const std::vector<Material>& surfaces) {
    SceneView<Real> scene;
    scene.geometry.spheres = spheres;
    scene.geometry.sphere_materials = materials;
    scene.surfaces.materials = surfaces;
    return scene;
}

/// A ray of one of the kinds that break grids.
template <class Real>
Ray<Real> awkward_ray(RandomNumbers& random, int kind, const Box<Real>& bounds, const Vec3<Real>& target) {
    Ray<Real> ray;
    const Vec3<Real> extent = bounds.upper - bounds.lower;
    const auto in_bounds = [&] {
        return bounds.lower + extent * Vec3<Real>(Real(random(0, 1)), Real(random(0, 1)), Real(random(0, 1)));
    };
    const int axis = int(random(0, 3)), sign = random(0, 1) < 0.5 ? -1 : 1;
    ray.origin = in_bounds();
    if (kind == 0) { // along an axis, from outside
        ray.origin[axis] = Real(-sign * 5);
        ray.direction = Vec3<Real>(Real(0));
        ray.direction[axis] = Real(sign);
        return ray;
    }
    if (kind == 1) // from a face
        ray.origin[axis] = sign < 0 ? bounds.lower[axis] : bounds.upper[axis];
    if (kind == 2) // from a corner
        ray.origin = sign < 0 ? bounds.lower : bounds.upper;
    if (kind == 3) // from a hundred widths away
        ray.origin +=
            Real(200) * glm::normalize(Vec3<Real>(Real(random(-1, 1)), Real(random(-1, 1)), Real(random(-1, 1))));
    if (kind == 4) // from the target's own centre
        ray.origin = target;
    ray.direction = glm::normalize((kind == 4 ? in_bounds() : target) - ray.origin);
    if (kind == 5) { // in a plane of the grid's axes
        ray.direction[axis] = Real(0);
        ray.direction = glm::normalize(ray.direction);
    }
    return ray;
}

} // namespace

const GridPlan plans[] = {
    {},
    {.size = {1, 1, 1}},
    {.size = {50, 3, 17}},
    {.size = {64, 64, 64}},
    {.brick = 1},
    {.size = {1, 1, 1}, .brick = 1},
    {.size = {50, 3, 17}, .brick = 2},
    {.size = {64, 64, 64}, .brick = 4},
    {.size = {40, 40, 40}, .brick = 8},
    {.size = {33, 70, 20}, .brick = 1, .metric = Metric::city_block},
    {.size = {64, 64, 64}, .brick = 2, .metric = Metric::city_block},
    {.size = {33, 70, 20}, .brick = 1, .metric = Metric::euclidean},
    {.size = {64, 64, 64}, .brick = 4, .metric = Metric::euclidean},
    {.size = {33, 70, 20}, .brick = 1, .metric = Metric::octant},
    {.size = {64, 64, 64}, .brick = 4, .metric = Metric::octant},
};

TEST_CASE_TEMPLATE("traverse: every grid and cloud finds what brute force finds, bit for bit", Real, float, double) {
    RandomNumbers random{std::mt19937(5)};
    CpuBackend backend;
    for (const Vec3<double> spread : {Vec3<double>(1, 1, 1), {1, 0, 1}, {1, 0, 0}, {3, 0.1, 1}}) {
        const auto spheres = spheres_of<Real>(random, 300, spread);
        const std::vector<uint32_t> materials(spheres.size(), 0);
        const std::vector<Material> surfaces(1);
        SceneView<Real> brute = scene_of(spheres, materials, surfaces);
        GridBuilder<CpuBackend, Real> builder(backend);
        builder.find_bounds(brute.geometry);
        for (const GridPlan& plan : plans) {
            CAPTURE(plan.size[0]);
            CAPTURE(plan.brick);
            CAPTURE(int(plan.metric));
            SceneView<Real> grid = brute;
            builder.build(grid, plan);
            if (plan.brick > 0)
                builder.build_distances(grid);
            REQUIRE(grid.grid.in_use());
            int hits = 0;
            for (int i = 0; i < 3000; ++i) {
                const Sphere<Real>& aim = spheres[size_t(random(0, double(spheres.size())))];
                const Vec3<Real> target =
                    aim.center + aim.radius * Vec3<Real>(Real(random(-1, 1)), Real(random(-1, 1)), Real(0));
                const SourcedRay<Real> ray{awkward_ray(random, i % 7, brute.geometry.bounds, target), {}};
                const BasedRay<Real> based = rebase(ray, brute.geometry.bounds);
                const Hit<Real> a = find_nearest(brute, based, {}, Real(0), infinity<Real>, 0);
                const Hit<Real> b = find_nearest(grid, based, {}, Real(0), infinity<Real>, 0);
                REQUIRE(a.primitive == b.primitive);
                REQUIRE(a.t == b.t);
                REQUIRE(find_any(grid, based, Real(0), infinity<Real>) == (a.primitive != no_primitive));
                const Hit<Real> c = find_nearest<RoundShapes::spheres>(grid, based, {}, Real(0), infinity<Real>, 0);
                REQUIRE((c.t == a.t && c.primitive == a.primitive));
                hits += a.primitive != no_primitive;
                if (a.primitive == no_primitive)
                    continue;
                const Hit<Real> next_a = find_nearest(brute, based, a, Real(0), infinity<Real>, 0);
                const Hit<Real> next_b = find_nearest(grid, based, a, Real(0), infinity<Real>, 0);
                REQUIRE(next_a.primitive == next_b.primitive);
                REQUIRE(next_a.t == next_b.t);
            }
            CHECK(hits > 500);
        }
    }
}

namespace {

/// Dense clusters around `middles`, each `width` wide, and `outliers` spheres anywhere in a cube of 2.
template <class Real>
std::vector<Sphere<Real>> stadium(RandomNumbers& random, std::span<const Vec3<double>> middles, double width,
                                  int outliers) {
    std::vector<Sphere<Real>> spheres;
    const auto in_cube = [&] { return Vec3<double>(random(-1, 1), random(-1, 1), random(-1, 1)); };
    for (int i = 0; i < outliers; ++i)
        spheres.push_back({Vec3<Real>(in_cube()), Real(random(0.1, 1) * width)});
    while (spheres.size() < size_t(1500 + outliers)) {
        const Vec3<double> middle = middles[spheres.size() % middles.size()];
        spheres.push_back({Vec3<Real>(middle + 0.5 * width * in_cube()), Real(random(0.01, 0.05) * width)});
    }
    return spheres;
}

} // namespace

TEST_CASE_TEMPLATE("traverse: a core's grid and its outskirts' find what brute force finds, bit for bit", Real, float,
                   double) {
    RandomNumbers random{std::mt19937(9)};
    CpuBackend backend;
    const Vec3<double> middles[] = {{0.31, -0.22, 0.43}, {-0.7, 0.1, 0.2}};
    for (const double width : {0.1, 0.01, 0.001})
        for (const int outliers : {1, 10, 90}) {
            const auto spheres = stadium<Real>(random, std::span(middles, 1), width, outliers);
            const std::vector<uint32_t> materials(spheres.size(), 0);
            const std::vector<Material> surfaces(1);
            SceneView<Real> brute = scene_of(spheres, materials, surfaces);
            GridBuilder<CpuBackend, Real> builder(backend);
            builder.find_bounds(brute.geometry);
            builder.find_core(brute.geometry, false);
            for (const GridPlan& plan : plans) {
                CAPTURE(width);
                CAPTURE(outliers);
                CAPTURE(plan.size[0]);
                CAPTURE(plan.brick);
                CAPTURE(int(plan.metric));
                SceneView<Real> grid = brute;
                builder.build(grid, plan);
                if (plan.brick > 0)
                    builder.build_distances(grid);
                if (outliers == 1 && !grid.outskirts.in_use())
                    continue; // it fell near the others
                REQUIRE(grid.grid.part == GridPart::core);
                REQUIRE(grid.outskirts.in_use());
                const Vec3<Real> extent = grid.grid.box().upper - grid.grid.box().lower;
                CHECK(max_component(extent) < Real(7 * width));
                int hits = 0;
                for (int i = 0; i < 1400; ++i) {
                    const Sphere<Real>& aim = spheres[i % 4 == 0 ? i % outliers : i];
                    const Vec3<Real> target =
                        aim.center + aim.radius * Vec3<Real>(Real(random(-1, 1)), Real(random(-1, 1)), Real(0));
                    const Box<Real>& around = i % 8 < 4 ? brute.geometry.bounds : grid.grid.box();
                    const SourcedRay<Real> ray{awkward_ray(random, i % 7, around, target), {}};
                    const BasedRay<Real> based = rebase(ray, brute.geometry.bounds);
                    const Hit<Real> a = find_nearest(brute, based, {}, Real(0), infinity<Real>, 0);
                    const Hit<Real> b = find_nearest(grid, based, {}, Real(0), infinity<Real>, 0);
                    const Hit<Real> c = find_nearest<RoundShapes::spheres>(grid, based, {}, Real(0), infinity<Real>, 0);
                    REQUIRE((a.primitive == b.primitive && a.t == b.t));
                    REQUIRE((a.primitive == c.primitive && a.t == c.t));
                    REQUIRE(find_any(grid, based, Real(0), infinity<Real>) == (a.primitive != no_primitive));
                    const Vec3<Real> point = aim.center;
                    std::vector<uint32_t> around_point;
                    for_each_around(grid, point, [&](uint32_t id) { around_point.push_back(id); });
                    REQUIRE(std::count(around_point.begin(), around_point.end(), uint32_t(&aim - spheres.data())) == 1);
                    hits += a.primitive != no_primitive;
                }
                CHECK(hits > 500);
            }
        }
    SUBCASE("not where two clusters are far apart") {
        const auto spheres = stadium<Real>(random, middles, 0.01, 20);
        SceneView<Real> scene;
        scene.geometry.spheres = spheres;
        GridBuilder<CpuBackend, Real> builder(backend);
        builder.find_bounds(scene.geometry);
        builder.find_core(scene.geometry, false);
        builder.build(scene, {});
        CHECK(scene.grid.part == GridPart::all);
        CHECK_FALSE(scene.outskirts.in_use());
    }
}

TEST_CASE("traverse: a ray that has passed a hit sees each surface once, and what is there twice as if once") {
    const std::vector<Sphere<double>> spheres{{{0, 0, 0}, 1}, {{0, 0, 0}, 1}, {{0, 0, 0.5}, 1}, {{0, 0, 0}, 1}};
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    SceneView<double> scene;
    scene.geometry.spheres = spheres;
    scene.geometry.sphere_materials = materials;
    scene.geometry.bounds = {Vec3<double>(-2.0), Vec3<double>(2.0)};
    scene.surfaces.materials = surfaces;
    const BasedRay<double> ray = rebase(SourcedRay<double>{{{0, 0, -5}, {0, 0, 1}}, {}}, scene.geometry.bounds);
    std::vector<uint32_t> order;
    Hit<double> hit;
    for (;;) {
        hit = find_nearest(scene, ray, hit, 0.0, infinity<double>, 0);
        if (hit.primitive == no_primitive)
            break;
        order.push_back(hit.primitive);
        REQUIRE(order.size() <= 8);
    }
    CHECK(order == std::vector<uint32_t>{0, 2, 0, 2});
}

TEST_CASE("traverse: a ray leaves its own sphere outward for good, inward at the analytic exit") {
    const std::vector<Sphere<float>> spheres{{{1e4f, 0, 0}, 1}};
    const std::vector<uint32_t> materials(1, 0);
    const std::vector<Material> surfaces(1);
    SceneView<float> scene;
    scene.geometry.spheres = spheres;
    scene.geometry.sphere_materials = materials;
    scene.geometry.bounds = {{9998, -2, -2}, {10002, 2, 2}};
    scene.surfaces.materials = surfaces;
    const Ray<float> from_surface{{1e4f, 0.6f, 0.8f}, {0, 0, 1}};
    const auto nearest = [&](RaySource<float> source) {
        return find_nearest(scene, rebase(SourcedRay<float>{from_surface, source}, scene.geometry.bounds), {}, 0.0f,
                            infinity<float>, 0);
    };
    CHECK(nearest({0, 0.0f}).primitive == no_primitive);
    CHECK(nearest({0, -1e-3f}).primitive == no_primitive);
    CHECK(nearest({0, 1.5f}).t == 1.5f);
}

TEST_CASE("traverse: the primitives around a point, with and without a grid") {
    RandomNumbers random{std::mt19937(8)};
    auto spheres = spheres_of<float>(random, 500, {1, 1, 1});
    for (Sphere<float>& sphere : spheres)
        sphere.radius *= 3;
    const std::vector<uint32_t> materials(spheres.size(), 0);
    SceneView<float> brute;
    brute.geometry.spheres = spheres;
    brute.geometry.sphere_materials = materials;
    CpuBackend backend;
    GridBuilder<CpuBackend, float> builder(backend);
    builder.find_bounds(brute.geometry);
    SceneView<float> grid = brute;
    builder.build(grid, {});
    const auto around = [](const SceneView<float>& scene, const Vec3<float>& point) {
        std::vector<uint32_t> ids;
        for_each_around(scene, point, [&](uint32_t id) {
            const Vec3<float> d = point - scene.geometry.spheres[id].center;
            if (glm::dot(d, d) < scene.geometry.spheres[id].radius * scene.geometry.spheres[id].radius)
                ids.push_back(id);
        });
        std::sort(ids.begin(), ids.end());
        return ids;
    };
    for (int i = 0; i < 1000; ++i) {
        const Vec3<float> point(float(random(-1.2, 1.2)), float(random(-1.2, 1.2)), float(random(-1.2, 1.2)));
        REQUIRE(around(brute, point) == around(grid, point));
    }
}

namespace {

/// A device with hardly any memory, which is not waited for.
struct SmallBackend : CpuBackend {
    static constexpr bool is_immediate = false;
    uint64_t size = 1 << 20; ///< bytes
    uint64_t available_memory() { return size - std::min(size, memory().now()); }
};

void check_same_hits(const SceneView<float>& brute, const SceneView<float>& grid, RandomNumbers& random) {
    for (int i = 0; i < 300; ++i) {
        const Vec3<float> target(float(random(-1, 1)), float(random(-1, 1)), float(random(-1, 1)));
        const BasedRay<float> ray = rebase(
            SourcedRay<float>{{{0, 0, -5}, glm::normalize(target - Vec3<float>(0, 0, -5))}, {}}, brute.geometry.bounds);
        const Hit<float> a = find_nearest(brute, ray, {}, 0.0f, infinity<float>, 0);
        const Hit<float> b = find_nearest(grid, ray, {}, 0.0f, infinity<float>, 0);
        REQUIRE((a.t == b.t && a.primitive == b.primitive));
    }
}

} // namespace

TEST_CASE("traverse: a grid whose lists do not fit into memory is made coarser, down to one voxel or brick") {
    RandomNumbers random{std::mt19937(21)};
    auto spheres = spheres_of<float>(random, 20'000, {1, 1, 1});
    for (Sphere<float>& sphere : spheres)
        sphere.radius = 0.2f; // thousands of voxels each
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    for (const uint32_t brick : {0u, 4u})
        for (const uint64_t memory : {uint64_t(8) << 20, uint64_t(1) << 16}) {
            CAPTURE(brick);
            CAPTURE(memory);
            SmallBackend backend;
            backend.size = memory;
            SceneView<float> brute = scene_of(spheres, materials, surfaces);
            GridBuilder<SmallBackend, float> builder(backend);
            builder.find_bounds(brute.geometry);
            SceneView<float> grid = brute;
            builder.build(grid, {.size = {100, 100, 100}, .brick = brick});
            if (brick > 0)
                builder.build_distances(grid);
            CHECK(builder.is_complete());
            CHECK(grid.grid.cell_count() < 100 * 100 * 100);
            FrameStatistics statistics;
            builder.report(grid.grid, statistics);
            CHECK(statistics.wanted_grid == std::array<uint32_t, 3>{100, 100, 100});
            CHECK(statistics.most_voxels < 100 * 100 * 100);
            CHECK(statistics.grid[0] == uint32_t(grid.grid.size.x));
            const bool is_coarsest = grid.grid.cell_count() == (brick > 0 ? 64 : 1);
            CHECK((is_coarsest || grid.grid.links.size_bytes() <= memory));
            check_same_hits(brute, grid, random);
        }
}

TEST_CASE("traverse: rays pass by the bricks that there is no room for") {
    RandomNumbers random{std::mt19937(25)};
    const auto spheres = spheres_of<float>(random, 500, {1, 1, 1});
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    CpuBackend backend;
    SceneView<float> scene = scene_of(spheres, materials, surfaces);
    GridBuilder<CpuBackend, float> builder(backend);
    builder.find_bounds(scene.geometry);
    builder.build(scene, {.size = {40, 40, 40}, .brick = 4});
    const CloudView& cloud = scene.grid.cloud;
    std::vector<uint32_t> marks(BrickMarks::word_count(cloud.size));
    std::fill(cloud.ranks.begin(), cloud.ranks.end(), MarkBricks<float>::no_rank);
    GridCounts counts;
    const uint32_t room = 7;
    scene.grid.heads = scene.grid.heads.first(room * 64);
    const MarkBricks<float> mark{scene.grid, scene.geometry, {&counts, 1}, {marks, BrickMarks::row_words(cloud.size)}};
    for (uint32_t id = 0; id < scene.geometry.round_count(); ++id)
        mark(id);
    CHECK(counts.bricks > 100); // so it is known
    uint32_t marked = 0;
    bool all_have_lists = true;
    for (int32_t z = 0; z < cloud.size.z; ++z)
        for (int32_t y = 0; y < cloud.size.y; ++y)
            for (int32_t x = 0; x < cloud.size.x; ++x)
                if (mark.marks.has(uint32_t(y + cloud.size.y * z), x)) {
                    ++marked;
                    all_have_lists = all_have_lists && cloud.ranks[cloud.index(x, y, z)] < room;
                }
    CHECK(marked == room);
    CHECK(all_have_lists);
}

TEST_CASE("traverse: lists that have grown since the last frame are made once more") {
    RandomNumbers random{std::mt19937(22)};
    auto spheres = spheres_of<float>(random, 2'000, {1, 1, 1});
    for (Sphere<float>& sphere : spheres)
        sphere.radius = 0.01f;
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    for (const uint32_t brick : {0u, 4u}) {
        CAPTURE(brick);
        SmallBackend backend;
        backend.size = uint64_t(1) << 30;
        GridBuilder<SmallBackend, float> builder(backend);
        const GridPlan plan{.size = {40, 40, 40}, .brick = brick};
        SceneView<float> grid = scene_of(spheres, materials, surfaces);
        builder.find_bounds(grid.geometry);
        builder.build(grid, plan);
        CHECK(builder.is_complete());
        FrameStatistics statistics;
        builder.report(grid.grid, statistics);
        CHECK(statistics.wanted_grid[0] == 0); // it is as it was to be

        auto grown = spheres;
        for (Sphere<float>& sphere : grown)
            sphere.radius = 0.15f;
        SceneView<float> brute = scene_of(grown, materials, surfaces);
        builder.find_bounds(brute.geometry);
        grid = brute;
        builder.build(grid, plan);
        CHECK_FALSE(builder.is_complete()); // too little room, as is told after the frame
        grid = brute;
        builder.build(grid, plan);
        if (brick > 0)
            builder.build_distances(grid);
        CHECK(builder.is_complete());
        check_same_hits(brute, grid, random);
    }
}

TEST_CASE("traverse: a core is given up in the frame in which it no longer holds, and looked for now and then") {
    RandomNumbers random{std::mt19937(31)};
    const Vec3<double> middles[] = {{0.3, -0.2, 0.4}};
    const auto dense = stadium<float>(random, middles, 0.05, 50);
    const auto spread = stadium<float>(random, middles, 1.5, 50);
    const std::vector<uint32_t> materials(dense.size(), 0);
    const std::vector<Material> surfaces(1);
    CpuBackend backend;
    GridBuilder<CpuBackend, float> builder(backend);
    const auto part_of = [&](const std::vector<Sphere<float>>& spheres, bool anew) {
        SceneView<float> brute = scene_of(spheres, materials, surfaces);
        builder.find_bounds(brute.geometry);
        builder.find_core(brute.geometry, anew);
        SceneView<float> grid = brute;
        builder.build(grid, {});
        check_same_hits(brute, grid, random);
        CHECK(grid.outskirts.in_use() == (grid.grid.part == GridPart::core));
        return grid.grid.part;
    };
    CHECK(part_of(dense, false) == GridPart::core);
    CHECK(part_of(dense, false) == GridPart::core);
    CHECK(part_of(spread, false) == GridPart::all);
    CHECK(part_of(dense, false) == GridPart::all); // nobody looked
    CHECK(part_of(dense, true) == GridPart::core);
    CHECK(part_of(spread, false) == GridPart::all);
    uint32_t frames = 1;
    while (part_of(dense, false) == GridPart::all && frames < 1000)
        ++frames;
    CHECK(frames == OutlierRule<CpuBackend, float>::interval + 1);
}

TEST_CASE("traverse: large spheres among small ones are not in the voxels of these") {
    RandomNumbers random{std::mt19937(37)};
    std::vector<Sphere<float>> spheres;
    for (int i = 0; i < 2000; ++i)
        spheres.push_back({Vec3<float>(float(random(-1, 1)), float(random(-1, 1)), float(random(-1, 1))),
                           float(i % 20 == 0 ? random(0.1, 0.2) : random(0.001, 0.003))});
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    SceneView<float> brute = scene_of(spheres, materials, surfaces);
    CpuBackend backend;
    GridBuilder<CpuBackend, float> builder(backend);
    builder.find_bounds(brute.geometry);
    REQUIRE(brute.geometry.large.empty()); // a ray cannot test all that are
    builder.find_core(brute.geometry, false);
    for (const GridPlan& plan : plans) {
        SceneView<float> grid = brute;
        builder.build(grid, plan);
        if (plan.brick > 0)
            builder.build_distances(grid);
        FrameStatistics statistics;
        builder.report(grid.grid, statistics);
        CHECK(statistics.outliers == 100);
        CHECK(statistics.references <= 8 * 1900);
        check_same_hits(brute, grid, random);
    }
}
