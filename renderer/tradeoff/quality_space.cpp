// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/quality_space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

using Method = Antialiasing::Method;

constexpr uint32_t sample_counts[] = {64, 48, 32, 24, 16, 12, 8, 6, 4, 3, 2, 1};
constexpr float thresholds[] = {0.03f, 0.1f, 0.3f};

/// `most`, its half, quarter, ..., 1.
std::vector<uint32_t> halvings(uint32_t most) {
    std::vector<uint32_t> numbers{most};
    while (numbers.back() > 1)
        numbers.push_back((numbers.back() + 1) / 2);
    return numbers;
}

bool paths_go_on(const SceneTables& scene) {
    constexpr uint32_t on = material_reflective | material_transparent;
    return scene.max_trace_level > 1 &&
           std::ranges::any_of(scene.materials, [](const Material& material) { return (material.flags & on) != 0; });
}

uint32_t area_places(const SceneTables& scene) {
    uint32_t most = 1;
    for (const AreaLight<double>& area : scene.area_lights)
        most = std::max({most, area.columns, area.rows});
    return most;
}

/// The options by a list of numbers, the first of which is what was asked for.
template <class Numbers, class Set>
std::vector<QualitySetting> settings_of(const QualitySetting& asked, const Numbers& numbers, const Set& set) {
    std::vector<QualitySetting> settings;
    for (const auto number : numbers) {
        settings.push_back(asked);
        if (settings.size() > 1)
            set(settings.back(), number);
    }
    return settings;
}

QualityOptions sampling_options(const QualitySetting& asked) {
    QualityOptions options{QualityAspect::sampling, "every picture has samples", {}};
    const auto add = [&](uint32_t samples, Antialiasing antialiasing) {
        options.settings.push_back(asked);
        options.settings.back().samples = samples;
        options.settings.back().antialiasing = antialiasing;
    };
    for (const uint32_t samples : sample_counts)
        add(samples, {});
    for (const float threshold : thresholds)
        add(1, {Method::blocks, threshold, 3});
    return options;
}

QualityOptions precision_options(const QualitySetting& asked) {
    QualityOptions options{QualityAspect::precision, "every picture has a precision", {}};
    for (const Precision precision : {Precision::float64, Precision::float32}) {
        options.settings.push_back(asked);
        options.settings.back().precision = precision;
    }
    return options;
}

QualityOptions level_options(const SceneTables& scene, const QualitySetting& asked) {
    if (!paths_go_on(scene))
        return {QualityAspect::trace_level, "no path goes on from a surface", {asked}};
    return {QualityAspect::trace_level, fmt::format("paths go on, up to level {}", scene.max_trace_level),
            settings_of(asked, halvings(scene.max_trace_level),
                        [](QualitySetting& setting, uint32_t level) { setting.overrides.max_trace_level = level; })};
}

QualityOptions bailout_options(const SceneTables& scene, const QualitySetting& asked) {
    if (!paths_go_on(scene))
        return {QualityAspect::bailout, "no path goes on from a surface", {asked}};
    std::vector<float> bailouts{scene.adc_bailout};
    for (const float factor : {4.0f, 16.0f})
        if (const float bailout = std::max(scene.adc_bailout, 1e-4f) * factor; bailout < 0.5f)
            bailouts.push_back(bailout);
    return {QualityAspect::bailout, fmt::format("paths end below {:.4g} of a pixel", scene.adc_bailout),
            settings_of(asked, bailouts,
                        [](QualitySetting& setting, float bailout) { setting.overrides.adc_bailout = bailout; })};
}

QualityOptions area_options(const SceneTables& scene, const QualitySetting& asked) {
    const uint32_t most = area_places(scene);
    if (most == 1)
        return {QualityAspect::area_places, "there are no area lights", {asked}};
    return {QualityAspect::area_places, fmt::format("an area light has {} places along an axis", most),
            settings_of(asked, halvings(most),
                        [](QualitySetting& setting, uint32_t places) { setting.overrides.area_places = places; })};
}

QualityOptions shutter_options(const SceneProgram& scene, const QualitySetting& asked) {
    if (asked.shutter_samples == 1)
        return {QualityAspect::shutter_samples, "a frame is one moment", {asked}};
    if (!scene.depends_on_time)
        return {QualityAspect::shutter_samples, "nothing moves", {asked}};
    return {QualityAspect::shutter_samples, fmt::format("a frame is the mean of {} moments", asked.shutter_samples),
            settings_of(asked, halvings(asked.shutter_samples),
                        [](QualitySetting& setting, uint32_t samples) { setting.shutter_samples = samples; })};
}

} // namespace

const char* name_of(QualityAspect aspect) {
    static constexpr const char* names[quality_aspects] = {"samples",  "precision",   "trace level",
                                                           "bail-out", "area lights", "shutter"};
    return names[size_t(aspect)];
}

void take(QualityAspect aspect, const QualitySetting& from, QualitySetting& setting) {
    switch (aspect) {
    case QualityAspect::sampling:
        setting.samples = from.samples;
        setting.antialiasing = from.antialiasing;
        break;
    case QualityAspect::precision:
        setting.precision = from.precision;
        break;
    case QualityAspect::trace_level:
        setting.overrides.max_trace_level = from.overrides.max_trace_level;
        break;
    case QualityAspect::bailout:
        setting.overrides.adc_bailout = from.overrides.adc_bailout;
        break;
    case QualityAspect::area_places:
        setting.overrides.area_places = from.overrides.area_places;
        break;
    case QualityAspect::shutter_samples:
        setting.shutter_samples = from.shutter_samples;
        break;
    }
}

std::array<QualityOptions, quality_aspects> quality_space(const SceneProgram& scene, const QualitySetting& asked) {
    return {sampling_options(asked),       precision_options(asked),   level_options(scene, asked),
            bailout_options(scene, asked), area_options(scene, asked), shutter_options(scene, asked)};
}

QualitySetting reference_quality(const SceneProgram& scene, const QualitySetting& asked) {
    QualitySetting reference = asked;
    reference.precision = Precision::float64;
    reference.samples = 1;
    reference.antialiasing = {Method::grid, 0, 8};
    if (asked.shutter_samples > 1 && scene.depends_on_time) {
        reference.antialiasing.depth = 4;
        reference.shutter_samples = std::min(2 * asked.shutter_samples, Shutter::most_samples);
    }
    return reference;
}

QualitySetting second_reference(const QualitySetting& reference) {
    QualitySetting second = reference;
    second.samples = rays_of(reference);
    second.antialiasing = {};
    return second;
}

uint32_t rays_of(const QualitySetting& setting) {
    const uint32_t side = setting.antialiasing.depth;
    return setting.antialiasing.method == Method::grid ? side * side + 1 : setting.samples;
}

PictureError combine(const PictureError& sampling, const std::vector<PictureError>& others) {
    PictureError sum = sampling;
    for (const PictureError& other : others) {
        sum.rms = std::hypot(sum.rms, other.rms);
        sum.levels = std::hypot(sum.levels, other.levels);
        sum.max += other.max;
        sum.visible = std::min(1.0, sum.visible + other.visible);
    }
    sum.ssim.reset();
    return sum;
}

double most_rays(const SceneProgram& scene, const QualitySetting& setting, double camera_rays_a_pixel) {
    double lights = 0;
    for (const Light<double>& light : scene.lights) {
        if (light.shadowless)
            continue;
        if (light.area == Light<double>::no_area) {
            lights += 1;
            continue;
        }
        const AreaLight<double>& area = scene.area_lights[light.area];
        const uint32_t most = setting.overrides.area_places.value_or(AreaLight<double>::most);
        lights += double(std::min(area.columns, most)) * std::min(area.rows, most);
    }
    const uint32_t levels = paths_go_on(scene) ? setting.overrides.max_trace_level.value_or(scene.max_trace_level) : 1;
    return camera_rays_a_pixel * setting.shutter_samples * levels * (1 + lights) *
           (setting.precision == Precision::float64 ? 2 : 1);
}

} // namespace proxima
