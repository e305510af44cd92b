// SPDX-License-Identifier: Apache-2.0
// Evaluates the scene for the frames to come on a thread of its own, ahead of the devices: a scene and an animation
// come in, frames to render go into the queue.
#pragma once
#include "renderer/animation.h"
#include "renderer/frame_queue.h"
#include "renderer/scene_source.h"

#include <thread>

namespace proxima {

class FrameSource {
public:
    /// `scene` is used by this thread alone until the end, but for scenes_by_script. With `keep`, every task has its
    /// scene; without, only the first task of those that share one which does not move, and nobody but it keeps it: a
    /// single worker has a copy on its device, and the host's memory is better used for something else.
    FrameSource(SceneSource& scene, const Animation& animation, FrameQueue& queue, bool keep);
    /// Closes the queue and waits for the frame that is being evaluated.
    ~FrameSource();
    FrameSource(const FrameSource&) = delete;
    FrameSource& operator=(const FrameSource&) = delete;

    /// Waits until every frame is evaluated and handed over, or the queue is closed.
    void join();

private:
    void run(SceneSource& scene, const Animation& animation, bool keep);

    FrameQueue& queue_;
    std::thread thread_;
};

} // namespace proxima
