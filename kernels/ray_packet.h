// SPDX-License-Identifier: Apache-2.0
// Rays side by side, for processors with vector instructions: each number of theirs is an array over the lanes, and
// what is done to all of them is a loop that compilers turn into such instructions. A lane computes what a ray alone
// would, to the last bit.
#pragma once
#include "kernels/film.h"
#include "kernels/traverse.h"

namespace proxima {

/// Based rays, and what each of them has met so far.
template <class Real> struct alignas(64) RayPacket {
    static constexpr uint32_t lanes = tile_width * tile_height;

    Real origin[3][lanes];
    Real direction[3][lanes];
    Real offset[lanes]; ///< as in BasedRay
    uint32_t meets_bounds[lanes];
    uint32_t source[lanes];    ///< the primitive that the ray starts on
    Real exit[lanes];          ///< as in RaySource
    Real nearest[lanes];       ///< hits count beyond
    Real reach[lanes];         ///< and up to here; -infinity for a lane that looks for nothing, or nothing more
    uint32_t primitive[lanes]; ///< that was met at `reach`, or no_primitive

    /// A ray that looks for hits between two distances from its own origin.
    HD_INNER void set(uint32_t lane, const BasedRay<Real>& ray, Real from, Real farthest) {
        for (int i = 0; i < 3; ++i) {
            origin[i][lane] = ray.ray.origin[i];
            direction[i][lane] = ray.ray.direction[i];
        }
        offset[lane] = ray.offset;
        meets_bounds[lane] = ray.meets_bounds;
        source[lane] = ray.source.primitive;
        exit[lane] = ray.source.exit;
        nearest[lane] = from - ray.offset;
        reach[lane] = farthest - ray.offset;
        primitive[lane] = no_primitive;
    }
    /// A lane without a ray.
    HD_INNER void set_idle(uint32_t lane) {
        set(lane, {{Vec3<Real>(Real(0)), Vec3<Real>(Real(1))}, {}, Real(0), false}, Real(0), -infinity<Real>);
    }
    HD_INNER Ray<Real> ray(uint32_t lane) const {
        return {{origin[0][lane], origin[1][lane], origin[2][lane]},
                {direction[0][lane], direction[1][lane], direction[2][lane]}};
    }
    HD_INNER BasedRay<Real> based(uint32_t lane) const {
        return {ray(lane), {source[lane], exit[lane]}, offset[lane], meets_bounds[lane] != 0};
    }
    HD_INNER bool is_idle(uint32_t lane) const { return reach[lane] == -infinity<Real>; }
    HD_INNER bool all_idle() const {
        uint32_t busy = 0;
        for (uint32_t lane = 0; lane < lanes; ++lane)
            busy |= is_idle(lane) ? 0u : 1u;
        return busy == 0;
    }
};

/// What the rays of a packet look for, as NearestHit and AnyHit do for one.
enum class Sought { nearest, any };

/// Meets all rays of a packet with one primitive after the other.
template <Sought sought, class Real> class PacketVisitor {
public:
    static constexpr uint32_t lanes = RayPacket<Real>::lanes;

    HD PacketVisitor(const SceneView<Real>& scene, RayPacket<Real>& rays) : scene_(scene), rays_(rays) {}

    HD_INNER void meet_sphere(uint32_t id) {
        if (sought == Sought::any && !casts_shadow(id))
            return;
        const Sphere<Real> sphere = scene_.geometry.spheres[id];
        const Real least = scene_.limits.min_half_chord2;
        alignas(64) Real closest[lanes], half_chord2[lanes];
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const Approach<Real> met = approach(sphere, rays_.ray(lane));
            closest[lane] = met.closest;
            half_chord2[lane] = met.half_chord2;
        }
        for (uint32_t first = 0; first < lanes; first += group) {
            uint32_t near = 0;
            for (uint32_t lane = first; lane < first + group; ++lane)
                near |= half_chord2[lane] > least ? 1u : 0u;
            if (near == 0)
                continue;
            alignas(64) Real t[group];
            for (uint32_t i = 0; i < group; ++i) {
                const uint32_t lane = first + i;
                const Real power = approach(sphere, rays_.ray(lane)).power(); // of those that meet it alone
                const Chord<Real> met = chord(closest[lane], half_chord2[lane], power);
                t[i] = half_chord2[lane] > least ? met.beyond(rays_.nearest[lane]) : infinity<Real>;
            }
            consider(first, id, t);
        }
    }
    /// One that is too large for the grid: in double, where the scene has it so.
    HD void meet_large(uint32_t id) {
        if constexpr (std::is_same_v<Real, float>)
            if (scene_.meets_exactly(id))
                return meet_exactly(id);
        meet_sphere(id);
    }
    HD void meet_plane(uint32_t id) {
        if (sought == Sought::any && !casts_shadow(id))
            return;
        const Plane<Real> plane = scene_.geometry.plane(id);
        for (uint32_t first = 0; first < lanes; first += group) {
            alignas(64) Real t[group];
            for (uint32_t i = 0; i < group; ++i)
                t[i] = intersect(plane, rays_.ray(first + i), rays_.nearest[first + i], scene_.limits.min_cosine);
            consider(first, id, t);
        }
    }

private:
    static constexpr uint32_t group = tile_width; ///< lanes that are left out together where all miss

    HD_INNER bool casts_shadow(uint32_t id) const {
        return !scene_.has_no_shadow ||
               !(scene_.surfaces.materials[scene_.geometry.material(id)].flags & material_no_shadow);
    }
    HD_RARE void meet_exactly(uint32_t id) {
        if (sought == Sought::any && !casts_shadow(id))
            return;
        for (uint32_t first = 0; first < lanes; first += group) {
            Real t[group];
            for (uint32_t i = 0; i < group; ++i)
                t[i] = exact_distance(scene_.exact.spheres[id], rays_.ray(first + i), rays_.nearest[first + i],
                                      scene_.limits.min_half_chord2);
            consider(first, id, t);
        }
    }

    /// The rays of a group met a primitive at these distances.
    HD_INNER void consider(uint32_t first, uint32_t id, Real (&t)[group]) {
        leave_out_repeated(first, id, t);
        for (uint32_t i = 0; i < group; ++i)
            consider(first + i, id, t[i]);
    }
    /// Where it is what a ray starts on once more: see Search::repeats_known. The camera's rays start on nothing.
    HD_INNER void leave_out_repeated(uint32_t first, uint32_t id, Real (&t)[group]) const {
        uint32_t met = 0;
        for (uint32_t i = 0; i < group; ++i)
            met |= (t[i] <= rays_.reach[first + i]) & (rays_.source[first + i] != no_primitive) ? 1u : 0u;
        for (uint32_t i = 0; met != 0 && i < group; ++i) {
            const uint32_t source = rays_.source[first + i];
            if (t[i] <= rays_.reach[first + i] && source != no_primitive && scene_.is_repeated(source, id))
                t[i] = infinity<Real>;
        }
    }
    HD_INNER void consider(uint32_t lane, uint32_t id, Real t) {
        const bool starts_here = id == rays_.source[lane];
        const Real reach = rays_.reach[lane];
        if (sought == Sought::any) {
            const bool met = (t < reach) & !starts_here;
            rays_.reach[lane] = met ? -infinity<Real> : reach;
            rays_.primitive[lane] = met ? id : rays_.primitive[lane];
            return;
        }
        const uint32_t best = rays_.primitive[lane];
        const bool ties = (t == reach) & (best != no_primitive) & (id < best);
        const bool takes = ((t < reach) | ties) & !starts_here;
        rays_.reach[lane] = takes ? t : reach;
        rays_.primitive[lane] = takes ? id : best;
    }

    const SceneView<Real>& scene_;
    RayPacket<Real>& rays_;
};

} // namespace proxima
