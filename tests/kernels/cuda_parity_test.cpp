// SPDX-License-Identifier: Apache-2.0
// The GPU against the CPU: the same hits, and light within 1e-5.
#include "renderer/device_error.h"
#include "tests/kernels/test_scene.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace proxima;
using namespace proxima::test;

namespace {

double largest_difference(const Image& a, const Image& b) {
    double largest = a.rgb.size() == b.rgb.size() ? 0 : infinity<double>;
    for (size_t i = 0; i < a.rgb.size() && i < b.rgb.size(); ++i)
        largest = std::max(largest, std::abs(double(a.rgb[i]) - b.rgb[i]));
    return largest;
}

} // namespace

TEST_CASE("cuda: every pixel shows what the CPU shows") {
    const RandomSceneSpec specs[] = {
        {.spheres = 5000, .radius = 0.1},
        {.spheres = 1000, .mirrors = true, .ellipsoids = true},
        {.spheres = 200, .radius = 0.3, .glass = true},
        {.spheres = 100000, .shape = Shape::clusters, .radius = 0.002},
    };
    const auto cpu = make_cpu_renderer(0);
    const auto cuda = make_cuda_renderer(0);
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (uint32_t seed = 20; const RandomSceneSpec& spec : specs) {
            const SceneProgram scene = random_scene(++seed, spec);
            CAPTURE(seed);
            FrameSettings settings;
            settings.width = 320;
            settings.height = 240;
            settings.precision = precision;
            CHECK(largest_difference(render(*cpu, scene, settings), render(*cuda, scene, settings)) <= 1e-5);
        }
}

TEST_CASE("cuda: layers are those of the CPU") {
    const auto cpu = make_cpu_renderer(0);
    const auto cuda = make_cuda_renderer(0);
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (const bool mirrors : {false, true}) {
            const SceneProgram scene = random_scene(31, {.spheres = 60000, .radius = 0.03, .mirrors = mirrors});
            FrameSettings settings;
            settings.width = 320;
            settings.height = 240;
            settings.precision = precision;
            settings.accelerator = Accelerator::cloud;
            settings.density = 32; // each device would choose its own, and steps show it
            settings.aovs = {true, true, true, true};
            const Image a = render(*cpu, scene, settings), b = render(*cuda, scene, settings);
            REQUIRE(a.aovs.size() == 320 * 240);
            REQUIRE(b.aovs.size() == 320 * 240);
            uint32_t other_ids = 0, other_steps = 0;
            double depth_error = 0, normal_error = 0;
            for (size_t i = 0; i < a.aovs.size(); ++i) {
                other_ids += a.aovs[i].id != b.aovs[i].id;
                other_steps += a.aovs[i].steps != b.aovs[i].steps;
                depth_error = std::max(depth_error, std::abs(double(a.aovs[i].depth) - b.aovs[i].depth));
                normal_error = std::max(normal_error, double(glm::length(a.aovs[i].normal - b.aovs[i].normal)));
            }
            CHECK(other_ids == 0);
            CHECK(other_steps == 0);
            CHECK(depth_error <= 1e-5);
            CHECK(normal_error <= 1e-5);
        }
}

TEST_CASE("cuda: lights, patterns, sky, fog and antialiasing are those of the CPU") {
    SceneProgram scene = random_scene(41, {.spheres = 200, .radius = 0.3, .mirrors = true, .glass = true});
    scene.lights[0].kind = LightKind::spot;
    scene.lights[0].direction = glm::normalize(Vec3<double>(-5, -10, 10));
    scene.lights[0].radius = 0.98;
    scene.lights[0].falloff = 0.9;
    scene.lights[1].area = 0;
    scene.area_lights.push_back(
        {.axis1 = {2, 0, 0}, .axis2 = {0, 2, 0}, .columns = 5, .rows = 5, .circular = 1, .jitter = 1, .adaptive = 1});
    scene.patterns.push_back({.wave = Wave::triangle, .frequency = 2, .stop_count = 2});
    scene.patterns.push_back({.first_stop = 2, .stop_count = 2}); // a pigment map of a checker and the first pigment
    const uint32_t checker = uint32_t(scene.pigments.size()), mapped = checker + 1;
    scene.color_stops = {{0, {{1, 0.5f, 0}}}, {1, {{0, 0.5f, 1}, 0.25f, 0.5f}}, {0.2f, {}, checker}, {0.9f, {}, 0}};
    scene.pigments.push_back(
        {.kind = PigmentKind::checker, .color = {{1, 0, 0}, 0, 0.7f}, .second_color = {{0, 0, 1}}});
    scene.pigments.push_back({.kind = PigmentKind::onion, .pattern = 1});
    scene.layers[0].pigment = mapped;
    scene.pigments[0].kind = PigmentKind::gradient;
    scene.pigments[1].kind = PigmentKind::leopard;
    scene.sky.pigments = {1, 0, mapped};
    scene.fogs.push_back({.color = {0.5f, 0.6f, 0.7f}, .distance = 20});
    const auto cpu = make_cpu_renderer(0);
    const auto cuda = make_cuda_renderer(0);
    using Method = Antialiasing::Method;
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (const Method method : {Method::none, Method::grid, Method::blocks, Method::squares}) {
            CAPTURE(int(method));
            FrameSettings settings;
            settings.width = 160;
            settings.height = 120;
            settings.precision = precision;
            settings.antialiasing.method = method;
            const Image a = render(*cpu, scene, settings), b = render(*cuda, scene, settings);
            // sin, pow and exp differ in their last bits: a colour at the threshold, or a place that jitter moves to an
            // edge, may fall on the other side.
            size_t far = 0;
            for (size_t i = 0; i < a.rgb.size(); ++i)
                far += std::abs(a.rgb[i] - b.rgb[i]) > 1e-4f;
            CHECK(far <= a.rgb.size() / 1000);
        }
}

TEST_CASE("cuda: the same primitives are hit, to the last bit of a colour that names them") {
    SceneProgram scene = random_scene(31, {.spheres = 3000, .radius = 0.1, .ground = false});
    scene.lights.clear();
    scene.materials.clear();
    for (size_t i = 0; i < scene.spheres.size(); ++i)
        scene.sphere_materials[i] =
            add_material(scene, {.color = {glm::vec3(float(i % 256), float(i / 256), 1)}, .finish = glowing()});
    FrameSettings settings;
    settings.width = 640;
    settings.height = 480;
    CHECK(render(*make_cpu_renderer(0), scene, settings).rgb == render(*make_cuda_renderer(0), scene, settings).rgb);
}

TEST_CASE("cuda: a device that is not there is an error that says so") {
    CHECK_THROWS_AS(make_cuda_renderer(1000), DeviceError);
}
