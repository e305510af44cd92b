// SPDX-License-Identifier: Apache-2.0
#include "tests/parser/scene_numbers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proxima::testing {
namespace {

class Numbers {
public:
    explicit Numbers(const SceneProgram& scene) : scene_(scene) {
        for (size_t i = 0; i < scene.spheres.size(); ++i) {
            add(scene.spheres[i].center);
            add({scene.spheres[i].radius});
            add_material(scene.sphere_materials[i]);
        }
        for (const Plane<double>& plane : scene.planes) {
            add(plane.normal);
            add({plane.distance});
            add_material(plane.material);
        }
        for (const Light<double>& light : scene.lights) {
            add(light.position);
            add(light.color);
            add(light.point_at);
            add(light.direction);
            add({light.radius, light.falloff, light.tightness, light.fade_distance, light.fade_power});
        }
        for (const Fog<double>& fog : scene.fogs) {
            add(fog.color);
            add({fog.distance, fog.filter, fog.transmit});
        }
        add(scene.camera.location);
        add(scene.camera.direction);
        add(scene.camera.right);
        add(scene.camera.up);
        add(scene.background);
        add_ellipsoids();
    }

    const std::vector<double>& all() const { return all_; }

private:
    void add(std::initializer_list<double> numbers) { all_.insert(all_.end(), numbers); }
    template <class Vector> void add(const Vector& v) { add({double(v.x), double(v.y), double(v.z)}); }
    void add(const Affine<double>& map) {
        for (int i = 0; i < 3; ++i)
            add(map.linear[i]);
        add(map.offset);
    }
    void add(const PigmentColor& color) {
        add(color.rgb);
        add({color.filter, color.transmit});
    }
    void add_material(uint32_t index) {
        const Material& material = scene_.materials[index];
        add({double(material.flags)});
        for (uint32_t i = 0; i < material.layer_count; ++i) {
            const Layer& layer = scene_.layers[material.first_layer + i];
            add_pigment(layer.pigment);
            const Finish& finish = scene_.finishes[layer.finish];
            add(finish.ambient);
            add({finish.diffuse, finish.brilliance, finish.phong, finish.phong_size, finish.specular,
                 finish.inverse_roughness, finish.metallic});
            add(finish.reflection_min);
            add(finish.reflection_max);
        }
    }
    void add_pigment(uint32_t index) {
        const Pigment& pigment = scene_.pigments[index];
        add(pigment.color);
        add(pigment.second_color);
        add(pigment.transform == Pigment::no_transform ? Affine<double>() : scene_.transforms[pigment.transform]);
        if (!has_color_map(pigment.kind))
            return;
        const Pattern& pattern = scene_.patterns[pigment.pattern];
        add({pattern.frequency, pattern.phase, pattern.exponent});
        for (uint32_t k = 0; k < pattern.stop_count; ++k) {
            const ColorStop& stop = scene_.color_stops[pattern.first_stop + k];
            add({stop.value});
            if (stop.pigment == ColorStop::no_pigment)
                add(stop.color);
            else
                add_pigment(stop.pigment);
        }
    }
    /// A union's spheres that become ellipsoids in time may stand in another order.
    void add_ellipsoids() {
        std::vector<std::vector<double>> each;
        for (const Ellipsoid<double>& ellipsoid : scene_.ellipsoids) {
            std::vector<double> outer = std::exchange(all_, {});
            add(ellipsoid.world_from_object);
            add(ellipsoid.object_from_world);
            add_material(ellipsoid.material);
            each.push_back(std::exchange(all_, std::move(outer)));
        }
        std::ranges::sort(each);
        for (const std::vector<double>& ellipsoid : each)
            all_.insert(all_.end(), ellipsoid.begin(), ellipsoid.end());
    }

    const SceneProgram& scene_;
    std::vector<double> all_;
};

} // namespace

std::vector<double> numbers_of(const SceneProgram& scene) {
    return Numbers(scene).all();
}

Likeness likeness(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size())
        return Likeness::none;
    Likeness result = Likeness::bits;
    for (size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i])
            return Likeness::none;
        else if (std::signbit(a[i]) != std::signbit(b[i]))
            result = Likeness::but_signs_of_zeros;
    return result;
}

} // namespace proxima::testing
