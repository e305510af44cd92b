// SPDX-License-Identifier: Apache-2.0
#include "renderer/float_fit.h"
#include "renderer/large_spheres.h"
#include "tests/extremes/cases.h"
#include "tests/extremes/random_views.h"

#include <doctest/doctest.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

SceneProgram scene_of(const char* file, const Declares& declares = {}) {
    return read_case({"", file, declares, 640, 480});
}

bool holds(const Declares& declares, uint32_t width = 640) {
    return float_fit(scene_of("spheres.scn", declares), width).holds();
}

} // namespace

TEST_CASE("float_fit: float holds usual scenes at any scale, near the origin") {
    for (const char* scale : {"1", "1e-6", "1e-3", "1e3", "1e6"})
        CHECK(holds({{"Scale", scale}}));
    CHECK(holds({}, 3840));
}

TEST_CASE("float_fit: it does not hold what is far from the origin, a narrow view, or squares out of its range") {
    CHECK_FALSE(holds({{"Shift", "1e4"}}));
    CHECK_FALSE(holds({{"Shift", "1e8"}}));
    CHECK_FALSE(holds({{"Angle", "0.01"}}));
    CHECK_FALSE(holds({{"Scale", "1e-30"}}));
    CHECK_FALSE(holds({{"Scale", "1e30"}}));
    const FloatFit fit = float_fit(scene_of("spheres.scn", {{"Shift", "1e8"}}), 640);
    CHECK(fit.in_range);
    CHECK(fit.pixels > 1);
    CHECK(fit.coordinate > 1e8);
    CHECK(fit.distance < 10);
    CHECK(fit.reason().find("pixels") != std::string::npos);
}

TEST_CASE("float_fit: what is far away moves less than what is near") {
    SceneProgram scene = scene_of("spheres.scn");
    const double before = float_fit(scene, 640).pixels;
    scene.spheres.push_back({{1e6, 0, 3e6}, 1}); // as far as its coordinates are large
    scene.sphere_materials.push_back(0);
    CHECK(float_fit(scene, 640).pixels < 2 * before);
    CHECK(float_fit(scene, 640).holds());
}

TEST_CASE("float_fit: large spheres are met in double and do not count") {
    const SceneProgram scene = scene_of("ground.scn", {{"Radius", "1e6"}});
    CHECK(has_large_sphere(scene.spheres));
    CHECK(float_fit(scene, 640).holds());
    CHECK_FALSE(has_large_sphere(scene_of("spheres.scn").spheres));
}

TEST_CASE("float_fit: a sphere that flies away in the course of an animation is found") {
    SceneProgram scene = scene_of("spheres.scn");
    MotionCode& code = scene.motion.spheres; // sphere 0 is at (clock * 1e7, ...)
    code.programs = {{.target = MotionTarget::sphere, .instructions = 1, .instances = 1, .own_constants = 4}};
    code.instructions = {{MotionOp::multiply, 0, MotionOperand::clock, MotionOperand::first_own}};
    code.outputs = {0, MotionOperand::first_own + 1, MotionOperand::first_own + 2, MotionOperand::first_own + 3};
    code.constants = {1e7, 0, 0, 1};
    code.targets = {0};
    const MotionTime begin{0, 1, 0}, end{1, 2, 0};
    CHECK(float_fit(scene, 640, std::vector{begin}).holds());
    CHECK(float_fit(scene, 640, std::vector{begin, end}).coordinate < 1e6); // seen from where its coordinates are large
    scene.camera.location = {1e7, 0, -6};
    CHECK_FALSE(float_fit(scene, 640, std::vector{begin, end}).holds());
}

TEST_CASE("float_fit: in random scenes the estimate is seldom exceeded, and what float is taken for it holds") {
    constexpr uint64_t seed = 28;
    CAPTURE(seed);
    std::mt19937_64 engine(seed);
    int scenes = 0, exceeded = 0, in_float = 0;
    for (int i = 0; i < 150; ++i) {
        const FloatTrial trial = try_float(random_view(engine));
        CAPTURE(i);
        scenes += trial.measured > 0;
        exceeded += trial.measured > trial.fit.pixels;
        in_float += trial.fit.holds();
        if (trial.fit.holds()) {
            CHECK(trial.measured <= FloatFit::most_pixels);
            CHECK(trial.wrong == 0);
        }
    }
    CHECK(exceeded <= 0.03 * scenes);
    CHECK(in_float >= 0.3 * scenes); // else there would be no need for it
}

TEST_CASE("large_spheres: more than 32 times the geometric mean, whatever the scale") {
    for (const double scale : {1.0, 0x1p-200, 0x1p300}) {
        std::vector<Sphere<double>> spheres(10, {{0, 0, 0}, scale});
        CHECK_FALSE(has_large_sphere(spheres));
        spheres.push_back({{0, 0, 0}, 31 * scale});
        CHECK_FALSE(has_large_sphere(spheres));
        spheres.back().radius = 1000 * scale;
        CHECK(large_sphere_radius(spheres) == 64 * scale); // the mean is 1.9
    }
    CHECK_FALSE(has_large_sphere({}));
    CHECK(large_exponent(1, 2) - large_exponent(-1, 2) == 1); // halves go up, below 0 too
    CHECK(large_exponent(-3, 2) == large_exponent(-1, 2) - 1);
}
