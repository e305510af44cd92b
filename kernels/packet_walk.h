// SPDX-License-Identifier: Apache-2.0
// The way of a packet of rays through a grid, slice by slice along one axis: Wald, Ize, Kensler, Knoll and Parker, "Ray
// Tracing Animated Scenes Using Coherent Grid Traversal", 2006. Of each slice the voxels between the outermost rays are
// looked up once for all of them.
#pragma once
#include "kernels/ray_packet.h"

namespace proxima {

template <class Real> class PacketWalk {
public:
    static constexpr uint32_t lanes = RayPacket<Real>::lanes;
    static constexpr int32_t most_voxels = 12; ///< of a slice: rays further apart do better alone

    /// `spheres`: what the grid holds.
    HD PacketWalk(const GridView<Real>& grid, std::span<const Sphere<Real>> spheres, const RayPacket<Real>& rays)
        : grid_(grid), spheres_(spheres), rays_(rays) {
        find_entries();
        aim();
    }

    /// Shows `meet` the spheres along the rays, each about once. False where the rays are too far apart: then not
    /// all were shown.
    template <class Meet> HD bool go(const Meet& meet) {
        if (!is_coherent_)
            return false;
        const int32_t last = forward_ ? grid_.size[axis_] - 1 : 0, step = forward_ ? 1 : -1;
        uint32_t recent[recent_size];
        for (uint32_t& id : recent)
            id = no_primitive;
        for (int32_t slice = first_slice();; slice += step) {
            const Rectangle voxels = cross(slice);
            if (!voxels.is_alive)
                return true;
            if (voxels.count() > most_voxels)
                return false;
            visit(slice, voxels, recent, meet);
            if (slice == last)
                return true;
        }
    }

private:
    static constexpr uint32_t recent_size = 32;
    static constexpr Real margin = Real(1e-3); ///< of a voxel: what rounding may move a ray by

    /// Voxels of a slice, both ends included, and in the scene's units the part of them that the rays cross.
    struct Rectangle {
        int32_t low[2] = {0, 0};
        int32_t high[2] = {-1, -1};
        Real least[2], most[2];
        bool is_alive = false; ///< whether some ray is in this slice or comes to a later one

        HD int32_t count() const { return (high[0] - low[0] + 1) * (high[1] - low[1] + 1); }
    };

    /// Which rays come into the grid, and where. Only that of a core is not where they start.
    HD void find_entries() {
        const Box<Real> box = grid_.box();
        const bool is_core = grid_.part == GridPart::core;
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const Span<Real> inside = is_core ? intersect(box, rays_.ray(lane)) : Span<Real>{};
            const bool reaches_it = (!is_core) | ((inside.enter <= inside.exit) & (inside.enter < rays_.reach[lane]));
            enters_[lane] = (rays_.meets_bounds[lane] != 0) & reaches_it & !rays_.is_idle(lane) ? 1u : 0u;
            entry_[lane] = inside.enter;
        }
    }
    /// Turns the rays to voxels, along the axis that one of them crosses most voxels on.
    HD void aim() {
        const Vec3<Real>& scale = grid_.inverse_voxel;
        uint32_t some = 0;
        while (some + 1 < lanes && !enters(some))
            ++some;
        for (int i = 0; i < 3; ++i)
            if (magnitude(rays_.direction[i][some] * scale[i]) > magnitude(rays_.direction[axis_][some] * scale[axis_]))
                axis_ = i;
        forward_ = rays_.direction[axis_][some] > 0;
        across_[0] = axis_ == 0 ? 1 : 0;
        across_[1] = axis_ == 2 ? 1 : 2;
        const uint32_t strays = turn(axis_along(axis_), axis_along(across_[0]), axis_along(across_[1]));
        is_coherent_ = strays == 0;
    }
    /// What a loop over the lanes reads of an axis: copies, which nothing that it writes overwrites.
    struct Axis {
        const Real* origin;
        const Real* direction;
        Real lower, scale, end;

        /// `entry` from the ray's origin.
        HD_INNER Real place(uint32_t lane, Real entry) const {
            return (origin[lane] + entry * direction[lane] - lower) * scale;
        }
        HD_INNER bool is_inside(Real place) const { return (place >= -1) & (place <= end); }
    };
    HD_INNER Axis axis_along(int i) const {
        return {rays_.origin[i], rays_.direction[i], grid_.lower[i], grid_.inverse_voxel[i], Real(grid_.size[i] + 1)};
    }
    /// Returns other than 0 if some ray goes astray.
    HD uint32_t turn(Axis along, Axis across_u, Axis across_v) {
        const Real sign = forward_ ? along.scale : -along.scale;
        uint32_t strays = 0;
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const bool is_in = enters(lane);
            const Real pace = Real(1) / (sign * along.direction[lane]);
            const Real entry = entry_[lane], start = along.place(lane, entry);
            const Real u = across_u.place(lane, entry), v = across_v.place(lane, entry);
            const Real slope_u = across_u.direction[lane] * across_u.scale * pace;
            const Real slope_v = across_v.direction[lane] * across_v.scale * pace;
            const Real sideways = larger(magnitude(slope_u), magnitude(slope_v));
            // Not those at extremes either, whose places are not numbers.
            const bool is_inside = along.is_inside(start) & across_u.is_inside(u) & across_v.is_inside(v);
            const bool is_straight = (pace > 0) & (sideways < Real(4)) & is_inside;
            strays |= is_in & !is_straight ? 1u : 0u;
            start_[lane] = start;
            place_[0][lane] = u;
            place_[1][lane] = v;
            slope_[0][lane] = slope_u;
            slope_[1][lane] = slope_v;
            pace_[lane] = is_in ? pace : infinity<Real>; // so that it reaches no slice
        }
        return strays;
    }
    HD_INNER bool enters(uint32_t lane) const { return enters_[lane] != 0; }

    HD int32_t first_slice() const {
        const Real end = Real(grid_.size[axis_] - 1), sign = forward_ ? Real(1) : Real(-1);
        alignas(64) Real first[lanes];
        for (uint32_t lane = 0; lane < lanes; ++lane)
            first[lane] = enters(lane) ? start_[lane] * sign : infinity<Real>;
        for (uint32_t half = lanes / 2; half > 0; half /= 2)
            for (uint32_t lane = 0; lane < half; ++lane)
                first[lane] = smaller(first[lane], first[lane + half]);
        return int32_t(clamped(first[0] * sign, Real(0), end));
    }

    /// The voxels that the rays cross in a slice.
    HD_INNER Rectangle cross(int32_t slice) const {
        const Real entry = Real(forward_ ? slice : slice + 1), exit = Real(forward_ ? slice + 1 : slice);
        const Real sign = forward_ ? Real(1) : Real(-1);
        const Real end[2] = {Real(grid_.size[across_[0]]), Real(grid_.size[across_[1]])};
        alignas(64) Real low[2][lanes], high[2][lanes];
        uint32_t alive = 0;
        for (uint32_t lane = 0; lane < lanes; ++lane) {
            const Real from = larger((entry - start_[lane]) * sign, Real(0)), to = (exit - start_[lane]) * sign;
            const Real until = larger(to, Real(0));
            const Real u0 = place_[0][lane] + from * slope_[0][lane], u1 = place_[0][lane] + until * slope_[0][lane];
            const Real v0 = place_[1][lane] + from * slope_[1][lane], v1 = place_[1][lane] + until * slope_[1][lane];
            const Real u_low = smaller(u0, u1) - margin, u_high = larger(u0, u1) + margin;
            const Real v_low = smaller(v0, v1) - margin, v_high = larger(v0, v1) + margin;
            const bool goes_on = rays_.reach[lane] > entry_[lane] + from * pace_[lane];
            const bool is_inside = (u_high >= 0) & (u_low <= end[0]) & (v_high >= 0) & (v_low <= end[1]);
            const bool is_alive = goes_on & is_inside;
            const bool is_here = is_alive & (to >= -margin);
            alive |= is_alive ? 1u : 0u;
            low[0][lane] = is_here ? u_low : infinity<Real>;
            low[1][lane] = is_here ? v_low : infinity<Real>;
            high[0][lane] = is_here ? u_high : -infinity<Real>;
            high[1][lane] = is_here ? v_high : -infinity<Real>;
        }
        Rectangle voxels;
        voxels.is_alive = alive != 0;
        // By halves: compilers do not change the order of a float's minimum.
        for (uint32_t half = lanes / 2; half > 0; half /= 2)
            for (uint32_t lane = 0; lane < half; ++lane)
                for (int i = 0; i < 2; ++i) {
                    low[i][lane] = smaller(low[i][lane], low[i][lane + half]);
                    high[i][lane] = larger(high[i][lane], high[i][lane + half]);
                }
        for (int i = 0; i < 2 && low[0][0] < infinity<Real>; ++i) {
            voxels.low[i] = int32_t(clamped(low[i][0], Real(0), end[i] - 1));
            voxels.high[i] = int32_t(clamped(high[i][0], Real(0), end[i] - 1));
            voxels.least[i] = grid_.lower[across_[i]] + low[i][0] * grid_.voxel[across_[i]];
            voxels.most[i] = grid_.lower[across_[i]] + high[i][0] * grid_.voxel[across_[i]];
        }
        return voxels;
    }

    /// Where a ray meets a sphere, the sphere reaches into what the rays cross of that slice.
    HD_INNER bool reaches(const Rectangle& voxels, const Sphere<Real>& sphere) const {
        const Real radius = sphere.radius + grid_.inflation;
        const Real u = sphere.center[across_[0]], v = sphere.center[across_[1]];
        return (u + radius >= voxels.least[0]) & (u - radius <= voxels.most[0]) & (v + radius >= voxels.least[1]) &
               (v - radius <= voxels.most[1]);
    }
    /// Spheres reach into several voxels: those met a moment ago are not met again.
    template <class Meet>
    HD_INNER void visit(int32_t slice, const Rectangle& voxels, uint32_t (&recent)[recent_size], const Meet& meet) {
        const uint32_t stride[3] = {1, uint32_t(grid_.size.x), uint32_t(grid_.size.x) * uint32_t(grid_.size.y)};
        for (int32_t v = voxels.low[1]; v <= voxels.high[1]; ++v)
            for (int32_t u = voxels.low[0]; u <= voxels.high[0]; ++u) {
                uint32_t link = grid_.heads[uint32_t(slice) * stride[axis_] + uint32_t(u) * stride[across_[0]] +
                                            uint32_t(v) * stride[across_[1]]];
                while (link != no_link) {
                    const GridLink current = grid_.links[link];
                    link = current.next;
                    uint32_t& last = recent[current.primitive % recent_size];
                    if (last == current.primitive || !reaches(voxels, spheres_[current.primitive]))
                        continue;
                    last = current.primitive;
                    meet(current.primitive);
                }
            }
    }

    const GridView<Real>& grid_;
    std::span<const Sphere<Real>> spheres_;
    const RayPacket<Real>& rays_;
    int axis_ = 0;
    int across_[2] = {1, 2};
    bool forward_ = true;
    bool is_coherent_ = false;
    uint32_t enters_[lanes];
    alignas(64) Real entry_[lanes]; ///< distance
    // In voxels; what depends on distance, per voxel along the axis.
    alignas(64) Real start_[lanes];
    Real pace_[lanes]; ///< distance
    Real place_[2][lanes];
    Real slope_[2][lanes];
};

} // namespace proxima
