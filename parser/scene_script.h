// SPDX-License-Identifier: Apache-2.0
// The parser's front door: a scene file read once, evaluated as often as there are frames.
#pragma once
#include "parser/diagnostics.h"
#include "parser/scene_program.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace proxima {

/// The values of the predeclared animation names for one frame; the defaults are a still's.
struct SceneClock {
    double clock = 0;
    double clock_delta = 0;
    bool clock_on = false;
    double frame_number = 0;
    double initial_frame = 0;
    double final_frame = 0;
    double initial_clock = 0;
    double final_clock = 0;
};

/// What of it motion programs work with.
inline MotionTime motion_time(const SceneClock& time) {
    return {time.clock, time.frame_number, time.clock_delta};
}

/// What one evaluation may cost. A scene that needs more is refused.
struct EvaluationBudget {
    uint64_t steps = 500'000'000; ///< tokens evaluated; past it an endless loop is assumed
    uint64_t bytes = 0;           ///< of memory; 0: three quarters of the machine's
    double seconds = 600;
};

struct EvaluationSettings {
    SceneClock time;
    uint32_t image_width = 640;
    uint32_t image_height = 480;
    /// --declare NAME=VALUE: a number, or a string in double quotes.
    std::vector<std::pair<std::string, std::string>> declares;
    EvaluationBudget budget;
    /// Makes motion programs of what follows from the time, if that is possible.
    bool record_motion = false;
    /// Throws MotionImpossible as soon as it is not.
    bool needs_motion = false;
    /// The script is not evaluated again: literal spheres are moved out of the syntax instead of copied.
    bool last_evaluation = false;
    /// Takes the texts of #debug, #render and #statistics; without it they are dropped.
    std::function<void(std::string_view)> debug;
};

class SceneScript {
public:
    /// Reads and parses `path`, or the standard input for "-". Mistakes go to `diagnostics`; files that cannot be read
    /// throw FileError.
    SceneScript(const std::filesystem::path& path, std::vector<std::filesystem::path> include_paths,
                Diagnostics& diagnostics);
    ~SceneScript();
    SceneScript(SceneScript&&) noexcept;

    /// One frame's scene. The result may be used only when `diagnostics` holds no error.
    SceneProgram evaluate(const EvaluationSettings& settings, Diagnostics& diagnostics);

    const SourceFiles& files() const;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace proxima
