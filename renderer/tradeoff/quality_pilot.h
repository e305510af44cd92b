// SPDX-License-Identifier: Apache-2.0
// A run's scene and frames in, small pictures of them at any quality out: what settings are compared by.
#pragma once
#include "renderer/scene_source.h"
#include "renderer/stop_signal.h"
#include "renderer/tradeoff/picture_error.h"
#include "renderer/tradeoff/quality_setting.h"

#include <memory>
#include <optional>
#include <vector>

namespace proxima {

/// A picture and what it took; milliseconds of wall-clock time.
struct PilotPicture {
    Image image;
    double ms = 0;
    double build_ms = 0; ///< the part of `ms` that does not grow with the picture
    uint64_t camera_rays = 0;
};

class QualityPilot {
public:
    /// Renders `frames` of the scene as if they were of its own size, but with fewer pixels. All must outlive this.
    /// Throws as SceneSource.
    QualityPilot(const SceneOptions& scene, const FrameSettings& frame, std::vector<int64_t> frames,
                 FrameRenderer& renderer, const StopSignal& stop);

    /// Of the pictures from now on: the longer side is at most `longest`, the shape stays.
    void resize(uint32_t longest);
    uint32_t width() const { return frame_.width; }
    uint32_t height() const { return frame_.height; }
    const std::vector<int64_t>& frames() const { return frames_; }
    const QualitySetting& asked() const { return asked_; }

    /// The scene of the first frame at the quality that was asked for.
    const SceneProgram& program();
    /// Warnings of the scene.
    std::string messages() const { return source_ ? source_->messages(false) : std::string(); }

    /// One picture a frame. Throws what rendering throws, and Interrupted.
    std::vector<PilotPicture> render(const QualitySetting& setting);
    /// The first frame only.
    PilotPicture render_first(const QualitySetting& setting);

private:
    PilotPicture render(const QualitySetting& setting, int64_t frame);
    void take_scene(const QualitySetting& setting);

    SceneOptions scene_; ///< as `held_` has it
    FrameSettings frame_;
    QualitySetting asked_;
    const uint32_t whole_width_, whole_height_;
    std::vector<int64_t> frames_;
    FrameRenderer& renderer_;
    const StopSignal& stop_;
    std::optional<QualitySetting> held_;  ///< whose scene was read
    std::unique_ptr<SceneSource> source_; ///< with `held_`
    std::shared_ptr<const SceneProgram> on_device_;
};

/// The same frames side by side: for each figure the worst of them.
PictureError worst_error(const std::vector<PilotPicture>& pictures, const std::vector<PilotPicture>& reference);

} // namespace proxima
