// SPDX-License-Identifier: Apache-2.0
// What trades a picture's accuracy for its time: one choice for each thing that can be chosen.
#pragma once
#include "renderer/options.h"

#include <string>

namespace proxima {

/// All of it as `proxima render` has it; what a scene cannot react to stays as it was asked for.
struct QualitySetting {
    Precision precision = Precision::float32;
    uint32_t samples = 1;
    Antialiasing antialiasing{};
    SceneOverrides overrides{};
    uint32_t shutter_samples = 1;

    friend bool operator==(const QualitySetting&, const QualitySetting&) = default;
};

/// What a run was asked for.
QualitySetting quality_of(const SceneOptions& scene, const FrameSettings& frame);
/// Puts it into a run's options.
void apply(const QualitySetting& setting, SceneOptions& scene, FrameSettings& frame);

/// Whether two settings render the same scene in the same precision: then one upload to a device serves both.
bool shares_scene(const QualitySetting& a, const QualitySetting& b);

/// The options of `proxima render` that make `setting` out of a run with `asked`; of what both have, only precision
/// and sampling are written.
std::string option_text(const QualitySetting& setting, const QualitySetting& asked);

std::string precision_name(Precision precision);

} // namespace proxima
