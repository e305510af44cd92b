// SPDX-License-Identifier: Apache-2.0
#include "tests/extremes/probe.h"
#include "kernels/film.h"
#include "kernels/surface.h"
#include "renderer/backend_cpu.h"
#include "renderer/device_scene.h"
#include "renderer/grid_builder.h"

namespace proxima::testing {
namespace {

template <class Real, class Path> struct ProbeHits {
    SceneView<Real> scene;
    FilmView film;
    std::span<const uint32_t> order; ///< of each sphere, its place in the scene; empty where they are the same
    std::span<ProbedHit> out;

    void operator()(uint32_t index) const {
        const PixelPosition pixel{index % film.width, index / film.width};
        const SourcedRay<Path> ray{pixel_ray(camera_in<Path>(scene.camera), film, pixel, 0), {}};
        const BasedRay<Real> based = rebase(ray, scene.geometry.bounds);
        const Hit<Real> hit = find_nearest(scene, based, {}, scene.limits.nearest, scene.limits.farthest, 0);
        ProbedHit& result = out[index];
        if (hit.primitive == no_primitive)
            return;
        const Surface<Path> surface = surface_at(scene, ray, based, hit);
        result.id = 1 + (hit.primitive < order.size() ? order[hit.primitive] : hit.primitive);
        result.from_eye = Vec3<double>(surface.point) - scene.camera.location;
        result.normal = Vec3<double>(surface.outward);
    }
};

template <class Real> void run(const SceneProgram& program, const FrameSettings& settings, Probes& probes) {
    CpuBackend backend;
    DeviceScene<CpuBackend, Real> device(backend);
    GridBuilder<CpuBackend, Real> grid(backend);
    device.upload(program);
    SceneView<Real> scene = device.view();
    if (settings.tolerances == Tolerances::povray)
        scene.limits = HitLimits<Real>::povray();
    grid.find_bounds(scene.geometry);
    if (settings.accelerator != Accelerator::brute)
        grid.build(scene, {});
    FilmView film{{}, settings.width, settings.height, 1};
    const auto count = uint32_t(probes.hits.size());
    if (device.needs().features == Features::opaque)
        backend.for_each(count, ProbeHits<Real, Real>{scene, film, device.sphere_order(), probes.hits});
    else
        backend.for_each(count, ProbeHits<Real, double>{scene, film, device.sphere_order(), probes.hits});
}

} // namespace

Probes probe(const SceneProgram& scene, const FrameSettings& settings) {
    Probes probes{settings.width, settings.height, {}};
    probes.hits.resize(size_t(settings.width) * settings.height);
    if (settings.precision == Precision::float64)
        run<double>(scene, settings, probes);
    else
        run<float>(scene, settings, probes);
    return probes;
}

SceneProgram seen_beside(const SceneProgram& scene, const FrameSettings& settings, double x, double y) {
    SceneProgram moved = scene;
    Camera<double>& camera = moved.camera;
    const Vec3<double> aside = x / settings.width * camera.right - y / settings.height * camera.up;
    (camera.kind == CameraKind::orthographic ? camera.location : camera.direction) += aside;
    return moved;
}

} // namespace proxima::testing
