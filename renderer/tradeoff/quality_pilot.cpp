// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/quality_pilot.h"
#include "renderer/errors.h"
#include "renderer/image_mean.h"
#include "renderer/timing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proxima {

QualityPilot::QualityPilot(const SceneOptions& scene, const FrameSettings& frame, std::vector<int64_t> frames,
                           FrameRenderer& renderer, const StopSignal& stop)
    : scene_(scene), frame_(frame), asked_(quality_of(scene, frame)), whole_width_(frame.width),
      whole_height_(frame.height), frames_(std::move(frames)), renderer_(renderer), stop_(stop) {
    frame_.aovs = {};
    frame_.in_halves = false;
    take_scene(asked_);
    asked_.precision = chosen_precision(asked_.precision, source_->float_fit().holds());
    held_ = asked_;
}

void QualityPilot::resize(uint32_t longest) {
    const double scale = std::min(1.0, double(longest) / std::max(whole_width_, whole_height_));
    const auto scaled = [&](uint32_t side) { return std::max(1u, uint32_t(std::lround(side * scale))); };
    frame_.width = scaled(whole_width_);
    frame_.height = scaled(whole_height_);
}

const SceneProgram& QualityPilot::program() {
    take_scene(asked_);
    return source_->program();
}

std::vector<PilotPicture> QualityPilot::render(const QualitySetting& setting) {
    std::vector<PilotPicture> pictures;
    for (const int64_t frame : frames_)
        pictures.push_back(render(setting, frame));
    return pictures;
}

PilotPicture QualityPilot::render_first(const QualitySetting& setting) {
    return render(setting, frames_.front());
}

void QualityPilot::take_scene(const QualitySetting& setting) {
    if (held_ && shares_scene(*held_, setting))
        return;
    on_device_.reset();
    source_.reset(); // it refers to scene_
    FrameSettings unused;
    apply(setting, scene_, unused);
    source_ = std::make_unique<SceneSource>(scene_);
    held_ = setting;
    source_->scenes(frames_.front());
}

PilotPicture QualityPilot::render(const QualitySetting& setting, int64_t frame) {
    if (stop_.caught())
        throw Interrupted(stop_.caught());
    take_scene(setting);
    FrameSettings settings = frame_;
    SceneOptions unused;
    apply(setting, unused, settings);
    PilotPicture picture;
    FrameScenes scenes = source_->scenes(frame);
    double waiting = 0; // for a scene to reach the device: not a frame's time in an animation
    const auto set_scene = [&](const std::shared_ptr<const SceneProgram>& program) {
        if (program == on_device_)
            return;
        timed(waiting, [&] { renderer_.set_scene(*program, setting.precision); });
        on_device_ = program;
    };
    const auto render_all = [&] {
        FrameStatistics statistics;
        ImageMean mean;
        for (const auto& program : scenes.programs) {
            set_scene(program);
            const bool is_several = scenes.programs.size() > 1;
            statistics.add(renderer_.render(settings, scenes.moments, is_several ? mean.next() : picture.image));
            if (is_several)
                mean.add(settings.band());
        }
        if (scenes.programs.size() > 1)
            mean.store(picture.image, settings.band());
        return statistics;
    };
    const Stopwatch watch;
    FrameStatistics statistics;
    try {
        statistics = render_all();
    } catch (const MotionUndefined&) {
        scenes = source_->scenes_by_script(frame);
        statistics = render_all();
    }
    picture.ms = watch.milliseconds() - waiting;
    picture.build_ms = statistics.motion_ms + statistics.build_ms + statistics.cloud_ms;
    picture.camera_rays = statistics.camera_rays;
    return picture;
}

PictureError worst_error(const std::vector<PilotPicture>& pictures, const std::vector<PilotPicture>& reference) {
    PictureError worst = measure_error(pictures.front().image, reference.front().image);
    for (size_t i = 1; i < pictures.size(); ++i)
        worst.widen(measure_error(pictures[i].image, reference[i].image));
    return worst;
}

} // namespace proxima
