// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_scheduler.h"
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
        while (!changed_.wait_for(lock, std::chrono::milliseconds(20), [this] { return running_ == 0; }))
            if (stop.caught())
                queue_.close();
    }
    join();
    if (fatal_)
        std::rethrow_exception(fatal_);
    if (queue_.has_unfinished() && device_error_ && !stop.caught())
        std::rethrow_exception(device_error_);
    if (queue_.error())
        std::rethrow_exception(queue_.error());
}

void FrameScheduler::join() {
    for (std::thread& thread : threads_)
        thread.join();
    threads_.clear();
}

void FrameScheduler::work(size_t number, RenderWorker& worker) {
    std::optional<FrameTask> task;
    try {
        std::weak_ptr<const SceneProgram> held;
        if (!worker.renderer)
            worker.renderer = worker.make();
        while ((task = queue_.take(number))) {
            render(number, worker, *task, held);
            task.reset();
        }
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

void FrameScheduler::render(size_t number, RenderWorker& worker, FrameTask& task,
                            std::weak_ptr<const SceneProgram>& held) {
    const Stopwatch watch;
    if (task.scene && !is_same(held, task.scene)) {
        worker.renderer->set_scene(*task.scene, config_.settings.precision);
        held = task.scene;
    }
    FinishedFrame finished{writer_.take_image(), config_.describe(task), task.index};
    finished.record.device = worker.device;
    finished.record.statistics = worker.renderer->render(config_.settings, finished.image);
    const double milliseconds = watch.milliseconds(); // waiting for the writer says nothing about the device
    writer_.push(std::move(finished));
    queue_.finish(number, milliseconds);
}

} // namespace proxima
