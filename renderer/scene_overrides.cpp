// SPDX-License-Identifier: Apache-2.0
#include "renderer/scene_overrides.h"
#include "parser/area_weights.h"
#include "parser/moving_record.h"

#include <algorithm>

namespace proxima {
namespace {

/// A bail-out that follows from the time would come back with the next frame.
void stop_moving_bailout(SceneProgram& scene) {
    const uint32_t offset = offset_of(static_cast<const SceneTables*>(&scene), &scene.adc_bailout);
    for (MotionField& field : scene.motion.fields)
        if (field.table == MotionField::Table::scene && field.offset == offset)
            field.table = MotionField::Table::guard;
}

void limit_area_lights(SceneProgram& scene, uint32_t most) {
    scene.area_samples.clear();
    for (AreaLight<double>& area : scene.area_lights) {
        area.columns = std::min(area.columns, most);
        area.rows = std::min(area.rows, most);
        area.first_sample = uint32_t(scene.area_samples.size());
        if (area.adaptive == AreaLight<double>::every_place)
            append_area_samples(scene.area_samples, area.columns, area.rows);
        area.sample_count = uint32_t(scene.area_samples.size()) - area.first_sample;
    }
}

} // namespace

void apply(const SceneOverrides& overrides, SceneProgram& scene) {
    if (overrides.max_trace_level)
        scene.max_trace_level = *overrides.max_trace_level;
    if (overrides.adc_bailout) {
        scene.adc_bailout = *overrides.adc_bailout;
        stop_moving_bailout(scene);
    }
    if (overrides.area_places)
        limit_area_lights(scene, *overrides.area_places);
}

} // namespace proxima
