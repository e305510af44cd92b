// SPDX-License-Identifier: Apache-2.0
// The scene file of a command: read and parsed once, evaluated as often as its frames differ; once for all of them if
// what moves became motion programs.
#pragma once
#include "parser/scene_script.h"
#include "renderer/frame_scenes.h"
#include "renderer/options.h"
#include "renderer/scene_facts.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace proxima {

class SceneSource {
public:
    /// Reads and parses. Throws FileError and SceneRejected. `options` must outlive this.
    /// `debug` takes the texts of #debug and its like.
    explicit SceneSource(const SceneOptions& options, std::function<void(std::string_view)> debug = {});

    /// What `frame` shows: programs of the animation's first frame or, if they do not hold, of its last one; else the
    /// script. So a frame is the same whichever others are rendered with it. Throws FileError and SceneRejected.
    FrameScenes scenes(int64_t frame);
    /// What `frame` shows by the script alone, for a renderer that found its motion undefined. Any thread may ask,
    /// while another one asks for scenes().
    FrameScenes scenes_by_script(int64_t frame);
    /// What a file of `frame` says of the scene; scenes() was asked for it last, and it was not released since.
    SceneFacts facts(int64_t frame);

    /// Evaluates `frame` by the script, unless it is the same scene as the frame before. Returns whether program() is
    /// new. Throws as above.
    bool load(int64_t frame);

    /// The (first) program of the frame that was asked for last.
    const SceneProgram& program() const { return *shown_.programs.front(); }
    /// Gives the frame's programs up, if other frames have no need of them: the memory is free when nobody shares it,
    /// and a device has its own copy. Frames that do not differ are still known to be the same.
    void release_program();

    /// Makes motion programs of a still as well: for plans.
    void record_stills() { records_stills_ = true; }
    /// Whether float holds what the frame that was asked for last shows.
    const FloatFit& float_fit() const { return shown_.fit; }

    /// What makes motion programs impossible, once a frame was asked for.
    const std::optional<MotionObstacle>& obstacle() const { return obstacle_; }

    /// Warnings, and with `notes` also notes, of everything up to now.
    std::string messages(bool notes) const;

    double parse_ms() const { return parse_ms_; }
    double evaluate_ms() const { return evaluate_ms_; }

private:
    using Program = std::shared_ptr<const SceneProgram>;
    using Moments = std::vector<SceneClock>;

    /// A program that says many frames.
    struct Candidate {
        bool tried = false;
        Program program; ///< null: there is none
    };

    Program moving_program(const Moments& moments);
    Program record(int64_t frame);
    Program evaluate(EvaluationSettings settings);
    EvaluationSettings settings_at(const SceneClock& time) const;
    FrameScenes by_script(const Moments& moments);
    FloatFit fit_of_all_frames(const SceneProgram& program) const;
    void reject_mistakes(const Diagnostics& diagnostics) const;

    const SceneOptions& options_;
    std::function<void(std::string_view)> debug_;
    std::mutex mutex_;        ///< of the script
    Diagnostics diagnostics_; ///< of parsing and of the first evaluation
    bool evaluated_ = false;
    double parse_ms_ = 0, evaluate_ms_ = 0;
    std::optional<SceneScript> script_;

    std::array<Candidate, 2> candidates_;
    std::optional<MotionObstacle> obstacle_;
    bool records_stills_ = false;
    bool same_for_all_frames_ = false;

    FrameScenes shown_;
    std::optional<int64_t> shown_frame_;
    std::optional<Hash128> hash_;              ///< of shown_'s programs
    Camera<double> camera_;                    ///< of the first of them
    std::optional<SceneTables> moving_camera_; ///< tables to move to a frame's time, when the camera moves
};

} // namespace proxima
