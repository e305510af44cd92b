// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_source.h"

namespace proxima {

FrameSource::FrameSource(SceneSource& scene, const Animation& animation, FrameQueue& queue, bool keep)
    : queue_(queue), thread_([this, &scene, &animation, keep] { run(scene, animation, keep); }) {}

FrameSource::~FrameSource() {
    queue_.close();
    join();
}

void FrameSource::join() {
    if (thread_.joinable())
        thread_.join();
}

void FrameSource::run(SceneSource& scene, const Animation& animation, bool keep) {
    try {
        for (size_t index = 0; index < animation.frames.size(); ++index) {
            const int64_t frame = animation.frames[index];
            FrameTask task{index, frame, scene.scenes(frame), scene.facts(frame)};
            if (!keep)
                scene.release_program();
            if (!queue_.push(std::move(task)))
                return;
        }
        queue_.end();
    } catch (...) { // told to whoever waits for the run
        queue_.end(std::current_exception());
    }
}

} // namespace proxima
