// SPDX-License-Identifier: Apache-2.0
// A scene on a device: every array of it, listed once. A SceneProgram comes in; views for the kernels go out.
#pragma once
#include "kernels/grid_build.h"
#include "kernels/scene_view.h"
#include "parser/scene_program.h"
#include "renderer/device_motion.h"
#include "renderer/large_spheres.h"
#include "renderer/scene_needs.h"
#include "renderer/spatial_order.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace proxima {

template <class Real> Vec3<Real> convert(const Vec3<double>& v) {
    return Vec3<Real>(v);
}
template <class Real> Sphere<Real> convert(const Sphere<double>& s) {
    // A negative radius renders nothing, as in POV-Ray.
    return {Vec3<Real>(s.center), s.radius > 0 ? Real(s.radius) : Real(0)};
}
template <class Real> Affine<Real> convert(const Affine<double>& a) {
    return {Mat3<Real>(a.linear), Vec3<Real>(a.offset)};
}
template <class Real> Ellipsoid<Real> convert(const Ellipsoid<double>& e) {
    return {convert<Real>(e.object_from_world), convert<Real>(e.world_from_object), e.material};
}
template <class Real> Plane<Real> convert(const Plane<double>& p) {
    return {Vec3<Real>(p.normal), Real(p.distance), p.material};
}
template <class Real> Light<Real> convert(const Light<double>& l) {
    return {Vec3<Real>(l.position),
            l.color,
            l.fade_distance,
            l.fade_power,
            l.shadowless,
            l.kind,
            l.parallel,
            l.area,
            Vec3<Real>(l.point_at),
            Vec3<Real>(l.direction),
            Real(l.radius),
            Real(l.falloff),
            Real(l.tightness)};
}
template <class Real> AreaLight<Real> convert(const AreaLight<double>& a) {
    return {Vec3<Real>(a.axis1), Vec3<Real>(a.axis2), a.columns,     a.rows, a.circular, a.orient, a.jitter,
            a.adaptive,          a.first_sample,      a.sample_count};
}
template <class Real> Fog<Real> convert(const Fog<double>& f) {
    return {f.kind,           f.color,          f.filter,       f.transmit,
            Real(f.distance), Vec3<Real>(f.up), Real(f.offset), Real(f.altitude)};
}

template <class Backend, class Real> class DeviceScene {
public:
    explicit DeviceScene(Backend& backend)
        : motion_(backend), shapes_(backend), exact_(backend), device_order_(backend), sphere_materials_(backend),
          materials_(backend), layers_(backend), pigments_(backend), patterns_(backend), color_stops_(backend),
          finishes_(backend), interiors_(backend), transforms_(backend), lights_(backend), area_lights_(backend),
          area_samples_(backend), sky_pigments_(backend), fogs_(backend) {}

    void upload(const SceneProgram& scene) {
        view_ = {};
        sphere_count_ = uint32_t(scene.spheres.size());
        tables_move_ = !scene.motion.fields.empty();
        if (tables_move_) {
            moving_tables_ = scene;
            moving_fields_.numbers = scene.motion.numbers;
            moving_fields_.fields = scene.motion.fields;
            moving_fields_.splines = scene.motion.splines;
        }
        upload_spheres(scene);
        upload_tables(scene);
        time_.reset();
    }

    /// Starts moving everything to where it is at `time`. False when a number that is not of one sphere has no finite
    /// value then.
    bool move(const MotionTime& time) {
        if (time_ == time)
            return true;
        time_.reset();
        if (!motion_.empty() && !motion_.template move<Real>(time, shapes_.spheres.view(), exact_.spheres.view()))
            return false;
        if (tables_move_) {
            if (!move_fields(moving_tables_, moving_fields_, time))
                return false;
            upload_tables(moving_tables_);
        }
        time_ = time;
        return true;
    }
    bool moves() const { return !motion_.empty() || tables_move_; }
    /// Whether a sphere has had no finite place since the last call. Waits for the device.
    bool take_motion_failure() { return motion_.take_failure(); }

    /// Without grid, limits and large primitives: the frame adds them.
    const SceneView<Real>& view() const { return view_; }
    const SceneNeeds& needs() const { return needs_; }
    /// Of each of the device's spheres, its place in the scene; empty where they are the same. Goes to the device when
    /// it is asked for first.
    std::span<const uint32_t> sphere_order() {
        if (device_order_.size() != order_.size())
            device_order_.upload(order_.size(), [&](size_t i) { return order_[i]; });
        return device_order_.view();
    }
    FilmCurve curve() const { return curve_; }
    float gamma() const { return gamma_; }

private:
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    template <class R> struct Shapes {
        Buffer<Sphere<R>> spheres;
        Buffer<Ellipsoid<R>> ellipsoids;
        Buffer<Plane<R>> planes;

        explicit Shapes(Backend& backend) : spheres(backend), ellipsoids(backend), planes(backend) {}
        ShapesView<R> view() { return {spheres.view(), ellipsoids.view(), planes.view()}; }
    };

    void upload_spheres(const SceneProgram& scene) {
        order_ = spatial_order(scene);
        device_order_.resize(0);
        const auto original = [&](size_t i) { return order_.empty() ? i : order_[i]; };
        const auto upload = [&]<class R>(Buffer<Sphere<R>>& spheres) {
            spheres.upload(scene.spheres.size(), [&](size_t i) { return convert<R>(scene.spheres[original(i)]); });
        };
        upload(shapes_.spheres);
        has_exact_ = !std::is_same_v<Real, double> &&
                     (tables_move_ || needs_of(scene, sphere_count_).features != Features::opaque ||
                      has_large_sphere(scene.spheres));
        if (has_exact_)
            upload(exact_.spheres);
        else
            exact_.spheres.resize(0);
        sphere_materials_.upload(scene.spheres.size(), [&](size_t i) { return scene.sphere_materials[original(i)]; });
        motion_.upload(scene.motion, order_);
    }

    void upload_tables(const SceneTables& scene) {
        needs_ = needs_of(scene, sphere_count_);
        const auto upload = [&]<class R>(Shapes<R>& shapes) {
            upload_converted<R>(shapes.ellipsoids, scene.ellipsoids);
            upload_converted<R>(shapes.planes, scene.planes);
        };
        upload(shapes_);
        static_cast<ShapesView<Real>&>(view_.geometry) = shapes_.view();
        if (has_exact_) {
            upload(exact_);
            view_.exact = exact_.view();
        }
        view_.geometry.sphere_materials = sphere_materials_.view();

        upload_copy(materials_, scene.materials);
        upload_copy(layers_, scene.layers);
        upload_copy(pigments_, scene.pigments);
        upload_copy(patterns_, scene.patterns);
        upload_copy(color_stops_, scene.color_stops);
        upload_copy(finishes_, scene.finishes);
        upload_copy(interiors_, scene.interiors);
        upload_converted<Real>(transforms_, scene.transforms);
        upload_converted<Real>(lights_, scene.lights);
        upload_converted<Real>(area_lights_, scene.area_lights);
        upload_copy(area_samples_, scene.area_samples);
        upload_copy(sky_pigments_, scene.sky.pigments);
        upload_converted<Real>(fogs_, scene.fogs);

        view_.surfaces = {materials_.view(), layers_.view(),      pigments_.view(),
                          patterns_.view(),  color_stops_.view(), finishes_.view(),
                          interiors_.view(), transforms_.view(),  scene.legacy_transparency};
        view_.lights = lights_.view();
        view_.area_lights = area_lights_.view();
        view_.area_samples = area_samples_.view();
        view_.sky_pigments = sky_pigments_.view();
        view_.fogs = fogs_.view();
        view_.camera = scene.camera;
        view_.background = scene.background;
        view_.sky_emission = scene.sky.emission;
        view_.ambient_light = scene.ambient_light;
        view_.adc_bailout = scene.adc_bailout;
        view_.max_trace_level = scene.max_trace_level;
        view_.has_fading = std::any_of(scene.interiors.begin(), scene.interiors.end(),
                                       [](const Interior& i) { return i.fade_power > 0 && i.fade_distance != 0; });
        const auto any_material = [&](uint32_t flags) {
            return std::any_of(scene.materials.begin(), scene.materials.end(),
                               [&](const Material& m) { return (m.flags & flags) != 0; });
        };
        view_.has_no_shadow = any_material(material_no_shadow);
        view_.has_hidden = any_material(material_no_image | material_no_reflection);
        curve_ = scene.working_curve == WorkingCurve::linear  ? FilmCurve::linear
                 : scene.working_curve == WorkingCurve::power ? FilmCurve::power
                                                              : FilmCurve::srgb;
        gamma_ = scene.working_gamma;
    }
    template <class T> static void upload_copy(Buffer<T>& buffer, const std::vector<T>& values) {
        buffer.upload(values.size(), [&](size_t i) { return values[i]; });
    }
    template <class R, class T, class S> static void upload_converted(Buffer<T>& buffer, const std::vector<S>& values) {
        buffer.upload(values.size(), [&](size_t i) { return convert<R>(values[i]); });
    }

    DeviceMotion<Backend> motion_;
    std::optional<MotionTime> time_; ///< what the device's arrays show; none: the time of the script's evaluation
    bool tables_move_ = false;
    SceneTables moving_tables_;
    MotionPrograms moving_fields_;

    Shapes<Real> shapes_;
    Shapes<double> exact_; ///< SceneView::exact
    bool has_exact_ = false;
    uint32_t sphere_count_ = 0;
    std::vector<uint32_t> order_; ///< see sphere_order
    Buffer<uint32_t> device_order_;
    Buffer<uint32_t> sphere_materials_;
    Buffer<Material> materials_;
    Buffer<Layer> layers_;
    Buffer<Pigment> pigments_;
    Buffer<Pattern> patterns_;
    Buffer<ColorStop> color_stops_;
    Buffer<Finish> finishes_;
    Buffer<Interior> interiors_;
    Buffer<Affine<Real>> transforms_;
    Buffer<Light<Real>> lights_;
    Buffer<AreaLight<Real>> area_lights_;
    Buffer<AreaSample> area_samples_;
    Buffer<uint32_t> sky_pigments_;
    Buffer<Fog<Real>> fogs_;
    SceneView<Real> view_;
    SceneNeeds needs_;
    FilmCurve curve_ = FilmCurve::linear;
    float gamma_ = 1.0f;
};

} // namespace proxima
