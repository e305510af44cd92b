// SPDX-License-Identifier: Apache-2.0
// A FrameRenderer for any backend: holds one scene in the precision that was asked for.
#pragma once
#include "renderer/frame_pipeline.h"

#include <memory>
#include <stdexcept>

namespace proxima {

template <class Backend> class PipelineRenderer : public FrameRenderer {
public:
    explicit PipelineRenderer(auto... arguments) : backend_(arguments...) {}

    std::string name() const override { return backend_.name(); }

    void set_scene(const SceneProgram& scene, Precision precision) override {
        backend_.activate();
        if (precision == Precision::float64) {
            single_.reset();
            take(double_, scene);
        } else {
            double_.reset();
            take(single_, scene);
        }
    }

    using FrameRenderer::render;
    FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime> times, Image& image) override {
        if (settings.precision == Precision::float64 ? !double_ : !single_)
            throw std::logic_error("render: the scene was not set in this precision");
        backend_.activate();
        return double_ ? double_->render(settings, times, watch_, image)
                       : single_->render(settings, times, watch_, image);
    }

    void set_watch(StepWatch* watch) override { watch_ = watch; }
    void cancel() override { backend_.cancel(); }

private:
    template <class Pipeline> void take(std::unique_ptr<Pipeline>& pipeline, const SceneProgram& scene) {
        if (!pipeline)
            pipeline = std::make_unique<Pipeline>(backend_);
        pipeline->set_scene(scene);
    }

    Backend backend_;
    StepWatch* watch_ = nullptr;
    std::unique_ptr<FramePipeline<Backend, float>> single_;
    std::unique_ptr<FramePipeline<Backend, double>> double_;
};

} // namespace proxima
