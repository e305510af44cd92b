// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene_source.h"
#include "renderer/errors.h"
#include "renderer/timing.h"

#include <algorithm>
#include <fmt/format.h>

namespace proxima {

SceneSource::SceneSource(const SceneOptions& options, std::function<void(std::string_view)> debug)
    : options_(options), debug_(std::move(debug)) {
    timed(parse_ms_, [&] { script_.emplace(options.scene, options.include_paths, diagnostics_); });
    reject_mistakes(diagnostics_);
}

bool SceneSource::load(int64_t frame) {
    if (same_for_all_frames_ || loaded_frame_ == frame)
        return false;
    const EvaluationSettings settings{.time = options_.animation.clock(frame),
                                      .image_width = options_.width,
                                      .image_height = options_.height,
                                      .declares = options_.declares,
                                      .budget = options_.budget,
                                      .last_evaluation = options_.animation.frames.size() == 1,
                                      .debug = debug_};
    Diagnostics later; // what a later frame repeats is not said again
    Diagnostics& diagnostics = loaded_frame_ ? later : diagnostics_;
    program_.reset(); // a new scene has the memory of the old one, unless that is still in use
    timed(evaluate_ms_,
          [&] { program_ = std::make_shared<const SceneProgram>(script_->evaluate(settings, diagnostics)); });
    reject_mistakes(diagnostics);
    loaded_frame_ = frame;
    hash_.reset();
    moving_camera_.reset();
    same_for_all_frames_ = !program_->depends_on_time;
    return true;
}

SceneFacts SceneSource::facts(int64_t frame) {
    if (!hash_) {
        hash_ = hash_scene(*program_);
        if (std::ranges::any_of(program_->motion.fields,
                                [](const MotionField& field) { return field.table == MotionField::Table::camera; }))
            moving_camera_ = *program_;
        camera_ = program_->camera; // the program may be released before the next frame
        camera_motion_ = field_programs(program_->motion);
    }
    SceneFacts facts{*hash_, options_.animation.clock(frame), camera_};
    if (moving_camera_) {
        move_fields(*moving_camera_, camera_motion_,
                    {facts.time.clock, facts.time.frame_number, facts.time.clock_delta});
        facts.camera = moving_camera_->camera;
    }
    return facts;
}

std::string SceneSource::messages(bool notes) const {
    Diagnostics shown;
    for (const Diagnostic& diagnostic : diagnostics_.all())
        if (notes || diagnostic.severity != Severity::note)
            shown.report(diagnostic);
    return shown.format(script_->files());
}

void SceneSource::reject_mistakes(const Diagnostics& diagnostics) const {
    if (!diagnostics.has_errors())
        return;
    const size_t count = diagnostics.error_count();
    const std::string what = count == 1 ? "1 mistake; it is shown" : fmt::format("{} mistakes; they are shown", count);
    throw SceneRejected(fmt::format("{}: the scene has {} above", options_.scene.string(), what),
                        diagnostics.format(script_->files()));
}

} // namespace proxima
