// SPDX-License-Identifier: Apache-2.0
// What every backend must know of the layers beside a picture. Included behind motion_backend_tests.h.
#pragma once
#include <cmath>

namespace proxima::test {

constexpr AovLayers all_layers{true, true, true, true};

inline FrameSettings layered(uint32_t width, uint32_t height, Precision precision = Precision::float32) {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.precision = precision;
    settings.aovs = all_layers;
    return settings;
}

inline bool same_surfaces(const Image& a, const Image& b) {
    return a.aovs.size() == b.aovs.size() &&
           std::equal(a.aovs.begin(), a.aovs.end(), b.aovs.begin(), [](const AovSample& x, const AovSample& y) {
               return x.depth == y.depth && x.normal == y.normal && x.id == y.id;
           });
}

inline bool same_layers(const Image& a, const Image& b) {
    return same_surfaces(a, b) && std::equal(a.aovs.begin(), a.aovs.end(), b.aovs.begin(),
                                             [](const AovSample& x, const AovSample& y) { return x.steps == y.steps; });
}

/// What a pixel of a scene of spheres shows, from the formulas: for the camera of empty_scene().
inline AovSample expected_sample(const SceneProgram& scene, const FrameSettings& settings, uint32_t x, uint32_t y) {
    const Camera<double>& camera = scene.camera;
    const Vec3<double> direction = glm::normalize(camera.direction + ((x + 0.5) / settings.width - 0.5) * camera.right +
                                                  (0.5 - (y + 0.5) / settings.height) * camera.up);
    AovSample sample;
    double nearest = infinity<double>;
    for (size_t i = 0; i < scene.spheres.size(); ++i) {
        const Sphere<double>& sphere = scene.spheres[i];
        const Vec3<double> away = camera.location - sphere.center;
        const double b = glm::dot(away, direction), c = glm::dot(away, away) - sphere.radius * sphere.radius;
        if (b * b < c || -b - std::sqrt(b * b - c) >= nearest || -b - std::sqrt(b * b - c) < 0)
            continue;
        nearest = -b - std::sqrt(b * b - c);
        sample.depth = float(nearest * direction.z);
        sample.normal = glm::vec3((away + nearest * direction) / sphere.radius);
        sample.id = uint32_t(i + 1);
    }
    return sample;
}

} // namespace proxima::test

TEST_CASE_TEMPLATE("aov: depth, normal and number of a sphere are what the formulas say", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    // 8,000 spheres are stored in another order than the scene's. Mirrors are followed in double, the others are not.
    for (const RandomSceneSpec& spec :
         {RandomSceneSpec{.spheres = 20, .ground = false},
          RandomSceneSpec{.spheres = 8000, .radius = 0.03, .ground = false},
          RandomSceneSpec{.spheres = 300, .mirrors = true, .glass = true, .ground = false}})
        for (const Precision precision : {Precision::float32, Precision::float64}) {
            const SceneProgram scene = random_scene(6, spec);
            const FrameSettings settings = layered(97, 71, precision);
            const Image image = render(*renderer, scene, settings);
            REQUIRE(image.aovs.size() == 97 * 71);
            uint32_t other_id = 0, hits = 0;
            double depth_error = 0, normal_error = 0;
            for (uint32_t y = 0; y < 71; ++y)
                for (uint32_t x = 0; x < 97; ++x) {
                    const AovSample expected = expected_sample(scene, settings, x, y);
                    const AovSample& sample = image.aovs[y * 97 + x];
                    if (sample.id != expected.id) {
                        ++other_id;
                        continue;
                    }
                    hits += sample.id > 0;
                    depth_error = std::max(depth_error, std::abs(double(sample.depth) - expected.depth));
                    normal_error = std::max(normal_error, double(glm::length(sample.normal - expected.normal)));
                }
            const bool is_exact = precision == Precision::float64;
            CHECK(hits > 500);
            CHECK(other_id <= (is_exact ? 0 : 1)); // an outline that float sees elsewhere
            CHECK(depth_error < (is_exact ? 1e-6 : 1e-3));
            CHECK(normal_error < (is_exact ? 1e-6 : 1e-1)); // where a small sphere is only touched
        }
}

TEST_CASE_TEMPLATE("aov: spheres are counted first, then ellipsoids, then planes, and nothing is 0", Backend,
                   BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    SceneProgram scene = empty_scene();
    const uint32_t material = add_material(scene, {});
    const auto sample = [&] { return render(*renderer, scene, layered(1, 1)).aovs.at(0); };
    CHECK(sample().id == 0);
    CHECK(sample().depth == 1e10f);
    CHECK(sample().normal == glm::vec3(0.0f));
    CHECK(sample().steps == 0);
    scene.planes.push_back({{0, 0, -1}, -3, material}); // z = 3
    CHECK(sample().id == 1);
    CHECK(sample().depth == doctest::Approx(8));
    CHECK(sample().normal == glm::vec3(0, 0, -1));
    add_ellipsoid(scene, {Mat3<double>(2.0, 0, 0, 0, 1.0, 0, 0, 0, 0.5), {0, 0, 2}}, material);
    CHECK(sample().id == 1);
    CHECK(sample().depth == doctest::Approx(6.5));
    add_sphere(scene, {0, 0, 0}, 1, material);
    add_sphere(scene, {0, 0, 1}, 1, material);
    CHECK(sample().id == 1);
    CHECK(sample().depth == doctest::Approx(4));
    scene.spheres[0].center.x = 100;
    CHECK(sample().id == 2);
    scene.spheres[1].center.x = 100;
    CHECK(sample().id == 3);
}

TEST_CASE_TEMPLATE("aov: what the camera does not see is not there, and inside a sphere the normal faces the eye",
                   Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    SceneProgram scene = empty_scene();
    const uint32_t visible = add_material(scene, {});
    const uint32_t glass = add_material(scene, {.color = {glm::vec3(1.0f), 0, 1}});
    const uint32_t unseen = add_material(scene, {.flags = material_no_image});
    const auto sample = [&] { return render(*renderer, scene, layered(1, 1)).aovs.at(0); };
    add_sphere(scene, {0, 0, -3}, 0.5, unseen);
    add_sphere(scene, {0, 0, 0}, 1, visible);
    CHECK(sample().id == 2);
    add_sphere(scene, {0, 0, -3}, 0.25, glass); // however clear it is
    CHECK(sample().id == 3);
    CHECK(sample().depth == doctest::Approx(1.75));
    scene.camera.location = {0, 0, 0.5};
    CHECK(sample().id == 2);
    CHECK(sample().depth == doctest::Approx(0.5));
    CHECK(sample().normal == glm::vec3(0, 0, -1));
}

TEST_CASE_TEMPLATE("aov: depth is along the direction of view", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    SceneProgram scene = empty_scene();
    scene.planes.push_back({{0, 0, -1}, -3, add_material(scene, {})});
    for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
        scene.camera.kind = kind;
        for (const AovSample& sample : render(*renderer, scene, layered(9, 7)).aovs)
            CHECK(sample.depth == doctest::Approx(8)); // in the corners too
    }
}

TEST_CASE_TEMPLATE("aov: grids, clouds and brute force know the same surfaces", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    for (const Precision precision : {Precision::float32, Precision::float64})
        for (const Tolerances tolerances : {Tolerances::exact, Tolerances::povray})
            for (const RandomSceneSpec& spec :
                 {RandomSceneSpec{.spheres = 300},
                  RandomSceneSpec{.spheres = 6000, .shape = Shape::clusters, .radius = 0.02},
                  RandomSceneSpec{.spheres = 200, .mirrors = true, .glass = true, .ellipsoids = true}}) {
                const SceneProgram scene = random_scene(8, spec);
                FrameSettings settings = layered(80, 60, precision);
                settings.tolerances = tolerances;
                settings.accelerator = Accelerator::brute;
                const Image brute = render(*renderer, scene, settings);
                for (const AovSample& sample : brute.aovs)
                    REQUIRE(sample.steps == 0);
                settings.accelerator = Accelerator::grid;
                const Image grid = render(*renderer, scene, settings);
                CHECK(same_surfaces(grid, brute));
                CHECK(same_bits(grid, brute));
                settings.grid = {3, 40, 7};
                CHECK(same_surfaces(render(*renderer, scene, settings), brute));
                settings.grid = {0, 0, 0};
                settings.accelerator = Accelerator::cloud;
                for (const Metric metric :
                     {Metric::chessboard, Metric::city_block, Metric::euclidean, Metric::octant}) {
                    settings.metric = metric;
                    CHECK(same_surfaces(render(*renderer, scene, settings), brute));
                }
            }
}

TEST_CASE_TEMPLATE("aov: a picture is the same with layers as without, in halves, bands, and with many samples",
                   Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = random_scene(3, {.spheres = 5000, .radius = 0.1, .mirrors = true});
    FrameSettings settings = layered(61, 100);
    const Image one = render(*renderer, scene, settings);
    settings.aovs = {};
    const Image plain = render(*renderer, scene, settings);
    CHECK(plain.aovs.empty());
    CHECK(same_bits(plain, one));

    settings.aovs = all_layers;
    for (const bool in_halves : {false, true}) {
        settings.in_halves = in_halves;
        Image bands;
        for (const Rows& rows : {Rows{64, 36}, Rows{0, 32}, Rows{32, 32}}) {
            settings.rows = rows;
            renderer->render(settings, bands);
        }
        CHECK(same_layers(bands, one));
    }
    settings.in_halves = false;
    settings.rows = {};
    settings.samples = 4;
    CHECK(same_layers(render(*renderer, scene, settings), one)); // of the pixel's middle
    settings.samples = 1;
    for (const Antialiasing::Method method :
         {Antialiasing::Method::grid, Antialiasing::Method::blocks, Antialiasing::Method::squares}) {
        settings.antialiasing = {.method = method, .threshold = 0.1f, .depth = 2};
        CHECK(same_layers(render(*renderer, scene, settings), one));
    }
}

TEST_CASE_TEMPLATE("aov: of several moments the layers are those of the middle one", Backend, BACKENDS) {
    const auto renderer = make_renderer<Backend>();
    const SceneProgram scene = moving_scene(5, {.spheres = 200});
    const FrameSettings settings = layered(40, 30);
    const MotionTime times[] = {{0.0625, 1, 0}, {0.25, 2, 0}, {0.75, 4, 0}};
    renderer->set_scene(scene, settings.precision);
    Image three, two, last;
    renderer->render(settings, times, three);
    CHECK(same_layers(three, render(*make_renderer<Backend>(), moved(scene, times[1]), settings)));
    renderer->render(settings, std::span(times).first(2), two);
    CHECK(same_layers(two, three));
    renderer->render(settings, std::span(times).last(1), last);
    CHECK_FALSE(same_layers(last, three));
}

TEST_CASE_TEMPLATE("aov: the steps of a frame do not depend on the frames before", Backend, BACKENDS) {
    // What was tried and timed says whether a frame is by grid or cloud: not if the file shows it.
    const auto renderer = make_renderer<Backend>();
    const SceneProgram dense = random_scene(1, {.spheres = 60000, .radius = 0.03, .ground = false});
    const SceneProgram sparse =
        random_scene(2, {.spheres = 60000, .shape = Shape::clusters, .radius = 0.001, .ground = false});
    // For few rays a GPU takes a grid.
    const auto [width, height] = Backend::is_immediate ? std::pair{64u, 48u} : std::pair{1920u, 1080u};
    const FrameSettings settings = layered(width, height);
    FrameStatistics statistics;
    const Image first = render(*renderer, dense, settings, &statistics);
    CHECK(statistics.method == "grid");
    CHECK(statistics.choice.reason == MethodReason::prior);
    FrameSettings plain = settings;
    plain.aovs = {};
    Image image;
    for (int frame = 0; frame < 8; ++frame)
        renderer->render(plain, image);
    const Image other = render(*renderer, sparse, settings, &statistics);
    CHECK(statistics.choice.reason == MethodReason::prior);
    CHECK(same_layers(render(*make_renderer<Backend>(), sparse, settings), other));
    CHECK(same_layers(render(*renderer, dense, settings), first));
}
