// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene_source.h"
#include "renderer/errors.h"
#include "renderer/timing.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace proxima {
namespace {

/// Whether the motion programs of a scene say what the moments show, as far as that is known without the spheres.
bool says(const SceneProgram& program, const std::vector<SceneClock>& moments) {
    return std::ranges::all_of(
        moments, [&](const SceneClock& moment) { return is_defined(program.motion, motion_time(moment)); });
}

bool camera_moves(const SceneProgram& program) {
    return std::ranges::any_of(program.motion.fields,
                               [](const MotionField& field) { return field.table == MotionField::Table::camera; });
}

} // namespace

SceneSource::SceneSource(const SceneOptions& options, std::function<void(std::string_view)> debug)
    : options_(options), debug_(std::move(debug)) {
    timed(parse_ms_, [&] { script_.emplace(options.scene, options.include_paths, diagnostics_); });
    reject_mistakes(diagnostics_);
}

FrameScenes SceneSource::scenes(int64_t frame) {
    const bool released = shown_.programs.empty() || !shown_.programs.front();
    if (same_for_all_frames_ || (shown_frame_ == frame && !released))
        return shown_;
    const Moments moments = options_.animation.moments(frame);
    const Program before = shown_.programs.empty() ? nullptr : shown_.programs.front();
    if (const Program program = moving_program(moments)) {
        const FloatFit fit = program == before ? shown_.fit : fit_of_all_frames(*program);
        shown_ = {{program}, {}, fit};
        if (!same_for_all_frames_)
            for (const SceneClock& moment : moments)
                shown_.moments.push_back(motion_time(moment));
    } else {
        shown_ = {}; // a new scene has the memory of the old one, unless that is still in use
        shown_ = by_script(moments);
        same_for_all_frames_ = !this->program().depends_on_time;
    }
    if (shown_.programs.front() != before) {
        hash_.reset();
        moving_camera_.reset();
    }
    shown_frame_ = frame;
    return shown_;
}

FrameScenes SceneSource::scenes_by_script(int64_t frame) {
    return by_script(options_.animation.moments(frame));
}

FrameScenes SceneSource::by_script(const Moments& moments) {
    const Animation& animation = options_.animation;
    FrameScenes result;
    for (const SceneClock& moment : moments) {
        EvaluationSettings settings = settings_at(moment);
        settings.last_evaluation = animation.frames.size() == 1 && moments.size() == 1;
        result.programs.push_back(evaluate(std::move(settings)));
        result.fit = worse(result.fit, proxima::float_fit(*result.programs.back(), options_.width));
        if (!result.programs.front()->depends_on_time)
            break; // the other moments are the same
    }
    return result;
}

/// At the beginning, in the middle and at the end of the animation, whichever of its frames are rendered.
FloatFit SceneSource::fit_of_all_frames(const SceneProgram& program) const {
    const Animation& animation = options_.animation;
    std::vector<MotionTime> moments;
    for (const int64_t frame :
         {animation.initial_frame, animation.initial_frame / 2 + animation.final_frame / 2, animation.final_frame})
        moments.push_back(motion_time(animation.clock(frame)));
    return proxima::float_fit(program, options_.width, moments);
}

/// The program that says the moments of a frame, or null; or one that says all frames, as it is.
SceneSource::Program SceneSource::moving_program(const Moments& moments) {
    const Animation& animation = options_.animation;
    if (animation.is_still && !records_stills_)
        return nullptr;
    const int64_t ends[] = {animation.initial_frame, animation.final_frame};
    for (size_t i = 0; i < candidates_.size() && !obstacle_ && !same_for_all_frames_; ++i) {
        Candidate& candidate = candidates_[i];
        if (!candidate.tried && (i == 0 || ends[0] != ends[1]))
            candidate.program = record(ends[i]);
        candidate.tried = true;
        if (candidate.program && (same_for_all_frames_ || says(*candidate.program, moments)))
            return candidate.program;
    }
    return nullptr;
}

/// An evaluation at a frame that may not even be rendered: its mistakes are not the user's, if there are some.
SceneSource::Program SceneSource::record(int64_t frame) {
    EvaluationSettings settings = settings_at(options_.animation.clock(frame));
    settings.record_motion = settings.needs_motion = true;
    try {
        const Program program = evaluate(std::move(settings));
        obstacle_ = program->obstacle;
        same_for_all_frames_ = !program->depends_on_time;
        return !obstacle_ && (same_for_all_frames_ || !program->motion.empty()) ? program : nullptr;
    } catch (const MotionImpossible& impossible) {
        obstacle_ = impossible.obstacle;
    } catch (const SceneRejected&) {
    }
    return nullptr;
}

SceneFacts SceneSource::facts(int64_t frame) {
    const std::vector<Program>& programs = shown_.programs;
    if (!hash_) {
        std::string text;
        for (const Program& program : programs)
            text += hash_scene(*program).text();
        hash_ = programs.size() == 1 ? hash_scene(*programs.front()) : hash_text(text);
        if (camera_moves(program()))
            moving_camera_ = program();
        camera_ = program().camera;
    }
    SceneFacts facts{*hash_, options_.animation.clock(frame), camera_, shown_.fit.holds()};
    if (moving_camera_) {
        move_fields(*moving_camera_, program().motion, motion_time(facts.time));
        facts.camera = moving_camera_->camera;
    }
    return facts;
}

bool SceneSource::load(int64_t frame) {
    if (same_for_all_frames_ || shown_frame_ == frame)
        return false;
    shown_ = {};
    shown_ = by_script({options_.animation.clock(frame)});
    shown_frame_ = frame;
    hash_.reset();
    moving_camera_.reset();
    same_for_all_frames_ = !program().depends_on_time;
    return true;
}

void SceneSource::release_program() {
    if (shown_.programs.empty() || !shown_.programs.front() || !shown_.programs.front()->motion.empty())
        return;
    for (Candidate& candidate : candidates_)
        candidate.program.reset();
    shown_.programs = {nullptr};
}

EvaluationSettings SceneSource::settings_at(const SceneClock& time) const {
    return {.time = time,
            .image_width = options_.width,
            .image_height = options_.height,
            .declares = options_.declares,
            .budget = options_.budget,
            .debug = debug_};
}

SceneSource::Program SceneSource::evaluate(EvaluationSettings settings) {
    const std::lock_guard lock(mutex_);
    Diagnostics found; // what a later frame repeats is not said again
    Program program;
    timed(evaluate_ms_, [&] {
        auto scene = std::make_shared<SceneProgram>(script_->evaluate(settings, found));
        apply(options_.overrides, *scene);
        program = std::move(scene);
    });
    reject_mistakes(found);
    if (!std::exchange(evaluated_, true))
        for (const Diagnostic& diagnostic : found.all())
            diagnostics_.report(diagnostic);
    return program;
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
