// SPDX-License-Identifier: Apache-2.0
// The transparent primitives that a ray is in, in the order in which it entered them, and what they do to light.
#pragma once
#include "kernels/surface.h"

namespace proxima {

/// A short list of primitive ids. A ray may be inside at most `capacity` primitives; more are dropped and noticed.
struct InteriorList {
    static constexpr uint32_t capacity = 32;

    uint32_t ids[capacity];
    uint32_t count = 0;
    bool overflow = false;

    HD uint32_t last() const { return count ? ids[count - 1] : no_primitive; }
    HD bool contains(uint32_t id) const {
        for (uint32_t i = 0; i < count; ++i)
            if (ids[i] == id)
                return true;
        return false;
    }
    HD void enter(uint32_t id) {
        if (count < capacity)
            ids[count++] = id;
        else
            overflow = true;
    }
    HD void leave(uint32_t id) {
        uint32_t kept = 0;
        for (uint32_t i = 0; i < count; ++i)
            if (ids[i] != id)
                ids[kept++] = ids[i];
        count = kept;
    }
    HD void toggle(uint32_t id) {
        if (contains(id))
            leave(id);
        else
            enter(id);
    }
    HD void copy_from(const InteriorList& other) {
        count = other.count;
        for (uint32_t i = 0; i < count; ++i)
            ids[i] = other.ids[i];
    }
    /// Leaves out what `repeats(earlier, later)` says is once more an earlier one.
    template <class Repeats> HD void leave_out_repeated(const Repeats& repeats) {
        uint32_t kept = 0;
        for (uint32_t i = 0; i < count; ++i) {
            bool is_new = true;
            for (uint32_t k = 0; k < kept && is_new; ++k)
                is_new = !repeats(ids[k], ids[i]);
            if (is_new)
                ids[kept++] = ids[i];
        }
        count = kept;
    }
    /// Enters in the order of the ids, whatever the order of the calls.
    HD void enter_sorted(uint32_t id) {
        if (contains(id))
            return;
        enter(id);
        for (uint32_t i = count; i-- > 1 && ids[i - 1] > ids[i];) {
            const uint32_t swapped = ids[i];
            ids[i] = ids[i - 1];
            ids[i - 1] = swapped;
        }
    }
};

template <class Real> HD const Interior& interior_of(const SceneView<Real>& scene, uint32_t primitive) {
    return scene.surfaces.interiors[scene.surfaces.materials[scene.geometry.material(primitive)].interior];
}

template <class Path, class Real> HD Path ior_of(const SceneView<Real>& scene, uint32_t primitive) {
    return primitive == no_primitive ? Path(1) : Path(interior_of(scene, primitive).ior);
}

/// For Fresnel's equation: the index on the far side of a primitive's surface over that of the near side. On the way
/// out the far side is taken to be what the ray entered last, the primitive itself included, as POV-Ray has it.
template <class Real>
HD Real far_over_near_ior(const SceneView<Real>& scene, const InteriorList& interiors, uint32_t primitive) {
    const Real own = ior_of<Real>(scene, primitive);
    if (!interiors.contains(primitive))
        return own / ior_of<Real>(scene, interiors.last());
    return (interiors.count > 1 ? ior_of<Real>(scene, interiors.last()) : Real(1)) / own;
}

/// For Snell's law: the index on the near side over that of the far side, by what the ray has entered. A ray that
/// leaves something other than what it entered last does not bend.
template <class Path, class Real>
HD Path crossing_ior_ratio(const SceneView<Real>& scene, const InteriorList& interiors, uint32_t primitive) {
    const Path own = ior_of<Path>(scene, primitive);
    if (!interiors.contains(primitive))
        return ior_of<Path>(scene, interiors.last()) / own;
    if (interiors.last() != primitive)
        return Path(1);
    return own / ior_of<Path>(scene, interiors.count > 1 ? interiors.ids[interiors.count - 2] : no_primitive);
}

/// The primitives around a point, opaque ones too, in the order of their ids; each place once.
template <class Path, class Real> HD InteriorList interiors_at(const SceneView<Real>& scene, const Vec3<Path>& point) {
    InteriorList list;
    for_each_around(scene, Vec3<Real>(point), [&](uint32_t id) {
        if (contains(shapes_of<Path>(scene), id, point))
            list.enter_sorted(id);
    });
    list.leave_out_repeated([&](uint32_t a, uint32_t b) { return scene.is_repeated(a, b); });
    return list;
}

/// What is left of light that leaves a primitive's inside after a way of length `distance` since its last hit.
/// As in POV-Ray, no other interior that the ray is in counts. `least_fade`: see HitLimits.
template <class Real> HD Vec3<Real> attenuation(const Interior& interior, Real distance, float least_fade) {
    if (!(interior.fade_power > 0) || !(magnitude(interior.fade_distance) > least_fade))
        return Vec3<Real>(Real(1));
    const Real depth = distance / Real(interior.fade_distance);
    const Vec3<Real> tint(interior.fade_color);
    const Vec3<Real> darkening = Vec3<Real>(Real(1)) - tint;
    if (interior.fade_power >= 1000) // POV-Ray's sign for Beer's law
        return {exponential(-depth * darkening.x), exponential(-depth * darkening.y),
                exponential(-depth * darkening.z)};
    return tint + darkening / (Real(1) + power(depth, Real(interior.fade_power)));
}

} // namespace proxima
