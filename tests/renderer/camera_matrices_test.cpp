// SPDX-License-Identifier: Apache-2.0
#include "renderer/camera_matrices.h"

#include <doctest/doctest.h>

using namespace proxima;

namespace {

/// (point, 1) * matrix, divided by w.
std::array<double, 3> through(const std::array<float, 16>& matrix, const glm::dvec3& point) {
    double result[4] = {};
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 3; ++row)
            result[column] += point[row] * double(matrix[size_t(row * 4 + column)]);
        result[column] += double(matrix[size_t(12 + column)]);
    }
    return {result[0] / result[3], result[1] / result[3], result[2] / result[3]};
}

void check_near(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (size_t i = 0; i < 3; ++i)
        CHECK(a[i] == doctest::Approx(b[i]).epsilon(1e-5));
}

Camera<double> a_camera(CameraKind kind) {
    return {kind, {1, 2, -5}, {0, 0, 2}, {1.5, 0, 0}, {0, 1, 0}};
}

} // namespace

TEST_CASE("camera matrices: camera space has its axes, in units of the world") {
    const auto matrix = camera_matrices(a_camera(CameraKind::perspective)).world_to_camera;
    check_near(through(matrix, {1, 2, -5}), {0, 0, 0});
    check_near(through(matrix, {4, 2, 2}), {3, 0, 7});
    check_near(through(matrix, {1, 1, -5}), {0, -1, 0});
}

TEST_CASE("camera matrices: what a ray through a corner meets is at the picture's corner") {
    for (const CameraKind kind : {CameraKind::perspective, CameraKind::orthographic}) {
        const Camera<double> camera = a_camera(kind);
        const auto matrix = camera_matrices(camera).world_to_ndc;
        for (const double x : {-0.5, 0.0, 0.5})
            for (const double y : {-0.5, 0.25}) {
                const Ray<double> ray = camera_ray(camera, x, y);
                for (const double t : {2.5, 40.0}) {
                    const auto place = through(matrix, ray.origin + t * ray.direction);
                    CHECK(place[0] == doctest::Approx(2 * x).epsilon(1e-5));
                    CHECK(place[1] == doctest::Approx(2 * y).epsilon(1e-5));
                }
            }
    }
    const auto matrix = camera_matrices(a_camera(CameraKind::perspective)).world_to_ndc;
    CHECK(through(matrix, {1, 2, -3})[2] == doctest::Approx(0).epsilon(1e-6)); // at location + direction
    CHECK(through(matrix, {1, 2, 1e9})[2] == doctest::Approx(1).epsilon(1e-6));
}
