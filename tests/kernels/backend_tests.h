// SPDX-License-Identifier: Apache-2.0
// What every backend must do. Included once per compiler; BACKENDS lists the backends that it compiles.
#pragma once
#include "renderer/frame_renderer.h"
#include "tests/kernels/test_scene.h"

#include "kernels/grid_build.h"
#include "kernels/half.h"

#include <cstring>
#include <doctest/doctest.h>
#include <memory>
#include <numeric>
#include <vector>

namespace proxima::test {

/// The renderer of a backend; each including file defines it for its own.
template <class Backend> std::unique_ptr<FrameRenderer> make_renderer();

struct WriteSquares {
    std::span<uint32_t> squares;
    HD void operator()(uint32_t i) const { squares[i] = i * i; }
};

struct SumAndMax {
    uint64_t sum = 0;
    uint32_t largest = 0;
    HD static SumAndMax combine(const SumAndMax& a, const SumAndMax& b) {
        return {a.sum + b.sum, larger(a.largest, b.largest)};
    }
};

/// Item -> what it takes is marked as its own: mostly little, now and then more than a warp takes together.
struct TakeSome {
    std::span<uint64_t> counter;
    std::span<uint32_t> owners;

    HD static uint32_t amount(uint32_t item) { return item % 97 == 5 ? 300 : item % 3 == 0 ? 0 : item % 11; }
    HD void operator()(uint32_t item) const {
        if (item % 7 == 0 && amount(item) == 0)
            return;
        const uint64_t first = take_from(&counter[0], amount(item));
        for (uint32_t i = 0; i < amount(item); ++i)
            owners[first + i] = item;
    }
};

struct MeasureNumber {
    std::span<const uint32_t> numbers;
    HD SumAndMax operator()(uint32_t i) const { return {numbers[i], numbers[i]}; }
};

inline bool same_bits(const Image& a, const Image& b) {
    return a.rgb.size() == b.rgb.size() && std::memcmp(a.rgb.data(), b.rgb.data(), a.rgb.size() * sizeof(float)) == 0;
}

} // namespace proxima::test

using namespace proxima;
using namespace proxima::test;

TEST_CASE_TEMPLATE("backend: for_each reaches every index once", Backend, BACKENDS) {
    Backend backend;
    typename Backend::template Buffer<uint32_t> squares(backend);
    for (const uint32_t count : {0u, 1u, 127u, 128u, 100003u}) {
        squares.resize(count);
        backend.for_each(count, WriteSquares{squares.view()});
        std::vector<uint32_t> result(count);
        squares.download(result.data());
        bool right = true;
        for (uint32_t i = 0; i < count; ++i)
            right &= result[i] == i * i;
        CHECK(right);
    }
}

TEST_CASE_TEMPLATE("backend: scan and reduce agree with plain loops", Backend, BACKENDS) {
    Backend backend;
    typename Backend::template Buffer<uint32_t> buffer(backend);
    for (const size_t count : {size_t(1), size_t(65535), size_t(65536), size_t(300001)}) {
        std::vector<uint32_t> numbers(count);
        for (size_t i = 0; i < count; ++i)
            numbers[i] = uint32_t(i * 2654435761u) >> 16; // their sum exceeds 32 bits in the last case
        buffer.upload(count, [&](size_t i) { return numbers[i]; });
        const SumAndMax total = backend.template reduce<SumAndMax>(uint32_t(count), MeasureNumber{buffer.view()});
        CHECK(total.sum == std::accumulate(numbers.begin(), numbers.end(), uint64_t(0)));
        CHECK(total.largest == *std::max_element(numbers.begin(), numbers.end()));
        std::vector<uint32_t> result(count);
        buffer.download(result.data());
        CHECK(result == numbers);
        CHECK(buffer.read(count - 1) == numbers.back());
    }
}

TEST_CASE_TEMPLATE("backend: what items take from a counter belongs to them alone", Backend, BACKENDS) {
    Backend backend;
    typename Backend::template Buffer<uint64_t> counter(backend);
    typename Backend::template Buffer<uint32_t> owners(backend);
    for (const uint32_t items : {1u, 31u, 1000u, 100'003u}) {
        uint64_t sum = 0;
        for (uint32_t i = 0; i < items; ++i)
            sum += TakeSome::amount(i);
        counter.resize(1);
        counter.fill_bytes(0);
        owners.resize(sum + 1);
        owners.fill_bytes(0xff);
        backend.for_each(items, TakeSome{counter.view(), owners.view()});
        CHECK(counter.read(0) == sum);
        std::vector<uint32_t> result(sum + 1), taken(items);
        owners.download(result.data());
        for (uint64_t place = 0; place < sum; ++place) {
            REQUIRE(result[place] < items);
            ++taken[result[place]];
        }
        CHECK(result[sum] == 0xffffffff);
        for (uint32_t i = 0; i < items; ++i)
            REQUIRE(taken[i] == TakeSome::amount(i));
    }
}

TEST_CASE_TEMPLATE("backend: buffers keep their memory when they shrink", Backend, BACKENDS) {
    Backend backend;
    typename Backend::template Buffer<uint32_t> buffer(backend);
    buffer.resize(1000000);
    const uint64_t held = backend.memory().now();
    CHECK(held >= 4000000);
    buffer.resize(10);
    CHECK(buffer.size() == 10);
    buffer.resize(1000000);
    CHECK(backend.memory().now() == held);
    CHECK(backend.memory().peak() == held);
}

TEST_CASE_TEMPLATE("frame: grids, clouds and brute force make the same bits at every resolution", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const RandomSceneSpec specs[] = {
        {.spheres = 300},
        {.spheres = 300, .shape = Shape::flat},
        {.spheres = 100, .shape = Shape::line},
        {.spheres = 300, .shape = Shape::clusters, .radius = 0.02, .mirrors = true},
        {.spheres = 200, .mirrors = true, .glass = true, .ellipsoids = true},
        {.spheres = 1, .ground = false},
        {.spheres = 0, .ground = false},
        {.spheres = 0},
        {.spheres = 6000, .radius = 0.05, .glass = true},
    };
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (const Tolerances tolerances : {Tolerances::exact, Tolerances::povray})
            for (uint32_t seed = 0; const RandomSceneSpec& spec : specs) {
                const SceneProgram scene = random_scene(++seed, spec);
                CAPTURE(seed);
                FrameSettings settings;
                settings.width = 80;
                settings.height = 60;
                settings.precision = precision;
                settings.tolerances = tolerances;
                settings.accelerator = Accelerator::brute;
                const Image brute = render(*renderer, scene, settings);
                settings.accelerator = Accelerator::grid;
                for (const std::array<uint32_t, 3> grid : {std::array<uint32_t, 3>{0, 0, 0}, {1, 1, 1}, {3, 40, 7}}) {
                    settings.grid = grid;
                    CHECK(same_bits(brute, render(*renderer, scene, settings)));
                }
                settings.accelerator = Accelerator::cloud;
                settings.grid = {0, 0, 0};
                for (const Metric metric :
                     {Metric::chessboard, Metric::city_block, Metric::euclidean, Metric::octant}) {
                    settings.metric = metric;
                    settings.brick = 1u << (seed + uint32_t(metric)) % 4;
                    CHECK(same_bits(brute, render(*renderer, scene, settings)));
                }
                settings.accelerator = Accelerator::automatic;
                CHECK(same_bits(brute, render(*renderer, scene, settings)));
            }
}

TEST_CASE_TEMPLATE("frame: a cluster in a wide scene has a grid of its own, and the picture is the same", Backend,
                   BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const RandomSceneSpec specs[] = {
        {.spheres = 4000, .shape = Shape::stadium, .radius = 0.003},
        {.spheres = 4000, .shape = Shape::stadium, .radius = 0.003, .mirrors = true, .ground = false},
        {.spheres = 2000, .shape = Shape::stadium, .radius = 0.005, .glass = true, .ellipsoids = true},
    };
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (uint32_t seed = 0; const RandomSceneSpec& spec : specs)
            for (const double distance : {0.2, 1.2, 8.0}) { // the last one is outside
                SceneProgram scene = random_scene(++seed, spec);
                scene.camera.location = {0.5, 0.3, 0.2 - distance};
                CAPTURE(seed);
                FrameSettings settings;
                settings.width = 80;
                settings.height = 60;
                settings.precision = precision;
                settings.accelerator = Accelerator::brute;
                const Image brute = render(*renderer, scene, settings);
                FrameStatistics statistics;
                for (const Accelerator accelerator : {Accelerator::grid, Accelerator::cloud, Accelerator::automatic})
                    for (const Metric metric : {Metric::chessboard, Metric::euclidean, Metric::octant}) {
                        settings.accelerator = accelerator;
                        settings.metric = metric;
                        CHECK(same_bits(brute, render(*renderer, scene, settings, &statistics)));
                        CHECK(statistics.outliers > 20);
                        CHECK(statistics.outliers < spec.spheres / 16);
                    }
                settings.accelerator = Accelerator::grid;
                const auto tracer = make_renderer<Backend>();
                tracer->relay_from(make_renderer<Backend>());
                CHECK(same_bits(brute, render(*tracer, scene, settings)));
                settings.grid = {20, 30, 10}; // of all bounds
                CHECK(same_bits(brute, render(*renderer, scene, settings, &statistics)));
                CHECK(statistics.outliers == 0);
            }
}

TEST_CASE_TEMPLATE("frame: two renderings of a scene are the same bits", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = random_scene(4, {.spheres = 5000, .radius = 0.05, .mirrors = true});
    FrameSettings settings;
    settings.width = 100;
    settings.height = 75;
    settings.samples = 3;
    CHECK(same_bits(render(*renderer, scene, settings), render(*make_renderer<Backend>(), scene, settings)));
}

TEST_CASE_TEMPLATE("frame: light, shadow, mirror and glass are what POV-Ray's formulas say", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const auto light_of = [&](const SceneProgram& scene) { return middle(render(*renderer, scene, single_ray())); };
    const auto glows = [](const glm::vec3& color) { return SurfaceSpec{.color = {color}, .finish = glowing()}; };

    SUBCASE("the background where nothing is hit") {
        SceneProgram scene = empty_scene();
        scene.background = {0.25f, 0.5f, 0.75f};
        CHECK(light_of(scene) == scene.background);
    }
    SUBCASE("ambient light and emission") {
        SceneProgram scene = empty_scene();
        SurfaceSpec surface{.color = {{1, 0.5f, 0.25f}}};
        surface.finish.ambient = glm::vec3(0.2f);
        surface.finish.emission = glm::vec3(0.3f);
        scene.ambient_light = {2, 1, 1};
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, surface));
        CHECK(light_of(scene).x == doctest::Approx(0.7));
        CHECK(light_of(scene).y == doctest::Approx(0.25));
    }
    SUBCASE("a light behind the camera, faded, in shadow, or without shadow") {
        SceneProgram scene = empty_scene();
        SurfaceSpec surface;
        surface.finish.ambient = glm::vec3(0.0f);
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, surface));
        add_light(scene, {0, 0, -11});
        CHECK(light_of(scene).x == doctest::Approx(0.6));
        scene.lights[0].fade_distance = 5;
        scene.lights[0].fade_power = 2;
        CHECK(light_of(scene).x == doctest::Approx(0.6 * 0.4));
        add_sphere(scene, {0, 0, -8}, 1, 0);
        CHECK(light_of(scene).x == 0);
        scene.lights[0].shadowless = 1;
        CHECK(light_of(scene).x == doctest::Approx(0.6 * 0.4));
        scene.lights[0].shadowless = 0;
        scene.materials[0].flags |= material_no_shadow;
        CHECK(light_of(scene).x == doctest::Approx(0.6 * 0.4));
    }
    SUBCASE("a mirror shows what is behind the camera, up to the trace level") {
        SceneProgram scene = empty_scene();
        scene.background = {1, 1, 1};
        SurfaceSpec mirror{.color = {glm::vec3(0.0f)}, .finish = glowing()};
        mirror.finish.reflection_min = mirror.finish.reflection_max = glm::vec3(0.5f);
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, mirror));
        CHECK(light_of(scene).x == doctest::Approx(0.5));
        add_sphere(scene, {0, 0, -10}, 1, 0); // the ray goes to and fro
        CHECK(light_of(scene).x == 0);
        scene.spheres[1].center.x = 1e9;
        scene.max_trace_level = 1;
        CHECK(light_of(scene).x == 0);
        scene.max_trace_level = 5;
        scene.finishes[0].reflection_exponent = 2; // 0.5 * sqrt(light)
        scene.background = {0.25f, 0.25f, 0.25f};
        CHECK(light_of(scene).x == doctest::Approx(0.25));
    }
    SUBCASE("light through a filter twice, and its shadow") {
        SceneProgram scene = empty_scene();
        scene.background = {1, 1, 1};
        SurfaceSpec veil{.color = {{1, 0.5f, 0}, 0.5f, 0.25f}, .finish = glowing(0)};
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, veil));
        CHECK(light_of(scene).x == doctest::Approx(0.75 * 0.75));
        CHECK(light_of(scene).y == doctest::Approx(0.5 * 0.5));
        SurfaceSpec wall;
        wall.finish.ambient = glm::vec3(0.0f);
        scene.planes.push_back({{0, 0, -1}, -3, add_material(scene, wall)});
        scene.camera.location = {0, 0, 2};
        add_light(scene, {0, 0, -7});
        CHECK(light_of(scene).x == doctest::Approx(0.6 * 0.75 * 0.75));
    }
    SUBCASE("layers: the upper one veils the lower one") {
        SceneProgram scene = empty_scene();
        const uint32_t material = add_material(scene, glows({1, 0, 0}));
        add_layer(scene, {{0, 0, 1}, 0, 0.75f}, glowing());
        scene.materials.back().flags = 0; // the lowest layer is opaque
        add_sphere(scene, {0, 0, 0}, 1, material);
        CHECK(light_of(scene).x == doctest::Approx(0.75));
        CHECK(light_of(scene).z == doctest::Approx(0.25));
    }
    SUBCASE("a fading interior") {
        SceneProgram scene = empty_scene();
        scene.background = {1, 1, 1};
        SurfaceSpec glass{.color = {glm::vec3(1.0f), 0, 1}, .finish = glowing(0)};
        glass.interior = {1.5f, 1, 2, {0.2f, 0, 0}};
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, glass));
        CHECK(light_of(scene).x == doctest::Approx(0.36)); // 0.2 + 0.8 / (1 + 2^2)
        CHECK(light_of(scene).y == doctest::Approx(0.2));
    }
    SUBCASE("a ball lens brings rays together") {
        SceneProgram scene = empty_scene();
        SurfaceSpec glass{.color = {glm::vec3(1.0f), 0, 1}, .finish = glowing(0)};
        glass.interior.ior = 1.5f;
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, glass));
        // A ray parallel to the axis at height 0.5 meets the axis at z = 1.37; without the lens it would not.
        add_sphere(scene, {0, 0, 1.37}, 0.02, add_material(scene, glows({0, 1, 0})));
        scene.camera.location = {0.5, 0, -5};
        scene.camera.direction = {0, 0, 1};
        CHECK(light_of(scene).y == doctest::Approx(1));
        scene.interiors[0].ior = 1;
        CHECK(light_of(scene).y == 0);
    }
    SUBCASE("total reflection keeps a ray inside") {
        SceneProgram scene = empty_scene();
        scene.background = {1, 1, 1};
        SurfaceSpec glass{.color = {glm::vec3(1.0f), 0, 1}, .finish = glowing(0)};
        glass.interior.ior = 1.5f;
        add_sphere(scene, {0, 0, 0}, 1, add_material(scene, glass));
        scene.camera.location = {0.9, 0, 0}; // sin(angle) = 0.9 > 1 / 1.5
        CHECK(light_of(scene).x == 0);
        scene.camera.location = {0.5, 0, 0};
        CHECK(light_of(scene).x == doctest::Approx(1));
    }
}

TEST_CASE_TEMPLATE("frame: waves of a deep scene make the picture of a shallow one", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    SceneProgram scene = random_scene(9, {.spheres = 30, .radius = 0.5, .glass = true, .ground = false});
    scene.background = {1, 1, 1};
    scene.adc_bailout = 0.05f; // no path lives for more than a few levels
    FrameSettings settings;
    settings.width = 320;
    settings.height = 240;
    scene.max_trace_level = 40;
    const Image shallow = render(*renderer, scene, settings);
    scene.max_trace_level = 256;
    CHECK(same_bits(shallow, render(*renderer, scene, settings)));
}

TEST_CASE_TEMPLATE("frame: more than 32 nested transparent objects are an error that names the limit", Backend,
                   BACKENDS) {
    SceneProgram scene = empty_scene();
    scene.max_trace_level = 200;
    const uint32_t glass = add_material(scene, {.color = {glm::vec3(1.0f), 0, 1}});
    for (int i = 0; i < 32; ++i)
        add_sphere(scene, {0, 0, 0}, 2 - 0.01 * i, glass);
    CHECK_NOTHROW(render(*make_renderer<Backend>(), scene, single_ray()));
    add_sphere(scene, {0, 0, 0}, 0.5, glass);
    bool thrown = false;
    try {
        render(*make_renderer<Backend>(), scene, single_ray());
    } catch (const DeviceError& error) {
        thrown = error.kind == DeviceError::Kind::scene && std::string(error.what()).find("32") != std::string::npos;
    }
    CHECK(thrown);
}

TEST_CASE_TEMPLATE("frame: statistics tell how the frame was made", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = random_scene(2, {.spheres = 1000, .radius = 0.05});
    FrameSettings settings;
    settings.width = settings.height = 32;
    settings.grid = {5, 6, 7};
    FrameStatistics statistics;
    render(*renderer, scene, settings, &statistics);
    CHECK(statistics.method == "grid");
    CHECK(statistics.grid == std::array<uint32_t, 3>{5, 6, 7});
    CHECK(statistics.occupied <= 5 * 6 * 7);
    CHECK(statistics.references >= 1000);
    CHECK(statistics.peak_device_bytes > 20000);
    settings.accelerator = Accelerator::brute;
    render(*renderer, scene, settings, &statistics);
    CHECK(statistics.method == "brute");
    CHECK(statistics.references == 0);
}

TEST_CASE_TEMPLATE("frame: a picture is the same in one piece and in bands, in any order", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = random_scene(3, {.spheres = 300, .radius = 0.1, .mirrors = true, .glass = true});
    using Method = Antialiasing::Method;
    for (const Method method : {Method::none, Method::grid, Method::blocks, Method::squares}) {
        CAPTURE(int(method));
        FrameSettings settings;
        settings.width = 83;
        settings.height = 101;
        settings.samples = method == Method::none ? 3 : 1;
        settings.antialiasing = {method, 0.1f, 2};
        const Image whole = render(*renderer, scene, settings);
        Image image;
        FrameStatistics statistics;
        for (const uint32_t first : {32u, 0u, 64u}) {
            settings.rows = {first, first == 64 ? settings.height - first : 32};
            statistics = renderer->render(settings, image);
            CHECK(statistics.method == "grid");
        }
        CHECK(same_bits(whole, image));
        CHECK(statistics.build_ms == 0); // the first band built it for all
        CHECK(statistics.references > 300);
    }
}

TEST_CASE_TEMPLATE("frame: one that is cancelled ends by an exception", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    renderer->set_scene(random_scene(3, {}), Precision::float32);
    renderer->cancel();
    Image image;
    bool cancelled = false;
    try {
        renderer->render({}, image);
    } catch (const FrameCancelled&) {
        cancelled = true;
    }
    CHECK(cancelled);
}

TEST_CASE_TEMPLATE("frame: whoever watches is told of every step, in order", Backend, BACKENDS) {
    struct Watch : StepWatch {
        std::vector<FrameStep> begun, ended;
        void begin(FrameStep step) override { begun.push_back(step); }
        void end(FrameStep step, Time, Time) override { ended.push_back(step); }
    } watch;
    const auto renderer = make_renderer<Backend>();
    renderer->set_watch(&watch);
    renderer->set_scene(random_scene(3, {}), Precision::float32);
    FrameSettings settings;
    settings.accelerator = Accelerator::cloud;
    Image image;
    renderer->render(settings, image);
    CHECK(watch.begun == std::vector{FrameStep::build, FrameStep::map, FrameStep::trace, FrameStep::read_back});
    CHECK(watch.ended == watch.begun);
}

TEST_CASE_TEMPLATE("frame: a picture is the same in a grid that another device has built", Backend, BACKENDS) {
    const SceneProgram scene = random_scene(3, {.spheres = 300, .radius = 0.1, .mirrors = true});
    for (const Accelerator accelerator : {Accelerator::grid, Accelerator::cloud, Accelerator::brute})
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            FrameSettings settings;
            settings.width = 83;
            settings.height = 61;
            settings.accelerator = accelerator;
            settings.precision = precision;
            const auto alone = make_renderer<Backend>(), tracer = make_renderer<Backend>();
            tracer->relay_from(make_renderer<Backend>());
            FrameStatistics statistics;
            CHECK(same_bits(render(*alone, scene, settings), render(*tracer, scene, settings, &statistics)));
            CHECK(statistics.relay_ms > 0);
            CHECK(statistics.note.empty());
        }
}

TEST_CASE_TEMPLATE("frame: a picture in halves is the picture, rounded", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    FrameSettings settings;
    settings.width = 61;
    settings.height = 70;
    const Image floats = render(*renderer, random_scene(3, {.spheres = 300}), settings);
    settings.in_halves = true;
    Image image;
    for (const Rows& rows : {Rows{32, 38}, Rows{0, 32}}) {
        settings.rows = rows;
        renderer->render(settings, image);
        renderer->lock_pages(image);
    }
    REQUIRE(image.halves.size() == floats.rgb.size());
    CHECK(image.rgb.empty());
    uint32_t wrong = 0;
    for (size_t i = 0; i < floats.rgb.size(); ++i)
        wrong += image.halves[i] != half_bits(floats.rgb[i]);
    CHECK(wrong == 0);
}
