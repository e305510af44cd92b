// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_scheduler.h"
#include "renderer/grid_resolution.h"
#include "renderer/host_memory.h"
#include "renderer/image_mean.h"
#include "renderer/timing.h"

#include <chrono>
#include <fmt/format.h>
#include <new>

namespace proxima {
namespace {

/// The scene that a renderer holds, known by its owner: the program itself may be gone from the host.
bool is_same(const std::weak_ptr<const SceneProgram>& held, const std::shared_ptr<const SceneProgram>& scene) {
    return !held.owner_before(scene) && !scene.owner_before(held);
}

/// What ends the run although no device is to blame.
struct WritingFailed {
    std::exception_ptr error;
};

/// A renderer that tells `watch` what it does, for as long as this lives.
class WatchedRenderer {
public:
    WatchedRenderer(FrameRenderer& renderer, StepWatch* watch) : renderer_(renderer) { renderer_.set_watch(watch); }
    ~WatchedRenderer() { renderer_.set_watch(nullptr); }
    WatchedRenderer(const WatchedRenderer&) = delete;
    WatchedRenderer& operator=(const WatchedRenderer&) = delete;

private:
    FrameRenderer& renderer_;
};

/// Says that a grid is coarser than it was to be, and why.
std::string coarser_grid(const FrameStatistics& statistics) {
    return fmt::format("the grid has {} voxels instead of {}: {}; frames may take longer",
                       fmt::join(statistics.grid, "x"), fmt::join(statistics.wanted_grid, "x"),
                       statistics.most_voxels < GridRule{}.most_voxels
                           ? fmt::format("the memory that is free holds lists of about {}", statistics.most_voxels)
                           : "there are at most 2^31");
}

} // namespace

FrameScheduler::FrameScheduler(FrameQueue& queue, FrameWriter& writer, Config config)
    : queue_(queue), writer_(writer), config_(std::move(config)) {}

FrameScheduler::~FrameScheduler() {
    queue_.close();
    join();
}

void FrameScheduler::run(std::vector<RenderWorker> workers, const StopSignal& stop) {
    workers_ = std::move(workers);
    running_ = workers_.size();
    for (size_t i = 0; i < workers_.size(); ++i)
        threads_.emplace_back([this, i] { work(i, workers_[i]); });
    {
        std::unique_lock lock(mutex_);
        std::optional<Stopwatch> since_stop;
        while (!changed_.wait_for(lock, std::chrono::milliseconds(20), [this] { return running_ == 0; })) {
            if (!stop.caught())
                continue;
            queue_.close();
            if (!since_stop)
                since_stop.emplace();
            else if (since_stop->milliseconds() > double(config_.patience.count()))
                cancel_frames();
        }
    }
    join();
    const bool unfinished = queue_.has_unfinished();
    queue_.close(); // whoever still adds frames waits for nobody
    if (fatal_)
        std::rethrow_exception(fatal_);
    if (unfinished && device_error_ && !stop.caught())
        std::rethrow_exception(device_error_);
    if (queue_.error())
        std::rethrow_exception(queue_.error());
}

void FrameScheduler::join() {
    for (std::thread& thread : threads_)
        thread.join();
    threads_.clear();
}

/// With mutex_ held.
void FrameScheduler::cancel_frames() {
    for (RenderWorker& worker : workers_)
        if (worker.renderer)
            worker.renderer->cancel();
}

void FrameScheduler::work(size_t number, RenderWorker& worker) {
    std::optional<FrameTask> task;
    try {
        std::weak_ptr<const SceneProgram> held;
        if (!worker.renderer) {
            std::unique_ptr<FrameRenderer> renderer = worker.make();
            const std::lock_guard lock(mutex_);
            worker.renderer = std::move(renderer);
        }
        while ((task = queue_.take(number))) {
            render(number, worker, *task, held);
            task.reset();
        }
    } catch (const FrameCancelled&) {
        queue_.close();
    } catch (const WritingFailed& failure) {
        const std::lock_guard lock(mutex_);
        fatal_ = failure.error;
    } catch (const DeviceError& error) {
        report(worker, task, error);
    } catch (const std::bad_alloc&) {
        report(worker, task, {DeviceError::Kind::out_of_memory, "out of memory"});
    } catch (...) {
        const std::lock_guard lock(mutex_);
        fatal_ = std::current_exception();
    }
    if (task)
        queue_.give_back(std::move(*task));
    queue_.leave(number);
    const std::lock_guard lock(mutex_);
    worker.left = true;
    worker.renderer.reset(); // another frame in flight may need its memory
    if (fatal_)
        queue_.close();
    --running_;
    changed_.notify_all();
}

void FrameScheduler::report(const RenderWorker& worker, const std::optional<FrameTask>& task,
                            const DeviceError& error) {
    const std::lock_guard lock(mutex_);
    device_error_ = std::make_exception_ptr(error);
    if (error.kind == DeviceError::Kind::scene)
        fatal_ = device_error_;
    else if (queue_.workers_left() > 1)
        config_.note(
            task ? fmt::format("{}: {}; frame {} goes to another device", worker.device, error.what(), task->frame)
                 : fmt::format("{}: {}; the others go on", worker.device, error.what()));
}

void FrameScheduler::render(size_t number, RenderWorker& worker, FrameTask& task, HeldScene& held) {
    FrameWatch builder_watch(config_.watch, worker.builder, task.frame);
    FrameWatch watch(config_.watch, worker.device, task.frame, worker.builder.empty() ? nullptr : &builder_watch);
    const WatchedRenderer watched(*worker.renderer, &watch);
    const Stopwatch stopwatch;
    Image& image = task.assembly->image(writer_, config_.settings, *worker.renderer);
    FrameStatistics statistics;
    for (bool smaller = false;;) {
        try {
            statistics = render_scenes(worker, task, held, image);
            if (smaller)
                config_.note(
                    fmt::format("{}: out of memory; goes on in tiles of {} rows", worker.device, worker.most_rows));
            break;
        } catch (const DeviceError& error) {
            if (error.kind != DeviceError::Kind::out_of_memory || !render_smaller(worker, task))
                throw;
            smaller = true;
        } catch (const MotionUndefined&) {
            const FloatFit fit = task.scenes.fit; // decides the precision, which is in the frame's hash
            task.scenes = config_.scenes_by_script(task.frame);
            task.scenes.fit = fit;
        }
    }
    if (!statistics.note.empty())
        config_.note(fmt::format("{}: {}", worker.device, statistics.note));
    if (statistics.wanted_grid[0] > 0 && !said_coarser_.exchange(true))
        config_.note(fmt::format("{}: {}", worker.device, coarser_grid(statistics)));
    const double milliseconds = stopwatch.milliseconds(); // waiting for the writer says nothing about the device
    if (task.assembly->add(worker.device, statistics)) {
        FrameRecord record = config_.describe(task);
        record.host_bytes = host_bytes();
        hand_over(task.assembly->release(std::move(record), task.index));
    }
    queue_.finish(number, milliseconds);
}

void FrameScheduler::hand_over(FinishedFrame frame) {
    try {
        writer_.push(std::move(frame));
    } catch (...) { // another device would not help
        throw WritingFailed{std::current_exception()};
    }
}

/// The mean of the task's scenes.
FrameStatistics FrameScheduler::render_scenes(RenderWorker& worker, FrameTask& task, HeldScene& held, Image& image) {
    const auto& programs = task.scenes.programs;
    FrameStatistics statistics;
    ImageMean mean;
    const Precision precision = chosen_precision(config_.settings.precision, task.scenes.fit.holds());
    for (size_t i = 0; i < programs.size(); ++i) {
        if (programs[i] && !is_same(held, programs[i])) {
            worker.renderer->set_scene(*programs[i], precision);
            held = programs[i];
        }
        FrameSettings settings = config_.settings;
        settings.precision = precision;
        if (i != programs.size() / 2) // the layers are those of the middle of the shutter
            settings.aovs = {};
        statistics.add(
            render_rows(worker, settings.with_rows(task.rows), task, programs.size() > 1 ? mean.next() : image));
        if (programs.size() > 1)
            mean.add(config_.settings.with_rows(task.rows).band());
    }
    if (programs.size() > 1)
        mean.store(image, config_.settings.with_rows(task.rows).band());
    return statistics;
}

/// The task's rows, as many at a time as the device has had memory for.
FrameStatistics FrameScheduler::render_rows(RenderWorker& worker, const FrameSettings& settings, FrameTask& task,
                                            Image& image) {
    if (worker.most_rows == 0)
        return worker.renderer->render(settings, task.scenes.moments, image);
    FrameStatistics statistics;
    for (const Rows& rows : cut_into_bands(settings.band(), worker.most_rows))
        statistics.add(worker.renderer->render(settings.with_rows(rows), task.scenes.moments, image));
    return statistics;
}

/// Whether the device, which was out of memory, shall try the task again with fewer rows at a time. Not if it has
/// another frame in flight: then there is memory for one.
bool FrameScheduler::render_smaller(RenderWorker& worker, const FrameTask& task) {
    const std::lock_guard lock(mutex_);
    for (const RenderWorker& other : workers_)
        if (&other != &worker && other.device == worker.device && !other.left)
            return worker.left = true, false;
    const uint32_t rows = worker.most_rows ? worker.most_rows : config_.settings.with_rows(task.rows).band().count;
    if (rows <= Rows::unit)
        return false;
    worker.most_rows = (rows / 4 + Rows::unit - 1) / Rows::unit * Rows::unit;
    return true;
}

} // namespace proxima
