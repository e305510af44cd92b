// SPDX-License-Identifier: Apache-2.0
// Renders the frames of a queue on many devices: a thread for each worker takes frames, renders them, and hands them to
// the writer. A device that fails leaves its frame to the others; one that is out of memory tries smaller bands first.
#pragma once
#include "renderer/device_error.h"
#include "renderer/frame_queue.h"
#include "renderer/frame_renderer.h"
#include "renderer/frame_watch.h"
#include "renderer/frame_writer.h"
#include "renderer/stop_signal.h"

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace proxima {

/// A frame at a time on a device. Two workers of one device have two frames in flight on it: one is built while the
/// other is traced.
struct RenderWorker {
    std::string device;                                   ///< its name in records
    std::unique_ptr<FrameRenderer> renderer;              ///< null: made by the worker, when its work begins
    std::function<std::unique_ptr<FrameRenderer>()> make; ///< needed when there is no renderer
    uint32_t most_rows = 0;                               ///< that its memory is enough for; 0: any number
    std::string builder{};                                ///< the device that builds for this one, when one does
    bool left = false;                                    ///< it takes no more frames
};

class FrameScheduler {
public:
    struct Config {
        FrameSettings settings;
        std::function<FrameRecord(const FrameTask&)> describe; ///< what is known of a frame before it is rendered
        std::function<void(const std::string&)> note;          ///< tells the user; any thread
        /// What a frame shows whose motion is undefined; any thread. May throw what ends the run.
        std::function<FrameScenes(int64_t)> scenes_by_script;
        RunWatch watch{};
        /// That frames in flight are given to finish after a signal; then they are dropped.
        std::chrono::milliseconds patience{1000};
    };

    FrameScheduler(FrameQueue& queue, FrameWriter& writer, Config config);
    /// Closes the queue and waits for the frames in flight.
    ~FrameScheduler();
    FrameScheduler(const FrameScheduler&) = delete;
    FrameScheduler& operator=(const FrameScheduler&) = delete;

    /// Renders until every frame is handed to the writer, or `stop` has caught a signal. The queue was made for as many
    /// workers. Throws what evaluating or writing a frame threw; DeviceError when a scene cannot be rendered, or when
    /// no device is left for a frame.
    void run(std::vector<RenderWorker> workers, const StopSignal& stop);

private:
    void work(size_t number, RenderWorker& worker);
    using HeldScene = std::weak_ptr<const SceneProgram>; ///< which a renderer has
    void render(size_t number, RenderWorker& worker, FrameTask& task, HeldScene& held);
    void hand_over(FinishedFrame frame);
    FrameStatistics render_scenes(RenderWorker& worker, FrameTask& task, HeldScene& held, Image& image);
    FrameStatistics render_rows(RenderWorker& worker, const FrameSettings& settings, FrameTask& task, Image& image);
    bool render_smaller(RenderWorker& worker, const FrameTask& task);
    void cancel_frames();
    void report(const RenderWorker& worker, const std::optional<FrameTask>& task, const DeviceError& error);
    void join();

    FrameQueue& queue_;
    FrameWriter& writer_;
    Config config_;
    std::vector<RenderWorker> workers_;
    std::mutex mutex_;
    std::condition_variable changed_;
    size_t running_ = 0;
    std::exception_ptr fatal_;               ///< ends the run
    std::exception_ptr device_error_;        ///< the last one
    std::atomic<bool> said_coarser_ = false; ///< that a grid is coarser than it was to be
    std::vector<std::thread> threads_;
};

} // namespace proxima
