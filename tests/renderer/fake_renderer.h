// SPDX-License-Identifier: Apache-2.0
// A device for tests of scheduling: "renders" by sleeping and writing its frame's clock into the picture, and fails
// when it is told to.
#pragma once
#include "renderer/device_error.h"
#include "renderer/frame_renderer.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace proxima::testing {

class FakeRenderer : public FrameRenderer {
public:
    struct Behavior {
        double milliseconds = 0;
        /// Called with the number of the frame, from 0, that this device renders; may throw.
        std::function<void(int)> before_frame = [](int) {};
        std::atomic<int>* scenes_set = nullptr;
        uint32_t most_rows = 0; ///< that fit into its memory; 0: any number
        bool coarse = false;    ///< the grid that is wanted does not
    };
    explicit FakeRenderer(Behavior behavior) : behavior_(std::move(behavior)) {}

    std::string name() const override { return "fake"; }
    void set_scene(const SceneProgram& scene, Precision) override {
        if (behavior_.scenes_set)
            ++*behavior_.scenes_set;
        background_ = scene.background.x;
    }
    using FrameRenderer::render;
    FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime>, Image& image) override {
        behavior_.before_frame(rendered_++);
        std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(behavior_.milliseconds));
        const Rows band = settings.band();
        if (behavior_.most_rows > 0 && band.count > behavior_.most_rows)
            throw DeviceError(DeviceError::Kind::out_of_memory, "out of memory");
        image.fit(settings.width, settings.height);
        std::fill(image.row(band.first), image.row(band.first) + size_t(band.count) * settings.width * 3, background_);
        FrameStatistics statistics;
        statistics.trace_ms = 1;
        if (behavior_.coarse) {
            statistics.grid = {20, 10, 5};
            statistics.wanted_grid = {40, 20, 10};
            statistics.most_voxels = 1000;
        }
        return statistics;
    }

private:
    Behavior behavior_;
    int rendered_ = 0;
    float background_ = 0;
};

} // namespace proxima::testing
