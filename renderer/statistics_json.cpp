// SPDX-License-Identifier: Apache-2.0
#include "renderer/statistics_json.h"
#include "renderer/host_memory.h"

#include <nlohmann/json.hpp>

namespace proxima {
namespace {

using Json = nlohmann::ordered_json;

/// Null without a cloud.
Json metric_json(const FrameStatistics& statistics) {
    static constexpr const char* names[] = {"chessboard", "city-block", "euclidean", "octant"};
    return statistics.method == "cloud" ? Json(names[size_t(statistics.metric)]) : Json();
}

/// A method's times as they were known before the frame; null where they were not.
Json method_json(double predicted_ms, double measured_ms) {
    const auto known = [](double ms) { return ms > 0 ? Json(ms) : Json(); };
    return {{"predicted_ms", known(predicted_ms)}, {"measured_ms", known(measured_ms)}};
}

Json choice_json(const MethodRecord& choice) {
    const bool has_looked = choice.space.bricks > 0;
    return {{"why", name_of(choice.reason)},
            {"occupied_bricks", has_looked ? Json(choice.space.occupied()) : Json()},
            {"mean_distance", has_looked ? Json(choice.space.mean_distance) : Json()},
            {"grid", method_json(choice.predicted.grid, choice.measured.grid)},
            {"cloud", method_json(choice.predicted.cloud, choice.measured.cloud)}};
}

Json frame_json(const FrameRecord& record) {
    const FrameStatistics& statistics = record.statistics;
    return {{"frame", record.frame},
            {"file", record.file},
            {"hash", record.hash},
            {"device", record.device},
            {"precision", record.precision},
            {"method", statistics.method},
            {"choice", choice_json(statistics.choice)},
            {"metric", metric_json(statistics)},
            {"brick", statistics.brick},
            {"grid", statistics.grid},
            {"wanted_grid", statistics.wanted_grid[0] ? Json(statistics.wanted_grid) : Json()},
            {"references", statistics.references},
            {"occupied", statistics.occupied},
            {"outliers", statistics.outliers},
            {"mean_distance", statistics.mean_distance},
            {"motion_ms", statistics.motion_ms},
            {"build_ms", statistics.build_ms},
            {"cloud_ms", statistics.cloud_ms},
            {"relay_ms", statistics.relay_ms},
            {"trace_ms", statistics.trace_ms},
            {"readback_ms", statistics.readback_ms},
            {"color_ms", record.color_ms},
            {"encode_ms", record.encode_ms},
            {"write_ms", record.write_ms},
            {"camera_rays", statistics.camera_rays},
            {"peak_device_bytes", statistics.peak_device_bytes},
            {"host_bytes", record.host_bytes},
            {"replaced_samples", record.replaced_samples},
            {"clamped_samples", record.clamped_samples}};
}

Json error_json(const PictureError& error) {
    return {{"rms", error.rms},
            {"levels_rms", error.levels},
            {"max", error.max},
            {"ssim", error.ssim ? Json(*error.ssim) : Json()},
            {"visible_share", error.visible}};
}

/// Null without --max-error.
Json quality_json(const std::optional<QualityRecord>& quality) {
    if (!quality)
        return {};
    return {{"max_error", quality->max_error},
            {"options", quality->options},
            {"pilot", quality->pilot},
            {"pilot_ms", quality->pilot_ms},
            {"predicted", error_json(quality->predicted)},
            {"measured", quality->measured ? error_json(*quality->measured) : Json()}};
}

Json span_json(const Timeline& timeline, const TimelineSpan& span) {
    return {{"lane", span.lane},         {"device", timeline.lanes()[span.lane]},
            {"frame", span.frame},       {"step", name_of(span.step)},
            {"begin_ms", span.begin_ms}, {"end_ms", span.end_ms}};
}

} // namespace

std::string to_json(const RunRecord& run, const Timeline& timeline) {
    Json json{{"program", "proxima"},
              {"version", PROXIMA_VERSION},
              {"scene", run.scene},
              {"width", run.width},
              {"height", run.height},
              {"samples", run.samples},
              {"parse_ms", run.parse_ms},
              {"evaluate_ms", run.evaluate_ms},
              {"spheres", run.spheres},
              {"moving", run.moving},
              {"quality", quality_json(run.quality)},
              {"peak_host_bytes", peak_host_bytes()},
              {"wall_ms", run.wall_ms},
              {"frames", Json::array()}};
    for (const FrameRecord& record : run.frames)
        json["frames"].push_back(frame_json(record));
    json["busy"] = timeline.busy_shares();
    json["timeline"] = Json::array();
    for (const TimelineSpan& span : timeline.spans())
        json["timeline"].push_back(span_json(timeline, span));
    // A path that is not UTF-8 must not end the run.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace proxima
