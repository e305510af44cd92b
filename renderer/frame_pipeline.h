// SPDX-License-Identifier: Apache-2.0
// A frame, written once for every backend: bounds, grid, trace, resolve, read back. A scene and settings come in; the
// picture and what it took go out.
#pragma once
#include "renderer/aov_tracer.h"
#include "renderer/device_scene.h"
#include "renderer/film_reader.h"
#include "renderer/film_tracer.h"
#include "renderer/frame_renderer.h"
#include "renderer/grid_builder.h"
#include "renderer/grid_copy.h"
#include "renderer/method_choice.h"
#include "renderer/step_clock.h"

#include <optional>
#include <stdexcept>

namespace proxima {

/// The device that builds for another one failed.
struct BuilderFailed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

template <class Backend, class Real> class FramePipeline {
public:
    /// `choice` is of all that renders on the device.
    FramePipeline(Backend& backend, std::shared_ptr<MethodChoice> choice)
        : backend_(backend), scene_(backend), grid_(backend), tracer_(backend), aovs_(backend), reader_(backend),
          film_(backend), sum_(backend), choice_(std::move(choice)), clock_(backend), copy_(backend) {}

    void set_scene(const SceneProgram& program) {
        scene_.upload(program);
        moved_to_.reset();
        built_for_.reset();
        grid_.forget();
        choice_->expect_change();
    }

    /// `builder` has the same scene on another device and builds for this one; null for nobody.
    void relay_from(FramePipeline* builder) {
        builder_ = builder;
        if (builder)
            backend_.expect_copies_from(builder->backend_);
    }

    /// The scene at each of `times`, and their mean; as it was evaluated without any.
    FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime> times, StepWatch* watch,
                           Image& image) {
        watch_ = watch;
        clock_.clear();
        try {
            return render(settings, times, image);
        } catch (const DeviceError& error) {
            if (error.kind == DeviceError::Kind::out_of_memory)
                free_film();
            throw;
        }
    }

private:
    static constexpr uint64_t most_pixels = (1ull << 32) / 3; ///< kernels count samples in 32 bits
    template <class T> using Buffer = typename Backend::template Buffer<T>;

    FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime> times, Image& image) {
        FrameStatistics statistics;
        const FilmView film = make_film(settings); // before the grid, which makes do with what is left
        const uint32_t exposures = std::max<uint32_t>(1, uint32_t(times.size()));
        if (exposures > 1)
            sum_.resize(film.pixels.size());
        for (uint32_t exposure = 0; exposure < exposures; ++exposure) {
            if (!times.empty())
                move(times[exposure]);
            expose(settings, film, statistics);
            if (settings.aovs.any() && exposure == exposures / 2)
                step(FrameStep::trace,
                     [&] { aovs_.trace(built_, scene_.needs().features, film, scene_.sphere_order()); });
            if (exposures > 1)
                backend_.for_each(uint32_t(film.pixels.size()),
                                  AverageExposures{film.pixels, sum_.view(), exposure, exposures});
        }
        if (scene_.take_motion_failure())
            throw MotionUndefined("a sphere");
        step(FrameStep::read_back, [&] {
            reader_.read(film_, film, settings, image, statistics);
            if (settings.aovs.any())
                aovs_.read(film, image);
        });
        finish_steps(statistics);
        statistics.peak_device_bytes = backend_.memory().peak();
        return statistics;
    }

    /// Gives the device what belongs to a step; finish_steps() waits.
    template <class Work> void step(FrameStep step, const Work& work) {
        if (watch_)
            watch_->begin(step);
        clock_.step(step, work);
        if (Backend::is_immediate)
            end_if_cancelled();
    }
    void finish_steps(FrameStatistics& statistics) {
        backend_.synchronize();
        clock_.settle([&](FrameStep step, StepWatch::Time begin, StepWatch::Time end) {
            milliseconds_of(statistics, step) += std::chrono::duration<double, std::milli>(end - begin).count();
            if (watch_)
                watch_->end(step, begin, end);
        });
        end_if_cancelled();
    }
    static double& milliseconds_of(FrameStatistics& statistics, FrameStep step) {
        return step == FrameStep::motion  ? statistics.motion_ms
               : step == FrameStep::build ? statistics.build_ms
               : step == FrameStep::map   ? statistics.cloud_ms
               : step == FrameStep::relay ? statistics.relay_ms
               : step == FrameStep::trace ? statistics.trace_ms
                                          : statistics.readback_ms;
    }
    void end_if_cancelled() {
        if (backend_.is_cancelled())
            throw FrameCancelled();
    }

    /// Everything that follows from the time, to where it is then.
    void move(const MotionTime& time) {
        if (!scene_.moves() || moved_to_ == time)
            return;
        built_for_.reset();
        moved_to_ = time;
        step(FrameStep::motion, [&] {
            if (!scene_.move(time))
                throw MotionUndefined("a number of the scene");
        });
    }

    /// One moment of the scene, in linear light. The device builds and traces without being waited for; should the
    /// grid have been given too little room, which is told at the end, it does so once more.
    void expose(const FrameSettings& settings, const FilmView& film, FrameStatistics& statistics) {
        const FrameSettings whole = settings.with_rows({});
        bool is_new = settings.rows.count == 0 || built_for_ != whole;
        const double before = method_ms(statistics);
        FramePipeline& builder = builder_ ? *builder_ : *this;
        if (is_new)
            builder.chosen_.reset();
        built_for_.reset();
        do {
            if (is_new && builder_)
                take_over(whole, statistics);
            else if (is_new)
                build(whole);
            step(FrameStep::trace, [&] {
                tracer_.trace(built_, scene_.needs(), film, settings.antialiasing);
                backend_.for_each(uint32_t(film.pixels.size()), ResolvePixels{film, scene_.curve(), scene_.gamma()});
            });
            finish_steps(statistics);
            is_new = !builder_ && is_incomplete();
            statistics.camera_rays += is_new ? 0 : tracer_.camera_rays();
        } while (is_new);
        built_for_ = whole;
        (builder_ ? builder_->grid_ : grid_).report(built_.grid, statistics);
        statistics.method = built_.grid.cloud.in_use() ? "cloud" : built_.grid.in_use() ? "grid" : "brute";
        builder.note_choice(settings, method_ms(statistics) - before, statistics);
    }

    /// What depends on the method.
    static double method_ms(const FrameStatistics& s) { return s.build_ms + s.cloud_ms + s.relay_ms + s.trace_ms; }

    /// Tells the choice what its frame took, unless that is not like others: a band, or one that looked.
    void note_choice(const FrameSettings& settings, double milliseconds, FrameStatistics& statistics) {
        const bool is_free = settings.accelerator == Accelerator::automatic;
        statistics.choice = chosen_ ? chosen_->record : MethodRecord{is_free ? MethodReason::few : MethodReason::asked};
        if (!chosen_ || chosen_->epoch == 0 || settings.rows.count != 0)
            return;
        uint64_t& warm = warm_[chosen_->method];
        choice_->end(*chosen_, milliseconds, warm == chosen_->epoch && !chosen_->looks);
        warm = chosen_->epoch;
    }

    /// After finish_steps(): whether the grid was given too little room.
    bool is_incomplete() { return built_.grid.in_use() && !grid_.is_complete(); }

    /// The scene's grid, and its cloud if it is to have one.
    void build(const FrameSettings& settings) {
        begin_scene(settings);
        step(FrameStep::build, [&] {
            grid_.find_bounds(built_.geometry);
            if (uses_grid(settings, built_)) {
                if (settings.grid[0] == 0) // a size that is asked for is of all bounds
                    grid_.find_core(built_.geometry, settings.aovs.steps);
                build_grid(settings, built_);
            }
        });
        if (built_.grid.cloud.in_use())
            step(FrameStep::map, [&] { grid_.build_distances(built_); });
    }

    void begin_scene(const FrameSettings& settings) {
        built_ = scene_.view();
        if (settings.tolerances == Tolerances::povray)
            built_.limits = HitLimits<Real>::povray();
    }

    /// The same, with the grid that the builder makes.
    void take_over(const FrameSettings& settings, FrameStatistics& statistics) {
        try {
            builder_->backend_.activate();
            builder_->build_for_other(moved_to_, settings, watch_ ? watch_->builder() : nullptr, statistics);
        } catch (const DeviceError& error) {
            throw BuilderFailed(error.what());
        }
        backend_.activate();
        begin_scene(settings);
        step(FrameStep::relay, [&] { copy_.take(built_, builder_->built_, builder_->backend_); });
    }
    void build_for_other(const std::optional<MotionTime>& time, const FrameSettings& settings, StepWatch* watch,
                         FrameStatistics& statistics) {
        watch_ = watch;
        clock_.clear();
        if (time)
            move(*time);
        do {
            build(settings);
            finish_steps(statistics);
        } while (is_incomplete());
    }

    FilmView make_film(const FrameSettings& settings) {
        const Rows band = settings.band();
        if (uint64_t(settings.width) * band.count > most_pixels)
            throw DeviceError(DeviceError::Kind::out_of_memory, "at most 2^32 / 3 pixels can be rendered at a time");
        film_.resize(size_t(settings.width) * band.count);
        FilmView film{film_.view(), settings.width, band.count, settings.samples};
        film.first_row = band.first;
        film.picture_width = settings.width;
        film.picture_height = settings.height;
        if (settings.antialiasing.method == Antialiasing::Method::grid) {
            film.pattern = SamplePattern::center_and_grid;
            film.grid_side = settings.antialiasing.depth;
            film.samples = film.grid_side * film.grid_side + 1;
        }
        return film;
    }

    /// What grows with the picture.
    void free_film() {
        built_for_.reset();
        film_.free();
        sum_.free();
        tracer_.free();
        aovs_.free();
        reader_.free();
    }

    /// A handful of primitives is tested faster than a grid is walked.
    static bool uses_grid(const FrameSettings& settings, const SceneView<Real>& scene) {
        constexpr uint32_t few = 8;
        return settings.accelerator == Accelerator::grid || settings.accelerator == Accelerator::cloud ||
               (settings.accelerator == Accelerator::automatic && scene.geometry.round_count() > few);
    }

    /// A grid, or a cloud over a finer one: as asked for or as chosen. A size that is asked for is a grid's unless a
    /// cloud is, too. The cloud's distances are measured later.
    void build_grid(const FrameSettings& settings, SceneView<Real>& scene) {
        const GridPlan cloud{.size = settings.grid,
                             .voxels_per_primitive = 32,
                             .brick = settings.brick ? settings.brick : 4,
                             .metric = settings.metric};
        if (!chosen_)
            chosen_ = choose(settings, scene);
        grid_.build(scene, chosen_->method == SearchMethod::cloud ? cloud : GridPlan{.size = settings.grid});
    }

    MethodChoice::Frame choose(const FrameSettings& settings, const SceneView<Real>& scene) {
        MethodChoice::Frame frame;
        if (settings.accelerator != Accelerator::automatic || settings.grid[0] != 0) {
            frame.method = settings.accelerator == Accelerator::cloud ? SearchMethod::cloud : SearchMethod::grid;
            return frame;
        }
        if (!settings.aovs.steps)
            frame = choice_->begin(settings, scene.geometry.round_count());
        if (!settings.aovs.steps && !frame.looks)
            return frame;
        const EmptySpace space = grid_.look(scene, {.voxels_per_primitive = 32, .brick = 4});
        if (settings.aovs.steps) // then the choice is seen in the file
            choice_->decide_alone(frame, settings, space);
        else
            choice_->see(frame, space);
        return frame;
    }

    Backend& backend_;
    DeviceScene<Backend, Real> scene_;
    GridBuilder<Backend, Real> grid_;
    FilmTracer<Backend, Real> tracer_;
    AovTracer<Backend, Real> aovs_;
    FilmReader<Backend> reader_;
    Buffer<glm::vec3> film_;
    Buffer<glm::vec3> sum_; ///< of exposures
    std::shared_ptr<MethodChoice> choice_;
    std::optional<MethodChoice::Frame> chosen_; ///< of the frame
    OfMethods<uint64_t> warm_;                  ///< epochs of the choice in which frames were made by each method
    StepWatch* watch_ = nullptr;
    StepClock<Backend> clock_;
    FramePipeline* builder_ = nullptr;
    GridCopy<Backend> copy_;                 ///< of its grid
    std::optional<MotionTime> moved_to_;     ///< none: the time of the script's evaluation
    SceneView<Real> built_;                  ///< the scene at that time, with its grid
    std::optional<FrameSettings> built_for_; ///< of all rows
};

} // namespace proxima
