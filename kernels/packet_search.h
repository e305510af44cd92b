// SPDX-License-Identifier: Apache-2.0
// A packet of rays in, what each meets out: the same as find_nearest and find_any say of each ray alone, for scenes
// whose round shapes are spheres and whose grid has no cloud.
#pragma once
#include "kernels/packet_walk.h"

namespace proxima {

/// Meets the rays with what may hit them. `alone(lane)` is called instead for each ray that is not idle where the rays
/// of the packet have too little in common, with `reach` and `primitive` as they were.
template <Sought sought, class Real, class Alone>
HD void search_packet(const SceneView<Real>& scene, RayPacket<Real>& rays, const Alone& alone) {
    if (rays.all_idle())
        return;
    PacketVisitor<sought, Real> visitor(scene, rays);
    const GeometryView<Real>& geometry = scene.geometry;
    for (uint32_t i = 0; i < geometry.planes.size(); ++i)
        visitor.meet_plane(geometry.round_count() + i);
    for (const uint32_t id : geometry.large)
        visitor.meet_large(id);
    const auto go_through = [&](const GridView<Real>& grid) {
        PacketWalk<Real> walk(grid, geometry.spheres, rays);
        return walk.go([&](uint32_t id) { visitor.meet_sphere(id); });
    };
    if (go_through(scene.grid) && (!scene.outskirts.in_use() || go_through(scene.outskirts)))
        return;
    for (uint32_t lane = 0; lane < RayPacket<Real>::lanes; ++lane)
        if (!rays.is_idle(lane))
            alone(lane);
}

} // namespace proxima
