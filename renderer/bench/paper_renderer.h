// SPDX-License-Identifier: Apache-2.0
// A baseline for experiments: frames made as R. Thomas and S. K. Semwal make them ("Ray Tracing using 3D Grid
// Simulations", 2014): move, empty the voxels, fill them, measure the distances pair by pair, trace. The scene, the
// bounds and the shading are the renderer's own, so that the pictures can be compared bit by bit.
#pragma once
#include "kernels/baselines/paper_cloud.h"
#include "kernels/baselines/paper_trace.h"
#include "renderer/device_scene.h"
#include "renderer/film_reader.h"
#include "renderer/grid_builder.h"
#include "renderer/step_clock.h"

namespace proxima::baselines {

/// For scenes of plain opaque spheres, in float, by a grid or a cloud whose size is asked for.
template <class Backend> class PaperRenderer : public FrameRenderer {
public:
    explicit PaperRenderer(auto... arguments) : backend_(arguments...) {}

    std::string name() const override { return backend_.name(); }

    void set_scene(const SceneProgram& program, Precision) override {
        backend_.activate();
        scene_.upload(program);
    }

    using FrameRenderer::render;
    FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime> times, Image& image) override {
        backend_.activate();
        FrameStatistics statistics;
        film_.resize(size_t(settings.width) * settings.height);
        const FilmView film{film_.view(), settings.width, settings.height, 1};
        if (!times.empty())
            clock_.step(FrameStep::motion, [&] { scene_.move(times.front()); });
        SceneView<float> scene = scene_.view();
        clock_.step(FrameStep::build, [&] { build_grid(scene, settings); });
        if (settings.accelerator == Accelerator::cloud)
            clock_.step(FrameStep::map, [&] { measure_distances(settings.metric); });
        clock_.step(FrameStep::trace, [&] { trace(scene, film); });
        backend_.synchronize();
        clock_.settle([&](FrameStep step, StepWatch::Time begin, StepWatch::Time end) {
            double& total = step == FrameStep::motion  ? statistics.motion_ms
                            : step == FrameStep::build ? statistics.build_ms
                            : step == FrameStep::map   ? statistics.cloud_ms
                                                       : statistics.trace_ms;
            total += std::chrono::duration<double, std::milli>(end - begin).count();
        });
        reader_.read(film_, film, settings, image, statistics);
        statistics.method = settings.accelerator == Accelerator::cloud ? "paper-cloud" : "paper-grid";
        statistics.grid = settings.grid;
        statistics.metric = settings.metric;
        statistics.peak_device_bytes = backend_.memory().peak();
        return statistics;
    }

private:
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    void build_grid(SceneView<float>& scene, const FrameSettings& settings) {
        bounds_.find_bounds(scene.geometry);
        const auto [x, y, z] = settings.grid;
        paper_.grid = make_grid(scene.geometry.bounds, Vec3<int32_t>(x, y, z));
        for (;; paper_.capacity *= 2) { // "that array can be increased"
            words_.resize(size_t(paper_.grid.cell_count()) * paper_.stride());
            paper_.words = words_.view();
            overflows_.resize(1);
            overflows_.fill_bytes(0);
            backend_.for_each(x * y, ClearPaperVoxels{paper_});
            backend_.for_each(scene.geometry.sphere_count(),
                              FillPaperVoxels{paper_, scene.geometry, overflows_.view()});
            if (overflows_.read(0) == 0)
                return;
        }
    }

    void measure_distances(Metric metric) {
        const uint32_t voxels = paper_.grid.cell_count();
        filled_.resize(voxels);
        filled_count_.resize(1);
        filled_count_.fill_bytes(0);
        distances_.resize(voxels);
        map_.resize(voxels);
        backend_.for_each(voxels, ListFilledVoxels{paper_, filled_.view(), filled_count_.view(), distances_.view()});
        const uint32_t filled = filled_count_.read(0), most = std::max((1u << 30) / voxels, 1u);
        for (uint32_t first = 0; first < filled; first += most) {
            const uint32_t count = std::min(most, filled - first);
            backend_.for_each(voxels * count,
                              MeasurePairs{paper_, metric, filled_.view().subspan(first, count), distances_.view()});
        }
        backend_.for_each(voxels, NarrowDistances{distances_.view(), map_.view()});
        paper_.grid.cloud = {.size = paper_.grid.size, .shift = 0, .metric = metric, .distances = map_.view()};
    }

    void trace(const SceneView<float>& scene, const FilmView& film) {
        const auto pixels = uint32_t(tiled_pixel_count(film.width, film.height));
        backend_.for_each(pixels, TracePaperPixels{{scene, film}, paper_});
        backend_.for_each(uint32_t(film.pixels.size()), ResolvePixels{film, scene_.curve(), scene_.gamma()});
    }

    Backend backend_;
    DeviceScene<Backend, float> scene_{backend_};
    GridBuilder<Backend, float> bounds_{backend_};
    FilmReader<Backend> reader_{backend_};
    StepClock<Backend> clock_{backend_};
    PaperGridView paper_;
    Buffer<uint32_t> words_{backend_};
    Buffer<uint32_t> overflows_{backend_};
    Buffer<uint32_t> filled_{backend_};
    Buffer<uint32_t> filled_count_{backend_};
    Buffer<uint32_t> distances_{backend_};
    Buffer<uint8_t> map_{backend_};
    Buffer<glm::vec3> film_{backend_};
};

} // namespace proxima::baselines
