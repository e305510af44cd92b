// SPDX-License-Identifier: Apache-2.0
#include "tests/kernels/test_scene.h"

#include <cmath>

namespace proxima::test {

static uint32_t flags_of(const PigmentColor& color, const Finish& finish) {
    return (color.filter != 0 || color.transmit != 0 ? material_transparent : 0u) |
           (finish.reflection_max != glm::vec3(0.0f) || finish.reflection_min != glm::vec3(0.0f) ? material_reflective
                                                                                                 : 0u);
}

uint32_t add_material(SceneProgram& scene, const SurfaceSpec& spec) {
    Material material;
    material.first_layer = uint32_t(scene.layers.size());
    material.layer_count = 0;
    material.interior = uint32_t(scene.interiors.size());
    material.flags = spec.flags;
    scene.interiors.push_back(spec.interior);
    scene.materials.push_back(material);
    add_layer(scene, spec.color, spec.finish);
    scene.materials.back().flags = spec.flags | flags_of(spec.color, spec.finish);
    return uint32_t(scene.materials.size() - 1);
}

void add_layer(SceneProgram& scene, const PigmentColor& color, const Finish& finish) {
    scene.layers.push_back({uint32_t(scene.pigments.size()), uint32_t(scene.finishes.size())});
    scene.pigments.push_back({.color = color, .second_color = {}});
    scene.finishes.push_back(finish);
    Material& material = scene.materials.back();
    ++material.layer_count;
    material.flags |= flags_of(color, finish);
}

void add_sphere(SceneProgram& scene, const Vec3<double>& center, double radius, uint32_t material) {
    scene.spheres.push_back({center, radius});
    scene.sphere_materials.push_back(material);
}

void add_ellipsoid(SceneProgram& scene, const Affine<double>& world_from_object, uint32_t material) {
    const Mat3<double> inverse = glm::inverse(world_from_object.linear);
    scene.ellipsoids.push_back({{inverse, -(inverse * world_from_object.offset)}, world_from_object, material});
}

void add_light(SceneProgram& scene, const Vec3<double>& position, const glm::vec3& color) {
    scene.lights.push_back({.position = position, .color = color});
}

SceneProgram empty_scene() {
    SceneProgram scene;
    scene.camera.location = {0, 0, -5};
    return scene;
}

Finish glowing(float strength) {
    Finish finish;
    finish.ambient = glm::vec3(0.0f);
    finish.emission = glm::vec3(strength);
    finish.diffuse = 0;
    return finish;
}

SceneProgram random_scene(uint32_t seed, const RandomSceneSpec& spec) {
    std::mt19937 engine(seed);
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * (double(engine()) / 4294967296.0); // the same with every standard library
    };
    SceneProgram scene = empty_scene();
    scene.background = {0.1f, 0.2f, 0.4f};
    std::vector<uint32_t> materials;
    for (int i = 0; i < 4; ++i) {
        SurfaceSpec surface;
        surface.color.rgb = {float(uniform(0, 1)), float(uniform(0, 1)), float(uniform(0, 1))};
        surface.finish.phong = float(uniform(0, 1));
        surface.finish.specular = float(uniform(0, 0.5));
        if (spec.mirrors && i % 2 == 0)
            surface.finish.reflection_min = surface.finish.reflection_max = glm::vec3(0.5f);
        if (spec.glass && i % 2 == 1) {
            surface.color.filter = 0.8f;
            surface.interior.ior = float(uniform(1, 1.8));
            surface.interior.fade_power = 2;
            surface.interior.fade_distance = 1;
        }
        materials.push_back(add_material(scene, surface));
    }
    const auto any_material = [&] { return materials[engine() % materials.size()]; };
    const auto point = [&]() -> Vec3<double> {
        Vec3<double> p{uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)};
        if (spec.shape == Shape::flat)
            p.y = 0.5;
        if (spec.shape == Shape::line)
            p.y = p.z = 0.25;
        if (spec.shape == Shape::clusters)
            p = glm::sign(p) * 1.8 + 0.05 * p;
        if (spec.shape == Shape::stadium && engine() % 40 != 0)
            p = Vec3<double>(0.5, 0.3, 0.2) + 0.02 * p;
        return p;
    };
    for (uint32_t i = 0; i < spec.spheres; ++i)
        add_sphere(scene, point(), spec.radius * uniform(0.3, 1.5), any_material());
    for (int i = 0; spec.ellipsoids && i < 20; ++i) {
        Affine<double> map;
        for (int c = 0; c < 3; ++c)
            map.linear[c] = spec.radius * Vec3<double>(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2));
        map.offset = point();
        add_ellipsoid(scene, map, any_material());
    }
    if (spec.ground) {
        scene.planes.push_back({{0, 1, 0}, -3, materials[0]});
        add_sphere(scene, {0, -1002.5, 0}, 1000, materials[2]);
    }
    add_light(scene, {5, 10, -10}, {0.8f, 0.8f, 0.7f});
    add_light(scene, {-8, 3, -3}, {0.3f, 0.3f, 0.5f});
    return scene;
}

Image render(FrameRenderer& renderer, const SceneProgram& scene, const FrameSettings& settings,
             FrameStatistics* statistics) {
    Image image;
    renderer.set_scene(scene, settings.precision);
    const FrameStatistics result = renderer.render(settings, image);
    if (statistics)
        *statistics = result;
    return image;
}

glm::vec3 middle(const Image& image) {
    const size_t pixel = size_t(image.height / 2) * image.width + image.width / 2;
    return {image.rgb[3 * pixel], image.rgb[3 * pixel + 1], image.rgb[3 * pixel + 2]};
}

FrameSettings single_ray(Precision precision) {
    FrameSettings settings;
    settings.width = settings.height = 1;
    settings.precision = precision;
    return settings;
}

} // namespace proxima::test
