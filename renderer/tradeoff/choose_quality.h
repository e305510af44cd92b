// SPDX-License-Identifier: Apache-2.0
// `--max-error`: an error that is allowed in, the cheapest setting that keeps it out. It is found with small pictures
// of the animation's first, middle and last frame, on the CPU and without a clock, so that it is the same for every
// part of an animation and on every machine: "cheapest" is most_rays, counted.
#pragma once
#include "renderer/options.h"
#include "renderer/stop_signal.h"
#include "renderer/tradeoff/picture_error.h"
#include "renderer/tradeoff/quality_setting.h"

#include <optional>
#include <string>

namespace proxima {

/// What was chosen, and why.
struct QualityChoice {
    QualitySetting setting{};
    std::string options{};                  ///< of `proxima render` that make it
    PictureError predicted{};               ///< of the worst of the small pictures
    std::string pilot{};                    ///< what those were, for the user
    double ms = 0;                          ///< that choosing took
    std::optional<PictureError> measured{}; ///< of `measured_frame` at its whole size
    int64_t measured_frame = 0;
};

/// Throws UsageError when no setting keeps the limit or the scene cannot be read twice, and what rendering throws.
/// `threads` as for make_cpu_renderer.
QualityChoice choose_quality(const SceneOptions& scene, const FrameSettings& frame, const QualityRequest& request,
                             unsigned threads, const StopSignal& stop);

/// Renders a whole frame with the choice and the reference on `renderer`, and compares them.
void measure_choice(QualityChoice& choice, const SceneOptions& scene, const FrameSettings& asked, int64_t frame,
                    FrameRenderer& renderer, const StopSignal& stop);

/// "0.01 RMS" or "2/255".
std::string error_text(const ErrorLimit& limit, const PictureError& error);

} // namespace proxima
