// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace proxima {
namespace {

using Json = nlohmann::ordered_json;

std::string ssim_text(const std::optional<double>& ssim) {
    return ssim ? fmt::format("{:.5f}", *ssim) : "-";
}

std::string row(const TradeoffPoint& point) {
    const auto [least, most] = point.range();
    return fmt::format("{} {:>10.3f} {:>10.3f} {:>10.3f} {:>8.2f} {:>9.5f} {:>8.4f} {:>8} {:>8.3f}  {}\n",
                       point.on_front ? '*' : ' ', point.ms, least, most, point.error.levels, point.error.rms,
                       point.error.max, ssim_text(point.error.ssim), 100 * point.error.visible, point.options);
}

std::string files_text(const TradeoffRecord& record) {
    std::string text = "\nThe file beside it (EXR; RMS is of linear light):\n";
    text += fmt::format("  {:>10} {:>8} {:>12} {:>10}  {}\n", "ms", "KB", "RMS", "levels", "options");
    for (const FilePoint& file : record.files)
        text += fmt::format("  {:>10.2f} {:>8.1f} {:>12.3g} {:>10.4f}  --bits {} --compression {}\n", file.ms,
                            double(file.bytes) / 1024, file.error.rms, file.error.levels, file.bits, file.compression);
    return text;
}

Json error_json(const PictureError& error) {
    return {{"levels_rms", error.levels},
            {"rms", error.rms},
            {"max", error.max},
            {"ssim", error.ssim ? Json(*error.ssim) : Json()},
            {"visible_share", error.visible}};
}

Json point_json(const TradeoffPoint& point) {
    Json json{{"options", point.options},    {"ms", point.ms},
              {"pilot_ms", point.pilot_ms},  {"spread", point.spread()},
              {"repeats_ms", point.repeats}, {"camera_rays_a_pixel", point.rays},
              {"on_front", point.on_front}};
    json.update(error_json(point.error));
    return json;
}

} // namespace

std::string tradeoff_text(const TradeoffRecord& record) {
    std::string text = fmt::format("{}, frame {}, on {}: {} settings in pictures of {}x{}, each measured {} times\n",
                                   record.scene, record.frame, record.device, record.points.size(), record.pilot_width,
                                   record.pilot_height, record.repeats);
    text +=
        fmt::format("reference: the mean of {} and of as many other samples; it is off by about {:.3f} levels itself,\n"
                    "  by half of what is between the two, and of less than that nothing can be told\n",
                    record.reference, record.reference_error.levels);
    text += fmt::format("noise: half of the times spread by {:.1f} % and less between repeats\n", 100 * record.noise());
    for (const TradeoffAspect& aspect : record.aspects)
        text += fmt::format("  {:<12} {:<10} {}\n", aspect.name,
                            aspect.options > 1 ? fmt::format("{} options", aspect.options) : "as it is", aspect.reason);
    if (record.left_out > 0)
        text += fmt::format("left out for want of time: {} combinations; a longer --budget measures them\n",
                            record.left_out);
    text += fmt::format("\nms: of {}x{}, from the small picture, the median of the repeats, with the least and the "
                        "most; levels: RMS of what a display shows, 255 is white;\n"
                        "visible: percent of the pixels that differ by more than 2.3 in CIELAB; * is on the front\n\n",
                        record.width, record.height);
    text += fmt::format("  {:>10} {:>10} {:>10} {:>8} {:>9} {:>8} {:>8} {:>8}  {}\n", "ms", "least", "most", "levels",
                        "RMS", "max", "SSIM", "visible", "options");
    for (const TradeoffPoint& point : record.points)
        text += row(point);
    if (!record.files.empty())
        text += files_text(record);
    text += "\nThe cheapest setting for an error of at most\n";
    for (const Recommendation& recommendation : record.recommendations) {
        text += fmt::format("  {:>3g}/255  ", recommendation.levels);
        if (!recommendation.point) {
            text += recommendation.levels < record.reference_error.levels ? "the reference is not as good as that\n"
                                                                          : "none of these\n";
            continue;
        }
        const TradeoffPoint& point = record.points[*recommendation.point];
        text += fmt::format("{:>10.3f} ms  {:>6.3f}/255  {}\n", point.ms, point.error.levels, point.options);
    }
    return text;
}

std::string tradeoff_csv(const TradeoffRecord& record) {
    std::string text =
        "options,ms,pilot_ms,spread,camera_rays_a_pixel,levels_rms,rms,max,ssim,visible_share,on_front\n";
    for (const TradeoffPoint& point : record.points)
        text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.9g},{:.9g},{:.9g},{},{:.9g},{}\n", point.options,
                            point.ms, point.pilot_ms, point.spread(), point.rays, point.error.levels, point.error.rms,
                            point.error.max, point.error.ssim ? fmt::format("{:.9g}", *point.error.ssim) : "",
                            point.error.visible, point.on_front ? 1 : 0);
    return text;
}

std::string tradeoff_json(const TradeoffRecord& record) {
    Json json{{"program", "proxima"},
              {"version", PROXIMA_VERSION},
              {"scene", record.scene},
              {"frame", record.frame},
              {"device", record.device},
              {"size", {record.width, record.height}},
              {"pilot_size", {record.pilot_width, record.pilot_height}},
              {"repeats", record.repeats},
              {"budget_s", record.budget},
              {"seconds", record.seconds},
              {"noise", record.noise()},
              {"left_out", record.left_out},
              {"reference", {{"options", record.reference}, {"own_error", error_json(record.reference_error)}}},
              {"aspects", Json::array()},
              {"points", Json::array()},
              {"files", Json::array()},
              {"recommendations", Json::array()}};
    for (const TradeoffAspect& aspect : record.aspects)
        json["aspects"].push_back({{"name", aspect.name}, {"options", aspect.options}, {"reason", aspect.reason}});
    for (const TradeoffPoint& point : record.points)
        json["points"].push_back(point_json(point));
    for (const FilePoint& file : record.files) {
        json["files"].push_back({{"bits", file.bits},
                                 {"compression", file.compression},
                                 {"file", file.file},
                                 {"bytes", file.bytes},
                                 {"encode_ms", file.ms},
                                 {"repeats_ms", file.repeats}});
        json["files"].back().update(error_json(file.error));
    }
    for (const Recommendation& recommendation : record.recommendations)
        json["recommendations"].push_back(
            {{"levels", recommendation.levels},
             {"point", recommendation.point ? Json(*recommendation.point) : Json()},
             {"options", recommendation.point ? Json(record.points[*recommendation.point].options) : Json()}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace proxima
