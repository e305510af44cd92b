// SPDX-License-Identifier: Apache-2.0
// The shapes, in the scene's own units, and the pure functions that meet them with a ray.
#pragma once
#include "kernels/vector_math.h"

namespace proxima {

/// `direction` has unit length.
template <class Real> struct Ray {
    Vec3<Real> origin;
    Vec3<Real> direction;
};

/// 16 bytes in float. Its material stands in a separate array of the same order.
template <class Real> struct Sphere {
    Vec3<Real> center{Real(0)};
    Real radius = Real(1);
};

/// The unit sphere at the origin, seen through a map that is not a similarity.
template <class Real> struct Ellipsoid {
    Affine<Real> object_from_world;
    Affine<Real> world_from_object;
    uint32_t material = 0;
};

/// The half space dot(normal, p) < distance is its inside. `normal` has unit length.
template <class Real> struct Plane {
    Vec3<Real> normal{Real(0), Real(1), Real(0)};
    Real distance = Real(0);
    uint32_t material = 0;
};

template <class Real> struct Box {
    Vec3<Real> lower{Real(0)};
    Vec3<Real> upper{Real(0)};
};

} // namespace proxima
