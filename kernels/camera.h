// SPDX-License-Identifier: Apache-2.0
// The camera, and the ray through a point of its picture. The picture's x runs from -0.5 (left) to 0.5, y from -0.5
// (bottom) to 0.5; `right` and `up` span it, `direction` leads from `location` to its centre.
#pragma once
#include "kernels/geometry.h"

namespace proxima {

enum class CameraKind : uint32_t { perspective, orthographic };

template <class Real> struct Camera {
    CameraKind kind = CameraKind::perspective;
    Vec3<Real> location{Real(0)};
    Vec3<Real> direction{Real(0), Real(0), Real(1)};
    Vec3<Real> right{Real(1.33), Real(0), Real(0)};
    Vec3<Real> up{Real(0), Real(1), Real(0)};
};

template <class Real> HD Camera<Real> camera_in(const Camera<double>& camera) {
    return {camera.kind, Vec3<Real>(camera.location), Vec3<Real>(camera.direction), Vec3<Real>(camera.right),
            Vec3<Real>(camera.up)};
}

/// The ray through (x, y) of the picture, both in [-0.5, 0.5]; y points up.
template <class Real> HD_INNER Ray<Real> camera_ray(const Camera<Real>& camera, Real x, Real y) {
    const Vec3<Real> across = x * camera.right + y * camera.up;
    const bool is_parallel = camera.kind == CameraKind::orthographic;
    const Vec3<Real> from = camera.location + across, towards = camera.direction + across;
    Ray<Real> ray;
    for (int i = 0; i < 3; ++i) { // without branches, for loops over rays
        ray.origin[i] = is_parallel ? from[i] : camera.location[i];
        ray.direction[i] = is_parallel ? camera.direction[i] : towards[i];
    }
    ray.direction = glm::normalize(ray.direction);
    return ray;
}

} // namespace proxima
