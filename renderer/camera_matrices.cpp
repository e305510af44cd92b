// SPDX-License-Identifier: Apache-2.0
#include "renderer/camera_matrices.h"

#include <glm/gtc/type_ptr.hpp>

namespace proxima {
namespace {

/// GLM's columns, one behind the other, are the rows of the transposed matrix.
std::array<float, 16> rows_of_transposed(const glm::dmat4& matrix) {
    std::array<float, 16> rows;
    for (size_t i = 0; i < 16; ++i)
        rows[i] = float(glm::value_ptr(matrix)[i]);
    return rows;
}

glm::dmat4 frame(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& origin) {
    return {glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(z, 0), glm::dvec4(origin, 1)};
}

} // namespace

CameraMatrices camera_matrices(const Camera<double>& camera) {
    const glm::dvec3 right(camera.right), up(camera.up), direction(camera.direction), location(camera.location);
    const glm::dmat4 world_from_camera =
        frame(glm::normalize(right), glm::normalize(up), glm::normalize(direction), location);
    // A point is location + a * right + b * up + c * direction; a and b go from -1/2 to 1/2 over the picture.
    const glm::dmat4 picture_from_world = glm::inverse(frame(right, up, direction, location));
    glm::dmat4 ndc(1);
    ndc[0][0] = ndc[1][1] = 2;
    ndc[3][2] = -1; // z = c - 1
    if (camera.kind == CameraKind::perspective) {
        ndc[2][3] = 1; // w = c
        ndc[3][3] = 0;
    }
    return {rows_of_transposed(glm::inverse(world_from_camera)), rows_of_transposed(ndc * picture_from_world)};
}

} // namespace proxima
