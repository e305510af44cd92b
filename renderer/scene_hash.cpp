// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene_hash.h"

#include <fmt/format.h>
#include <memory>
#include <new>
#include <type_traits>
#include <xxhash.h>

namespace proxima {
namespace {

/// What has no bytes between its members: the bytes are the value.
template <class T> constexpr bool is_packed = std::is_arithmetic_v<T> || std::is_enum_v<T>;
template <glm::length_t n, class T> constexpr bool is_packed<glm::vec<n, T>> = true;
template <class Real> constexpr bool is_packed<Affine<Real>> = sizeof(Affine<Real>) == 12 * sizeof(Real);
template <class Real> constexpr bool is_packed<Sphere<Real>> = sizeof(Sphere<Real>) == 4 * sizeof(Real);
template <> constexpr bool is_packed<Material> = sizeof(Material) == 4 * 4;
template <> constexpr bool is_packed<Layer> = sizeof(Layer) == 2 * 4;
template <> constexpr bool is_packed<Pigment> = sizeof(Pigment) == 13 * 4;
template <> constexpr bool is_packed<Pattern> = sizeof(Pattern) == 6 * 4;
template <> constexpr bool is_packed<ColorStop> = sizeof(ColorStop) == 7 * 4;
template <> constexpr bool is_packed<Finish> = sizeof(Finish) == 24 * 4;
template <> constexpr bool is_packed<Interior> = sizeof(Interior) == 6 * 4;
template <> constexpr bool is_packed<AreaLight<double>> = sizeof(AreaLight<double>) == 6 * 8 + 8 * 4;
template <> constexpr bool is_packed<AreaSample> = sizeof(AreaSample) == 3 * 4;
template <> constexpr bool is_packed<Fog<double>> = sizeof(Fog<double>) == 6 * 4 + 6 * 8;
template <> constexpr bool is_packed<MotionInstruction> = sizeof(MotionInstruction) == 4;

/// Takes values one after the other. The structured bindings below stop compiling when a member is added: it belongs
/// into the hash.
class Hasher {
public:
    Hasher() : state_(XXH3_createState(), XXH3_freeState) {
        if (!state_)
            throw std::bad_alloc();
        XXH3_128bits_reset(state_.get());
    }

    Hash128 result() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        return {hash.high64, hash.low64};
    }

    void bytes(const void* data, size_t size) { XXH3_128bits_update(state_.get(), data, size); }

    template <class T>
    requires is_packed<T>
    void add(const T& value) { bytes(&value, sizeof value); }

    template <class T> void add(const std::vector<T>& values) {
        add(uint64_t(values.size()));
        if constexpr (is_packed<T>)
            bytes(values.data(), values.size() * sizeof(T));
        else
            for (const T& value : values)
                add(value);
    }

    template <class First, class Second, class... Rest>
    void add(const First& first, const Second& second, const Rest&... rest) {
        add(first);
        add(second);
        (add(rest), ...);
    }

    void add(const Ellipsoid<double>& value) {
        const auto& [object_from_world, world_from_object, material] = value;
        add(object_from_world, world_from_object, material);
    }
    void add(const Plane<double>& value) {
        const auto& [normal, distance, material] = value;
        add(normal, distance, material);
    }
    void add(const Camera<double>& value) {
        const auto& [kind, location, direction, right, up] = value;
        add(kind, location, direction, right, up);
    }
    void add(const Light<double>& value) {
        const auto& [position, color, fade_distance, fade_power, shadowless, kind, parallel, area, point_at, direction,
                     radius, falloff, tightness] = value;
        add(position, color, fade_distance, fade_power, shadowless, kind, parallel, area, point_at, direction, radius,
            falloff, tightness);
    }
    void add(const SkySphere& value) {
        const auto& [pigments, emission] = value;
        add(pigments, emission);
    }
    void add(const SceneTables& value) {
        const auto& [ellipsoids, planes, materials, layers, pigments, patterns, color_stops, finishes, interiors,
                     transforms, lights, area_lights, area_samples, camera, sky, fogs, background, ambient_light,
                     max_trace_level, adc_bailout, working_curve, working_gamma, legacy_transparency] = value;
        add(ellipsoids, planes, materials, layers, pigments, patterns, color_stops, finishes, interiors, transforms,
            lights, area_lights, area_samples, camera, sky, fogs, background, ambient_light, max_trace_level,
            adc_bailout, working_curve, working_gamma, legacy_transparency);
    }
    void add(const MotionProgram& value) {
        const auto& [target, first_instruction, instructions, first_output, first_shared, first_instance, instances,
                     own_constants, first_constant] = value;
        add(target, first_instruction, instructions, first_output, first_shared, first_instance, instances,
            own_constants, first_constant);
    }
    void add(const MotionField& value) {
        const auto& [table, type, index, offset] = value;
        add(table, type, index, offset);
    }
    void add(const MotionCode& value) {
        const auto& [programs, instructions, outputs, shared, constants, targets] = value;
        add(programs, instructions, outputs, shared, constants, targets);
    }
    void add(const MotionPrograms& value) {
        const auto& [spheres, uniforms, numbers, fields, splines] = value;
        add(spheres, uniforms, numbers, fields, splines);
    }

private:
    std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

} // namespace

std::string Hash128::text() const {
    return fmt::format("{:016x}{:016x}", high, low);
}

Hash128 hash_scene(const SceneProgram& scene) {
    Hasher hasher;
    hasher.add(scene.sphere_materials, scene.motion);
    if (scene.motion.empty()) {
        hasher.add(static_cast<const SceneTables&>(scene), scene.spheres);
        return hasher.result();
    }
    // Everything that moves to one time, whichever frame it was evaluated for.
    SceneProgram moved = scene;
    move(moved, {});
    hasher.add(static_cast<const SceneTables&>(moved), moved.spheres);
    return hasher.result();
}

Hash128 hash_text(std::string_view text) {
    Hasher hasher;
    hasher.bytes(text.data(), text.size());
    return hasher.result();
}

} // namespace proxima
