// SPDX-License-Identifier: Apache-2.0
// A FrameRenderer for any backend: holds one scene in the precision that was asked for.
#pragma once
#include "renderer/frame_pipeline.h"

#include <memory>
#include <stdexcept>

namespace proxima {

template <class Backend> class PipelineRenderer : public FrameRenderer {
public:
    /// `choice`: the device's; null for one of its own.
    explicit PipelineRenderer(std::shared_ptr<MethodChoice> choice, auto... arguments)
        : backend_(arguments...),
          choice_(choice ? std::move(choice) : std::make_shared<MethodChoice>(Backend::method_costs)) {}

    std::string name() const override { return backend_.name(); }

    void set_scene(const SceneProgram& scene, Precision precision) override {
        try {
            if (builder_)
                builder_->set_scene(scene, precision);
        } catch (const DeviceError& error) {
            drop_builder(error);
        }
        backend_.activate();
        if (precision == Precision::float64) {
            single_.reset();
            take(double_, scene);
        } else {
            double_.reset();
            take(single_, scene);
        }
        connect_builder();
    }

    using FrameRenderer::render;
    FrameStatistics render(const FrameSettings& settings, std::span<const MotionTime> times, Image& image) override {
        if (settings.precision == Precision::float64 ? !double_ : !single_)
            throw std::logic_error("render: the scene was not set in this precision");
        FrameStatistics statistics;
        try {
            statistics = render_here(settings, times, image);
        } catch (const BuilderFailed& error) {
            drop_builder(error);
            statistics = render_here(settings, times, image);
        }
        statistics.note = std::exchange(note_, {});
        return statistics;
    }

    void lock_pages(Image& image) override {
        backend_.activate();
        if (!image.lock)
            image.lock = backend_.lock_pages(image.samples(), image.bytes());
    }
    void set_watch(StepWatch* watch) override { watch_ = watch; }
    void cancel() override { backend_.cancel(); }

    void relay_from(std::unique_ptr<FrameRenderer> builder) override {
        auto* same_kind = dynamic_cast<PipelineRenderer*>(builder.get());
        if (!same_kind)
            throw std::logic_error("relay_from: devices of different kinds");
        builder.release();
        builder_.reset(same_kind);
    }

private:
    FrameStatistics render_here(const FrameSettings& settings, std::span<const MotionTime> times, Image& image) {
        backend_.activate();
        return double_ ? double_->render(settings, times, watch_, image)
                       : single_->render(settings, times, watch_, image);
    }

    template <class Pipeline> void take(std::unique_ptr<Pipeline>& pipeline, const SceneProgram& scene) {
        if (!pipeline)
            pipeline = std::make_unique<Pipeline>(backend_, choice_);
        pipeline->set_scene(scene);
    }

    void connect_builder() {
        if (single_)
            single_->relay_from(builder_ ? builder_->single_.get() : nullptr);
        if (double_)
            double_->relay_from(builder_ ? builder_->double_.get() : nullptr);
    }
    void drop_builder(const std::exception& error) {
        note_ = builder_->name() + " builds no more grids for this device: " + error.what();
        builder_.reset();
        connect_builder();
    }

    Backend backend_;
    std::shared_ptr<MethodChoice> choice_;
    StepWatch* watch_ = nullptr;
    std::unique_ptr<FramePipeline<Backend, float>> single_;
    std::unique_ptr<FramePipeline<Backend, double>> double_;
    std::unique_ptr<PipelineRenderer> builder_; ///< see relay_from
    std::string note_;
};

} // namespace proxima
