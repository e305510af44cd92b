// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/quality_setting.h"

#include <fmt/format.h>

namespace proxima {
namespace {

using Method = Antialiasing::Method;

std::string sampling_text(const QualitySetting& setting) {
    const Antialiasing& antialiasing = setting.antialiasing;
    switch (antialiasing.method) {
    case Method::none:
        break;
    case Method::grid:
        return fmt::format("--antialias grid:{}", antialiasing.depth);
    case Method::blocks:
        return fmt::format("--antialias method1:{:g}:{}", antialiasing.threshold, antialiasing.depth);
    case Method::squares:
        return fmt::format("--antialias method2:{:g}:{}", antialiasing.threshold, antialiasing.depth);
    }
    return fmt::format("--samples {}", setting.samples);
}

} // namespace

QualitySetting quality_of(const SceneOptions& scene, const FrameSettings& frame) {
    return {frame.precision, frame.samples, frame.antialiasing, scene.overrides, scene.animation.shutter.samples};
}

void apply(const QualitySetting& setting, SceneOptions& scene, FrameSettings& frame) {
    frame.precision = setting.precision;
    frame.samples = setting.samples;
    frame.antialiasing = setting.antialiasing;
    scene.overrides = setting.overrides;
    scene.animation.shutter.samples = setting.shutter_samples;
}

bool shares_scene(const QualitySetting& a, const QualitySetting& b) {
    return a.precision == b.precision && a.overrides == b.overrides && a.shutter_samples == b.shutter_samples;
}

std::string option_text(const QualitySetting& setting, const QualitySetting& asked) {
    std::string text = fmt::format("--precision {} {}", precision_name(setting.precision), sampling_text(setting));
    const SceneOverrides &ours = setting.overrides, &theirs = asked.overrides;
    if (ours.max_trace_level != theirs.max_trace_level)
        text += fmt::format(" --max-trace-level {}", *ours.max_trace_level);
    if (ours.adc_bailout != theirs.adc_bailout)
        text += fmt::format(" --adc-bailout {:.6g}", *ours.adc_bailout);
    if (ours.area_places != theirs.area_places)
        text += fmt::format(" --area-places {}", *ours.area_places);
    if (setting.shutter_samples != asked.shutter_samples)
        text += fmt::format(" --shutter-samples {}", setting.shutter_samples);
    return text;
}

std::string precision_name(Precision precision) {
    return precision == Precision::float64 ? "double" : "float";
}

} // namespace proxima
