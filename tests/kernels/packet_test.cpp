// SPDX-License-Identifier: Apache-2.0
// Packets of rays against the same rays alone: the same hits at the same distances, and the same pictures, to the last
// bit.
#include "kernels/packet_search.h"
#include "renderer/backend_cpu.h"
#include "renderer/grid_builder.h"
#include "renderer/pipeline_renderer.h"
#include "tests/kernels/test_scene.h"

#include <cstring>
#include <doctest/doctest.h>
#include <random>
#include <vector>

using namespace proxima;
using namespace proxima::test;

namespace {

struct RandomNumbers {
    std::mt19937 engine;
    float operator()(double low, double high) { return float(low + (high - low) * engine() / 4294967296.0); }
    glm::vec3 in_cube() { return {(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)}; }
};

constexpr uint32_t lanes = RayPacket<float>::lanes;

/// Rays that have `width` of the scene between them; every seventh lane has none. `scattered`: every third starts on
/// some sphere.
struct Bundle {
    BasedRay<float> based[lanes];
    RayPacket<float> packet;

    Bundle(RandomNumbers& random, const SceneView<float>& scene, float width, float reach, bool scattered) {
        const glm::vec3 from = 2.0f * random.in_cube(), to = 0.5f * random.in_cube();
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            packet.set_idle(lane);
            if (lane % 7 == 6)
                continue;
            Ray<float> ray{from, glm::normalize(to + width * random.in_cube() - from)};
            RaySource<float> source;
            if (scattered && lane % 3 == 0) {
                source.primitive = random.engine() % scene.geometry.sphere_count();
                const Sphere<float>& sphere = scene.geometry.spheres[source.primitive];
                ray.origin = sphere.center - sphere.radius * ray.direction;
            }
            based[lane] = rebase(SourcedRay<float>{ray, source}, scene.geometry.bounds);
            packet.set(lane, based[lane], 0.0f, reach);
        }
    }
};

/// The backend that traces one ray after the other.
struct SingleRays : CpuBackend {
    using CpuBackend::CpuBackend;
    static constexpr bool traces_packets = false;
};

bool same_bits(const Image& a, const Image& b) {
    return a.rgb.size() == b.rgb.size() && std::memcmp(a.rgb.data(), b.rgb.data(), a.rgb.size() * sizeof(float)) == 0;
}

} // namespace

TEST_CASE("packet: finds what each of its rays finds alone, bit for bit") {
    RandomNumbers random{std::mt19937(11)};
    CpuBackend backend;
    std::vector<Sphere<float>> spheres;
    for (int i = 0; i < 400; ++i) {
        spheres.push_back({random.in_cube(), random(0.001, 0.1)});
        if (i % 10 == 0)
            spheres.push_back(spheres.back()); // a duplicate: the smaller id must win
    }
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    const std::vector<Plane<float>> planes{{{0, 1, 0}, -0.8f, 0}};
    const std::array<uint32_t, 3> sizes[] = {{0, 0, 0}, {1, 1, 1}, {50, 3, 17}, {64, 64, 64}};
    for (const std::array<uint32_t, 3>& size : sizes) {
        CAPTURE(size[0]);
        SceneView<float> scene;
        scene.geometry.spheres = spheres;
        scene.geometry.planes = planes;
        scene.geometry.sphere_materials = materials;
        scene.surfaces.materials = surfaces;
        GridBuilder<CpuBackend, float> builder(backend);
        builder.find_bounds(scene.geometry);
        builder.build(scene, {.size = size});
        int together = 0, alone = 0, hits = 0;
        for (int i = 0; i < 600; ++i) {
            const float width = i % 3 == 0 ? 0.02f : i % 3 == 1 ? 0.2f : 2.0f;
            const float reach = i % 2 ? infinity<float> : random(0.5, 4);
            CAPTURE(i);
            Bundle nearest(random, scene, width, reach, i % 4 == 3);
            Bundle any = nearest;
            bool split = false;
            const auto search = [&](uint32_t lane) {
                return find_nearest<RoundShapes::spheres>(scene, nearest.based[lane], {}, 0.0f, reach, 0);
            };
            search_packet<Sought::nearest>(scene, nearest.packet, [&](uint32_t lane) {
                split = true;
                const Hit<float> hit = search(lane);
                nearest.packet.reach[lane] = hit.t;
                nearest.packet.primitive[lane] = hit.primitive;
            });
            search_packet<Sought::any>(scene, any.packet, [&](uint32_t lane) {
                any.packet.primitive[lane] =
                    find_any<RoundShapes::spheres>(scene, any.based[lane], 0.0f, reach) ? 0 : no_primitive;
            });
            (split ? alone : together) += 1;
            for (uint32_t lane = 0; lane < lanes; ++lane) {
                CAPTURE(lane);
                if (lane % 7 == 6) {
                    REQUIRE(nearest.packet.primitive[lane] == no_primitive);
                    continue;
                }
                const Hit<float> hit = search(lane);
                REQUIRE(nearest.packet.primitive[lane] == hit.primitive);
                REQUIRE((hit.primitive == no_primitive || nearest.packet.reach[lane] == hit.t));
                REQUIRE((any.packet.primitive[lane] != no_primitive) == (hit.primitive != no_primitive));
                hits += hit.primitive != no_primitive;
            }
        }
        CHECK(hits > 2000);
        CHECK(together > 100); // both ways were taken, but where the whole grid is one voxel
        CHECK((alone > 100 || size[0] == 1));
    }
}

TEST_CASE("packet: finds what each of its rays finds alone in a core and its outskirts") {
    RandomNumbers random{std::mt19937(12)};
    CpuBackend backend;
    std::vector<Sphere<float>> spheres;
    for (int i = 0; i < 2000; ++i)
        spheres.push_back(i % 25 == 0 ? Sphere<float>{random.in_cube(), random(0.01, 0.1)}
                                      : Sphere<float>{0.03f * random.in_cube(), random(0.001, 0.003)});
    const std::vector<uint32_t> materials(spheres.size(), 0);
    const std::vector<Material> surfaces(1);
    SceneView<float> scene;
    scene.geometry.spheres = spheres;
    scene.geometry.sphere_materials = materials;
    scene.surfaces.materials = surfaces;
    GridBuilder<CpuBackend, float> builder(backend);
    builder.find_bounds(scene.geometry);
    builder.find_core(scene.geometry, false);
    builder.build(scene, {});
    REQUIRE(scene.outskirts.in_use());
    int together = 0, core = 0, outside = 0;
    for (int i = 0; i < 1500; ++i) {
        CAPTURE(i);
        Bundle rays(random, scene, i % 2 ? 0.02f : 0.1f, i % 3 ? infinity<float> : random(0.5, 4), false);
        const glm::vec3 target = 0.03f * random.in_cube();
        if (i % 4 == 0) // towards the core
            for (uint32_t lane = 0; lane < lanes; ++lane)
                if (lane % 7 != 6) {
                    Ray<float> ray = rays.based[lane].ray;
                    ray.direction = glm::normalize(target + 0.002f * random.in_cube() - ray.origin);
                    rays.based[lane] = rebase(SourcedRay<float>{ray, {}}, scene.geometry.bounds);
                    rays.packet.set(lane, rays.based[lane], 0.0f, infinity<float>);
                }
        Bundle before = rays;
        bool split = false;
        search_packet<Sought::nearest>(scene, rays.packet, [&](uint32_t) { split = true; });
        if (split)
            continue;
        ++together;
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            if (lane % 7 == 6)
                continue;
            const float reach = before.packet.reach[lane] + before.packet.offset[lane];
            const Hit<float> hit = find_nearest<RoundShapes::spheres>(scene, before.based[lane], {}, 0.0f, reach, 0);
            REQUIRE(rays.packet.primitive[lane] == hit.primitive);
            REQUIRE((hit.primitive == no_primitive || rays.packet.reach[lane] == hit.t));
            if (hit.primitive != no_primitive)
                (hit.primitive % 25 == 0 ? outside : core) += 1;
        }
    }
    CHECK(together > 300);
    CHECK(core > 300);
    CHECK(outside > 300);
}

TEST_CASE("packet: pictures are those of single rays, bit for bit") {
    FrameSettings settings;
    settings.width = 75; // tiles stick out
    settings.height = 50;
    PipelineRenderer<CpuBackend> packets(0u);
    PipelineRenderer<SingleRays> single(0u);
    const RandomSceneSpec specs[] = {{},
                                     {.spheres = 3000, .radius = 0.05},
                                     {.shape = Shape::flat},
                                     {.ground = false},
                                     {.spheres = 3000, .shape = Shape::stadium, .radius = 0.003}};
    for (uint32_t seed = 0; seed < 15; ++seed) {
        CAPTURE(seed);
        SceneProgram scene = random_scene(seed, specs[seed % 5]);
        if (seed % 5 == 4)
            scene.camera.location = {0.5, 0.3, 0.2 - 0.1 * seed};
        if (seed % 3 == 0)
            scene.lights[0].shadowless = 1;
        if (seed % 3 == 1)
            for (size_t i = 0; i < scene.materials.size(); i += 2)
                scene.materials[i].flags |= material_no_shadow;
        if (seed == 5) // inside the ground sphere, and inside others
            scene.camera.location = scene.spheres.back().center;
        for (const Tolerances tolerances : {Tolerances::exact, Tolerances::povray})
            for (const uint32_t samples : {1u, 4u}) {
                settings.tolerances = tolerances;
                settings.samples = samples;
                settings.antialiasing = {};
                CHECK(same_bits(render(packets, scene, settings), render(single, scene, settings)));
            }
        settings.samples = 1;
        settings.antialiasing = {.method = Antialiasing::Method::blocks, .threshold = 0.1f, .depth = 3};
        CHECK(same_bits(render(packets, scene, settings), render(single, scene, settings)));
    }
}
