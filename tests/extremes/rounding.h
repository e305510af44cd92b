// SPDX-License-Identifier: Apache-2.0
// What rounding to double explains, by error analysis.
#pragma once
#include "tests/extremes/probe.h"

namespace proxima::testing {

/// How far rounding may move a hit of one of a scene's rays, across the ray or out of the surface, where the scene is
/// turned by a matrix with its camera: in the scene's units, to the first order.
///
/// Let u be 2^-53, e the eye, p the place that is hit and D its distance from e, c and r the centre and the radius of
/// the sphere, and B how far from e the ray is based, where it enters the bounds. Each of the two pictures counts.
///  - Turned coordinates are sums of three products: 3 u |v| along each axis, 3 sqrt(3) u |v| in all; of c and of e.
///  - The matrix is a rotation but for 22 u: two factors with rounded sines and cosines, 2 u each, and twice the
///    rounding of their product, 3 u in each of nine numbers. That stretches what is turned, but not r, by half of it.
///  - The camera's turned axes turn a ray by at most sqrt(3) times 3 sqrt(3) u, 9 u; their sum and its unit length by
///    8 u in each picture. Across the ray that is times D.
///  - The base, e + B d: u B for the product and u (|e| + B) for the sum, in each.
///  - The intersection, with f from c to the base, |f| <= B + D + r. The closest point is off by 6 u |f| across the ray
///    and the square of the half chord h by 12 u r |f| + 4 u r^2, so that the error of h, times h / r, moves the hit
///    out of the surface by 6 u |f| + 2 u r. The way b to the closest point is off by 4 u |f|. The near hit is power /
///    q, with q = b + h: the power is off by 6 u (|f|^2 + r^2), which over q, times h / r, is 6 u (|f| + 2 r); and q by
///    what b and h are, times at most 1. In all no more than 16 u (|f| + r) in each.
///  - The place, c + r n, where n is of unit length but for 3 u: 5 u (r + |p|) in each, and |p| <= |e| + D.
///  - Seen from the eye: u D in each.
/// The sum is u (6 |c| + 18 |e| + 69 D + 85 r + 36 B). A plane has neither c nor r. On an ellipsoid all this happens in
/// its own space: the condition of its map multiplies it.
double turning_bound(const SceneProgram& scene, const ProbedHit& hit);

} // namespace proxima::testing
