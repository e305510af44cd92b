// SPDX-License-Identifier: Apache-2.0
// The one queue of a run's frames: evaluated scenes come in on one side, devices take frames on the other, and what a
// device could not finish comes back.
#pragma once
#include "renderer/frame_assembly.h"
#include "renderer/frame_scenes.h"
#include "renderer/scene_facts.h"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace proxima {

/// A frame to render, or a band of one.
struct FrameTask {
    size_t index = 0; ///< in the order in which frames were asked for
    int64_t frame = 0;
    /// What the picture shows: the mean of several scenes, or one at several moments. A null scene is that of the frame
    /// before (see FrameSource).
    FrameScenes scenes;
    SceneFacts facts{};
    Rows rows{};                               ///< the queue's: what of it is meant
    std::shared_ptr<FrameAssembly> assembly{}; ///< the queue's: shared by all bands of the frame
};

/// Any member may be called by any thread.
class FrameQueue {
public:
    /// `total` frames will come; `workers` devices (or parts of one) take them and are numbered from 0. Each frame is
    /// handed out in `bands`. Worker w is on device w % `devices`: those of one device take bands of different frames
    /// as long as there are any, since each builds the grid of a frame that it takes bands of.
    FrameQueue(size_t total, size_t workers, std::vector<Rows> bands = {Rows{}}, size_t devices = 0);

    /// Adds a frame, band by band; waits while those of `capacity` others wait. False when the queue was closed: no
    /// more are wanted.
    bool push(FrameTask task);
    /// No more frames will come; with `error` because evaluating one failed. What is queued is still handed out.
    void end(std::exception_ptr error = {});

    /// A frame for `worker`, who then has it in flight. Waits for one to come, or to come back from another worker.
    /// None when all frames are finished or the queue was closed. A worker gets what it finishes: one that is so slow
    /// that the others would finish everything that is left before it had finished one gets none.
    std::optional<FrameTask> take(size_t worker);
    /// `worker` finished the frame that it had in flight, which took it this long.
    void finish(size_t worker, double milliseconds);
    /// A worker could not finish it: another one will get it, before all others.
    void give_back(FrameTask task);
    /// `worker` takes no more.
    void leave(size_t worker);

    /// Hands out nothing more: the run is over.
    void close();

    size_t workers_left() const;
    /// Frames wait that nobody will take.
    bool has_unfinished() const;
    std::exception_ptr error() const;

    static constexpr size_t capacity = 2;

private:
    static constexpr uint64_t warm_up = 1; ///< frames

    struct Worker {
        bool left = false;
        uint64_t finished = 0;
        double milliseconds = 0; ///< a frame, a mean that forgets; the first frames also start the device

        bool is_known() const { return finished > warm_up; }
    };

    FrameTask next_for(size_t worker, std::deque<FrameTask>& queue) const;
    bool is_worthwhile(size_t worker) const;
    bool is_over() const;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    const std::vector<Rows> bands_;
    const size_t devices_;
    std::deque<FrameTask> waiting_, returned_;
    std::vector<Worker> workers_;
    std::exception_ptr error_;
    size_t not_taken_; ///< bands, returned ones excepted
    size_t in_flight_ = 0;
    bool ended_ = false, closed_ = false;
};

} // namespace proxima
