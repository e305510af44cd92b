// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/random_views.h"
#include "tests/extremes/figures.h"

#include <algorithm>
#include <cmath>

namespace proxima::testing {
namespace {

class Chance {
public:
    explicit Chance(std::mt19937_64& engine) : engine_(engine) {}

    double uniform(double low, double high) { return low + (high - low) * (double(engine_() >> 11) * 0x1p-53); }
    double power_of_ten(double low, double high) { return std::pow(10, uniform(low, high)); }
    bool happens(double chance) { return uniform(0, 1) < chance; }
    Vec3<double> direction() {
        const double z = uniform(-1, 1), angle = uniform(0, 6.283185307179586), r = std::sqrt(1 - z * z);
        return {r * std::cos(angle), r * std::sin(angle), z};
    }

private:
    std::mt19937_64& engine_;
};

/// Of `from`, towards `at`, with half of the picture's width over its distance, 4 to 3.
Camera<double> camera_towards(const Vec3<double>& from, const Vec3<double>& at, double half_width) {
    Camera<double> camera;
    camera.location = from;
    camera.direction = glm::normalize(at - from);
    const Vec3<double> beside = std::abs(camera.direction.y) < 0.9 ? Vec3<double>(0, 1, 0) : Vec3<double>(1, 0, 0);
    const Vec3<double> right = glm::normalize(glm::cross(beside, camera.direction));
    camera.right = 2 * half_width * right;
    camera.up = 1.5 * half_width * glm::cross(camera.direction, right);
    return camera;
}

/// Of axes up to ten times as long as others, turned around y.
Ellipsoid<double> ellipsoid(const Vec3<double>& center, double radius, Chance& chance) {
    const double angle = chance.uniform(0, 6.283185307179586), c = std::cos(angle), s = std::sin(angle);
    const Mat3<double> turn(c, 0, -s, 0, 1, 0, s, 0, c);
    Affine<double> map{turn, center};
    for (int i = 0; i < 3; ++i)
        map.linear[i] *= radius * chance.power_of_ten(-0.5, 0.5);
    const Mat3<double> inverse = glm::inverse(map.linear);
    return {{inverse, -(inverse * center)}, map, 0};
}

} // namespace

RandomView random_view(std::mt19937_64& engine) {
    Chance chance(engine);
    RandomView view;
    SceneProgram& scene = view.scene;
    scene.materials = {Material{}};
    scene.layers = {Layer{}};
    scene.pigments = {Pigment{}};
    scene.finishes = {Finish{}};
    scene.interiors = {Interior{}};

    const double size = chance.power_of_ten(-3, 3);
    const Vec3<double> middle =
        chance.happens(0.5) ? Vec3<double>(0.0) : size * chance.power_of_ten(-1, 5) * chance.direction();
    Vec3<double> extent;
    for (int i = 0; i < 3; ++i)
        extent[i] = size * chance.power_of_ten(-1, 0);
    const double radius = size * chance.power_of_ten(-3, -0.5);
    const auto count = uint32_t(chance.power_of_ten(0, 2.5));
    for (uint32_t i = 0; i < count; ++i) {
        const Vec3<double> place(chance.uniform(-1, 1), chance.uniform(-1, 1), chance.uniform(-1, 1));
        scene.spheres.push_back({middle + extent * place, radius * chance.power_of_ten(-0.5, 0.5)});
    }
    const Vec3<double> seen = scene.spheres[engine() % count].center;
    if (chance.happens(0.25)) { // a globe
        const double globe = size * chance.power_of_ten(1, 6);
        scene.spheres.push_back({middle - Vec3<double>(0, extent.y + globe, 0), globe});
    }
    scene.sphere_materials.resize(scene.spheres.size(), 0);
    if (chance.happens(0.2)) // a floor
        scene.planes.push_back({{0, 1, 0}, middle.y - extent.y * chance.power_of_ten(-0.5, 1), 0});
    for (int i = 0; i < 5 && chance.happens(0.25); ++i) // a long ball
        scene.ellipsoids.push_back(ellipsoid(scene.spheres[i % count].center, radius, chance));

    const double away = size * chance.power_of_ten(-1, 2);
    const double narrow = std::min(1.0, 2 * size / away);
    scene.camera = camera_towards(seen + away * chance.direction(), seen, narrow * chance.power_of_ten(-1.5, 0));
    if (chance.happens(0.1)) {
        scene.camera.kind = CameraKind::orthographic;
        scene.camera.right *= away;
        scene.camera.up *= away;
    }
    view.width = uint32_t(chance.power_of_ten(std::log10(64), std::log10(4096)));
    return view;
}

FloatTrial try_float(const RandomView& view) {
    FrameSettings settings;
    settings.width = 64;
    settings.height = 48;
    const HitFigures figures =
        compare_hits(reference_hits(view.scene, settings), probe(view.scene, settings), view.scene);
    return {float_fit(view.scene, view.width), figures.most_pixels * view.width / settings.width, figures.wrong};
}

} // namespace proxima::testing
