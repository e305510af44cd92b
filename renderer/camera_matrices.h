// SPDX-License-Identifier: Apache-2.0
// A camera as the two matrices that compositing programs read from EXR headers, for vectors that stand to the left of
// their matrix: (x, y, z, 1) * M.
#pragma once
#include "kernels/camera.h"

#include <array>

namespace proxima {

struct CameraMatrices {
    /// To the camera's own axes: x to the right, y up, z into the picture.
    std::array<float, 16> world_to_camera;
    /// To the picture, x and y from -1 to 1 after the division by w; z is 0 in the plane of `direction`, and with
    /// perspective 1 at infinity.
    std::array<float, 16> world_to_ndc;
};

CameraMatrices camera_matrices(const Camera<double>& camera);

} // namespace proxima
