// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/scene_maps.h"

namespace proxima::testing {
namespace {

/// Patterns that are laid in the scene's own axes get a map, so that they can be laid in others.
void map_all_patterns(SceneProgram& scene) {
    for (Pigment& pigment : scene.pigments)
        if (pigment.kind != PigmentKind::solid && pigment.transform == Pigment::no_transform) {
            pigment.transform = uint32_t(scene.transforms.size());
            scene.transforms.emplace_back();
        }
}

} // namespace

SceneProgram scaled(SceneProgram scene, double factor) {
    map_all_patterns(scene);
    for (Sphere<double>& sphere : scene.spheres)
        sphere = {sphere.center * factor, sphere.radius * factor};
    for (Ellipsoid<double>& ellipsoid : scene.ellipsoids) {
        ellipsoid.object_from_world.linear /= factor;
        ellipsoid.world_from_object.linear *= factor;
        ellipsoid.world_from_object.offset *= factor;
    }
    for (Plane<double>& plane : scene.planes)
        plane.distance *= factor;
    for (Affine<double>& transform : scene.transforms)
        transform.linear /= factor;
    for (Light<double>& light : scene.lights) {
        light.position *= factor;
        light.point_at *= factor;
        light.fade_distance *= float(factor);
        if (light.kind == LightKind::cylinder) {
            light.radius *= factor;
            light.falloff *= factor;
        }
    }
    for (AreaLight<double>& light : scene.area_lights) {
        light.axis1 *= factor;
        light.axis2 *= factor;
    }
    for (Interior& interior : scene.interiors)
        interior.fade_distance *= float(factor);
    for (Fog<double>& fog : scene.fogs) {
        fog.distance *= factor;
        fog.offset *= factor;
        fog.altitude *= factor;
    }
    scene.camera.location *= factor;
    if (scene.camera.kind == CameraKind::orthographic) {
        scene.camera.right *= factor;
        scene.camera.up *= factor;
    }
    return scene;
}

SceneProgram turned(SceneProgram scene, const Mat3<double>& turn) {
    map_all_patterns(scene);
    const Mat3<double> back = glm::transpose(turn);
    for (Sphere<double>& sphere : scene.spheres)
        sphere.center = turn * sphere.center;
    for (Ellipsoid<double>& ellipsoid : scene.ellipsoids) {
        ellipsoid.object_from_world.linear = ellipsoid.object_from_world.linear * back;
        ellipsoid.world_from_object.linear = turn * ellipsoid.world_from_object.linear;
        ellipsoid.world_from_object.offset = turn * ellipsoid.world_from_object.offset;
    }
    for (Plane<double>& plane : scene.planes)
        plane.normal = turn * plane.normal;
    for (Affine<double>& transform : scene.transforms)
        transform.linear = transform.linear * back;
    for (Light<double>& light : scene.lights) {
        light.position = turn * light.position;
        light.point_at = turn * light.point_at;
        light.direction = turn * light.direction;
    }
    for (AreaLight<double>& light : scene.area_lights) {
        light.axis1 = turn * light.axis1;
        light.axis2 = turn * light.axis2;
    }
    for (Fog<double>& fog : scene.fogs)
        fog.up = turn * fog.up;
    Camera<double>& camera = scene.camera;
    camera = {camera.kind, turn * camera.location, turn * camera.direction, turn * camera.right, turn * camera.up};
    return scene;
}

} // namespace proxima::testing
