// SPDX-License-Identifier: Apache-2.0
#include "kernels/camera.h"

#include <doctest/doctest.h>
#include <initializer_list>

using namespace proxima;

TEST_CASE("camera: perspective rays start at the camera and fan out over right and up") {
    Camera<double> camera;
    camera.location = {1, 2, 3};
    camera.direction = {0, 0, 2};
    camera.right = {4, 0, 0};
    camera.up = {0, 3, 0};
    struct Row {
        double x, y;
        Vec3<double> towards;
    };
    for (const Row& row : {Row{0, 0, {0, 0, 2}}, Row{0.5, 0, {2, 0, 2}}, Row{-0.5, 0.5, {-2, 1.5, 2}}}) {
        const Ray<double> ray = camera_ray(camera, row.x, row.y);
        CHECK(ray.origin == camera.location);
        CHECK(glm::length(ray.direction - glm::normalize(row.towards)) < 1e-15);
    }
}

TEST_CASE("camera: orthographic rays are parallel and start on the picture") {
    Camera<double> camera;
    camera.kind = CameraKind::orthographic;
    camera.location = {0, 0, -5};
    camera.direction = {0, 0, 2};
    const Ray<double> ray = camera_ray(camera, 0.5, -0.5);
    CHECK(glm::length(ray.origin - Vec3<double>(0.665, -0.5, -5)) < 1e-15);
    CHECK(ray.direction == Vec3<double>(0, 0, 1));
}
