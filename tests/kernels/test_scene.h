// SPDX-License-Identifier: Apache-2.0
// Scenes made by hand for the tests, and the pictures of them.
#pragma once
#include "parser/scene_program.h"
#include "renderer/frame_renderer.h"

#include <cstdint>
#include <random>

namespace proxima::test {

/// What a surface is made of; the defaults are POV-Ray's.
struct SurfaceSpec {
    PigmentColor color{glm::vec3(1.0f)};
    Finish finish{};
    Interior interior{};
    uint32_t flags = 0; ///< besides those that follow from colour and finish
};

/// Adds a material of one layer and returns its index.
uint32_t add_material(SceneProgram& scene, const SurfaceSpec& spec);
/// Adds a layer on top of the material that was added last.
void add_layer(SceneProgram& scene, const PigmentColor& color, const Finish& finish);

void add_sphere(SceneProgram& scene, const Vec3<double>& center, double radius, uint32_t material);
void add_ellipsoid(SceneProgram& scene, const Affine<double>& world_from_object, uint32_t material);
void add_light(SceneProgram& scene, const Vec3<double>& position, const glm::vec3& color = glm::vec3(1.0f));

/// A camera on the z axis at z = -5 that looks along z; the picture is 1.33 x 1 at distance 1.
SceneProgram empty_scene();

/// A finish that only emits: a surface has exactly its pigment's colour times `strength`.
Finish glowing(float strength = 1.0f);

/// `stadium`: one in forty anywhere in the cube, the others within 0.04 of (0.5, 0.3, 0.2).
enum class Shape { cube, flat, line, clusters, stadium };
struct RandomSceneSpec {
    uint32_t spheres = 200;
    Shape shape = Shape::cube;
    double radius = 0.2;
    bool mirrors = false;
    bool glass = false;
    bool ellipsoids = false;
    bool ground = true; ///< a plane, and a sphere far larger than the others
};
/// Spheres of several materials in [-2, 2]^3 with two lights.
SceneProgram random_scene(uint32_t seed, const RandomSceneSpec& spec);

/// Renders with `settings`; its precision is used for the scene too.
Image render(FrameRenderer& renderer, const SceneProgram& scene, const FrameSettings& settings,
             FrameStatistics* statistics = nullptr);

/// The colour of the middle pixel of a picture of odd size.
glm::vec3 middle(const Image& image);

/// A picture of 1x1: the ray along the camera's direction.
FrameSettings single_ray(Precision precision = Precision::float64);

} // namespace proxima::test
