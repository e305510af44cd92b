// SPDX-License-Identifier: Apache-2.0
// Pilot rays: a few of a frame's rays, traced ahead of it. What they would look up in a grid or a cloud that was never
// built is counted on their way through one that was: the voxels follow from its size, the leaps from its distances,
// the primitives of a voxel from the lists of those built voxels that it overlaps.
#pragma once
#include "kernels/film.h"
#include "kernels/light.h"
#include "kernels/surface.h"

namespace proxima {

/// The part of a ray that a frame looks along: from the frame's bounds to what it meets.
template <class Real> struct PilotRay {
    Ray<Real> ray;
    Real length = Real(0);
    bool walks = false; ///< it meets the bounds at all
};

/// Which pilots a frame sends out. A pilot is a pixel, and stands for many; its rays are those of a path: at each of
/// `surfaces` surfaces the ray that found it and one to each of `lights` lights. 16 pilots are every other pixel of a
/// tile, like the threads of a warp, and the tiles lie where the R2 sequence has them.
struct PilotPattern {
    static constexpr uint32_t together = tile_width * tile_height / 2;

    uint32_t width = 0, height = 0; ///< of the picture
    uint32_t tiles = 0;
    uint32_t surfaces = 1;
    uint32_t lights = 0;

    HD uint32_t pilots() const { return tiles * together; }
    HD uint32_t rays_each() const { return surfaces * (1 + lights); }
    HD uint32_t rays() const { return pilots() * rays_each(); }
    /// May lie outside the picture.
    HD PixelPosition pixel(uint32_t pilot) const {
        const uint32_t across = (width + tile_width - 1) / tile_width, down = (height + tile_height - 1) / tile_height;
        const SampleOffset<float> place = sample_offset<float>(pilot / together);
        const uint32_t within = pilot % together, y = within / (tile_width / 2);
        return {uint32_t(place.x * float(across)) * tile_width + within % (tile_width / 2) * 2 + y % 2,
                uint32_t(place.y * float(down)) * tile_height + y};
    }
};

/// Pilot -> its rays. Part p of all pilots stands before part p + 1 of any.
template <class Real> struct FindPilotRays {
    SceneView<Real> scene; ///< with a grid
    PilotPattern pattern;
    std::span<PilotRay<Real>> rays;

    HD void operator()(uint32_t pilot) const {
        for (uint32_t part = 0; part < pattern.rays_each(); ++part)
            rays[part * pattern.pilots() + pilot] = {};
        const PixelPosition pixel = pattern.pixel(pilot);
        if (pixel.x >= pattern.width || pixel.y >= pattern.height)
            return;
        const FilmView film{.pixels = {}, .width = pattern.width, .height = pattern.height};
        SourcedRay<Real> ray{pixel_ray(camera_in<Real>(scene.camera), film, pixel, 0), {}};
        for (uint32_t part = 0; part < pattern.rays_each(); part += 1 + pattern.lights)
            if (!follow(pilot, part, ray))
                return;
    }

private:
    /// Keeps a ray and those to the lights. False at the end of the path, else `ray` goes on from the surface.
    HD bool follow(uint32_t pilot, uint32_t part, SourcedRay<Real>& ray) const {
        const Hit<Real> hit = find(pilot, part, ray, scene.limits.nearest, scene.limits.farthest);
        if (hit.primitive == no_primitive)
            return false;
        const Surface<Real> surface = surface_at(scene, ray, rebase(ray, scene.geometry.bounds), hit);
        for (uint32_t i = 0; i < pattern.lights; ++i) {
            const Light<Real>& light = scene.lights[i];
            const LightRay<Real> way = light_ray(light, surface.point);
            if (light.shadowless || !(glm::dot(surface.normal, way.direction) > 0))
                continue;
            const Real margin = scene.limits.shadow_margin;
            const auto to_light = leave<Real>(scene.geometry, surface, way.direction, surface.from_inside);
            find(pilot, part + 1 + i, to_light, margin, way.distance - margin);
        }
        const uint32_t flags = scene.surfaces.materials[surface.material].flags;
        const Vec3<Real> direction = ray.ray.direction;
        if (flags & material_transparent)
            ray = leave<Real>(scene.geometry, surface, direction, !surface.from_inside);
        else if (flags & material_reflective)
            ray = leave<Real>(scene.geometry, surface, glm::reflect(direction, surface.normal), surface.from_inside);
        else
            return false;
        return true;
    }

    HD Hit<Real> find(uint32_t pilot, uint32_t part, const SourcedRay<Real>& ray, Real nearest, Real farthest) const {
        const BasedRay<Real> based = rebase(ray, scene.geometry.bounds);
        const Hit<Real> hit = find_nearest(scene, based, {}, nearest, farthest, 0);
        rays[part * pattern.pilots() + pilot] = {
            based.ray, hit.primitive == no_primitive ? farthest - based.offset : hit.t, based.meets_bounds};
        return hit;
    }
};

/// What a ray costs in a grid or cloud.
struct WalkCount {
    uint32_t lookups = 0; ///< of voxels and bricks
    uint32_t tests = 0;   ///< of primitives

    HD uint32_t sum() const { return lookups + tests; }
};

/// A grid that is looked at. It needs no lists; its cloud, if any, needs distances.
template <class Real> struct PlannedView {
    GridView<Real> grid;
    uint32_t place = 0; ///< among all that are looked at
};

/// Pilot ray of a plan -> what it would cost. Several plans' rays one plan after the other.
template <class Real> struct CountWalk {
    static constexpr uint32_t most_plans = 8;
    /// Tests are counted in every so-manieth voxel of a grid, since each takes a long way to memory; the rays of a
    /// group begin with different ones.
    static constexpr uint32_t voxels_a_count = 4;

    SceneView<Real> scene; ///< with the grid that was built
    std::span<const PilotRay<Real>> rays;
    std::span<WalkCount> counts; ///< of all places
    PlannedView<Real> plans[most_plans];

    HD void operator()(uint32_t index) const {
        const uint32_t count = uint32_t(rays.size()), ray = index % count;
        const PlannedView<Real>& plan = plans[index / count];
        counts[plan.place * count + ray] = rays[ray].walks ? walk(plan.grid, rays[ray], ray) : WalkCount{};
    }

private:
    HD WalkCount walk(const GridView<Real>& planned, const PilotRay<Real>& pilot, uint32_t first) const {
        const CloudView& cloud = planned.cloud;
        const bool by_length = cloud.metric == Metric::city_block || cloud.metric == Metric::euclidean;
        GridWalk<Real> place(planned, pilot.ray);
        const uint32_t map = cloud.metric == Metric::octant ? place.octant() * cloud.brick_count() : 0;
        const uint32_t each = cloud.in_use() ? 1 : voxels_a_count;
        WalkCount count;
        for (bool inside = true; inside;) {
            const Vec3<int32_t>& cell = place.cell;
            const int32_t distance =
                cloud.in_use() ? cloud.distances[size_t(map) + cloud.brick(cell.x, cell.y, cell.z)] : 0;
            if (distance == 0 && (first + count.lookups) % each == 0)
                count.tests += each * primitives_in(planned, cell);
            ++count.lookups;
            if (by_length && distance > 0)
                inside = place.leap_by_length(planned, distance);
            else
                inside = place.leave_block(planned, distance > 0 ? cloud.shift : 0, larger(distance, 1));
            inside = inside && place.now < pilot.length;
        }
        return count;
    }

    /// How many primitives the list of a planned voxel would have: each is counted in the one built voxel that holds
    /// the nearest point of the planned voxel to it, since several may list it.
    HD uint32_t primitives_in(const GridView<Real>& planned, const Vec3<int32_t>& cell) const {
        const GridView<Real>& built = scene.grid;
        const Vec3<Real> lower = planned.lower + Vec3<Real>(cell) * planned.voxel;
        const Box<Real> box{lower, lower + planned.voxel};
        const Vec3<int32_t> first = built.cell_at(box.lower), last = built.cell_at(box.upper);
        uint32_t count = 0;
        for (int32_t z = first.z; z <= last.z; ++z)
            for (int32_t y = first.y; y <= last.y; ++y)
                for (int32_t x = first.x; x <= last.x; ++x)
                    count += primitives_in(box, planned.inflation, {x, y, z});
        return count;
    }
    HD uint32_t primitives_in(const Box<Real>& box, Real inflation, const Vec3<int32_t>& cell) const {
        const GridView<Real>& built = scene.grid;
        if (built.cloud.in_use() && built.cloud.distances[built.cloud.brick(cell.x, cell.y, cell.z)] != 0)
            return 0;
        uint32_t count = 0, link = built.heads[built.slot(cell.x, cell.y, cell.z)];
        for (; link != no_link; link = built.links[link].next) {
            Vec3<Real> nearest;
            count += overlaps(box, inflation, built.links[link].primitive, nearest) && built.cell_at(nearest) == cell;
        }
        return count;
    }
    HD bool overlaps(const Box<Real>& box, Real inflation, uint32_t id, Vec3<Real>& nearest) const {
        const GeometryView<Real>& geometry = scene.geometry;
        if (geometry.is_sphere(id)) {
            const Sphere<Real>& sphere = geometry.spheres[id];
            for (int i = 0; i < 3; ++i)
                nearest[i] = clamped(sphere.center[i], box.lower[i], box.upper[i]);
            const Vec3<Real> offset = nearest - sphere.center;
            const Real radius = sphere.radius + inflation;
            return glm::dot(offset, offset) <= radius * radius;
        }
        const Box<Real> other = geometry.box(id);
        bool overlap = true;
        for (int i = 0; i < 3; ++i) {
            nearest[i] = larger(box.lower[i], other.lower[i]);
            overlap = overlap && nearest[i] <= smaller(box.upper[i], other.upper[i]);
        }
        return overlap;
    }
};

/// Number of one of every `stride` primitives -> its links in a grid that needs no lists.
template <class Real> struct SampleLinks {
    GridView<Real> planned;
    GeometryView<Real> geometry;
    uint32_t stride = 1;
    std::span<uint64_t> links; ///< one, that all are added to

    HD void operator()(uint32_t index) const {
        uint32_t count = 0;
        for_each_cell_of(planned, geometry, index * stride, [&](int32_t, int32_t, int32_t) { ++count; });
        count_up(&links[0], count);
    }
};

/// What all pilots cost: camera rays and those from surfaces on, then those to lights.
struct WalkTotal {
    struct Part {
        uint64_t lookups = 0, tests = 0;
    };
    Part all[2];     ///< of every ray
    Part slowest[2]; ///< of the slowest of each group
};

/// Group of pilot rays -> its part of the WalkTotal of its plan.
struct SumWalks {
    PilotPattern pattern;
    std::span<const WalkCount> counts;
    std::span<WalkTotal> total; ///< one

    HD void operator()(uint32_t group) const {
        const uint32_t first = group * pattern.together;
        const uint32_t part = first / pattern.pilots() % (1 + pattern.lights) > 0;
        WalkCount all, slowest;
        for (uint32_t i = first; i < first + pattern.together; ++i) {
            all = {all.lookups + counts[i].lookups, all.tests + counts[i].tests};
            slowest = counts[i].sum() > slowest.sum() ? counts[i] : slowest;
        }
        add(total[0].all[part], all);
        add(total[0].slowest[part], slowest);
    }

private:
    HD static void add(WalkTotal::Part& total, const WalkCount& count) {
        atomic_add(&total.lookups, uint64_t(count.lookups));
        atomic_add(&total.tests, uint64_t(count.tests));
    }
};

} // namespace proxima
