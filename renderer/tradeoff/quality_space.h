// SPDX-License-Identifier: Apache-2.0
// A scene in, what can be chosen for it out: only what it can react to has more than one option.
#pragma once
#include "renderer/tradeoff/picture_error.h"
#include "renderer/tradeoff/quality_setting.h"

#include <array>
#include <string>
#include <vector>

namespace proxima {

/// One thing that can be chosen.
enum class QualityAspect : uint32_t { sampling, precision, trace_level, bailout, area_places, shutter_samples };
inline constexpr size_t quality_aspects = 6;
const char* name_of(QualityAspect aspect);

/// The options of an aspect, from the most accurate to the cheapest; the other aspects are as asked for. One option
/// alone: there is nothing to choose.
struct QualityOptions {
    QualityAspect aspect = QualityAspect::sampling;
    std::string reason; ///< why there is a choice or none, a part of a sentence
    std::vector<QualitySetting> settings;
};

/// Gives `setting` what `from` has for an aspect.
void take(QualityAspect aspect, const QualitySetting& from, QualitySetting& setting);

/// In the order of QualityAspect. `asked` is what `scene` was evaluated with; accuracy beyond it is not looked for, but
/// in sampling and precision.
std::array<QualityOptions, quality_aspects> quality_space(const SceneProgram& scene, const QualitySetting& asked);

/// What settings are measured against: `asked` in double, with POV-Ray's grid of samples in every pixel, and twice as
/// many moments as long as the scene moves.
QualitySetting reference_quality(const SceneProgram& scene, const QualitySetting& asked);
/// The same number of samples in other places: how far it is from the reference tells how far that is from the truth.
QualitySetting second_reference(const QualitySetting& reference);
/// Camera rays a pixel of a setting without antialiasing by differences.
uint32_t rays_of(const QualitySetting& setting);

/// The error of aspects that add up: `sampling` is what remains with all others as asked, `others` what each of them
/// changes. Independent errors add by their squares; the largest sample and share add as they are.
PictureError combine(const PictureError& sampling, const std::vector<PictureError>& others);

/// The most rays that a pixel may take: camera rays, times the levels of a path where paths go on, times one and a
/// shadow ray to each place of each light; twice that in double. A number for order, without a clock.
double most_rays(const SceneProgram& scene, const QualitySetting& setting, double camera_rays_a_pixel);

} // namespace proxima
