// SPDX-License-Identifier: Apache-2.0
// The scene file of a command: read and parsed once, evaluated as often as its frames differ.
#pragma once
#include "parser/scene_script.h"
#include "renderer/options.h"
#include "renderer/scene_facts.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace proxima {

class SceneSource {
public:
    /// Reads and parses. Throws FileError and SceneRejected. `options` must outlive this.
    /// `debug` takes the texts of #debug and its like.
    explicit SceneSource(const SceneOptions& options, std::function<void(std::string_view)> debug = {});

    /// Evaluates `frame` unless it is the same scene as the frame before. Returns whether program() is new.
    /// Throws FileError and SceneRejected.
    bool load(int64_t frame);

    const SceneProgram& program() const { return *program_; }
    /// The same, for those who use it while a later frame is loaded. Null once released.
    std::shared_ptr<const SceneProgram> shared_program() const { return program_; }
    /// What a file of `frame` says of the scene, which was loaded for it and not released since.
    SceneFacts facts(int64_t frame);
    /// Gives the program up: its memory is free when nobody shares it, and a device has its own copy. Frames that do
    /// not differ are still known to be the same.
    void release_program() { program_.reset(); }

    /// Warnings, and with `notes` also notes, of everything up to now.
    std::string messages(bool notes) const;

    double parse_ms() const { return parse_ms_; }
    double evaluate_ms() const { return evaluate_ms_; }

private:
    void reject_mistakes(const Diagnostics& diagnostics) const;

    const SceneOptions& options_;
    std::function<void(std::string_view)> debug_;
    Diagnostics diagnostics_; ///< of parsing and of the first evaluation
    double parse_ms_ = 0, evaluate_ms_ = 0;
    std::optional<SceneScript> script_;
    std::shared_ptr<const SceneProgram> program_;
    std::optional<int64_t> loaded_frame_;
    bool same_for_all_frames_ = false;
    std::optional<Hash128> hash_;              ///< of the program
    std::optional<SceneTables> moving_camera_; ///< tables to move to a frame's time, when the camera moves
    Camera<double> camera_;                    ///< of the first frame
    MotionPrograms camera_motion_;             ///< of everything but spheres
};

} // namespace proxima
