// SPDX-License-Identifier: Apache-2.0
#include "renderer/comparison.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace proxima {
namespace {

using Json = nlohmann::ordered_json;

template <class Number> Json number_json(const std::optional<Number>& number) {
    return number ? Json(*number) : Json(nullptr);
}

Json sample_json(float sample) {
    if (std::isfinite(sample))
        return sample;
    return std::isnan(sample) ? "nan" : sample > 0 ? "inf" : "-inf";
}

Json pixel_json(const WorstPixel& pixel) {
    Json json{{"x", pixel.x}, {"y", pixel.y}, {"a", Json::array()}, {"b", Json::array()}};
    for (const float sample : pixel.a)
        json["a"].push_back(sample_json(sample));
    for (const float sample : pixel.b)
        json["b"].push_back(sample_json(sample));
    return json;
}

Json pair_json(const PairRecord& pair) {
    Json json{{"name", pair.name}, {"a", pair.a}, {"b", pair.b}, {"verdict", to_string(pair.verdict)}};
    if (!pair.reason.empty())
        json["reason"] = pair.reason;
    if (!pair.figures)
        return json;
    const ImageFigures& figures = *pair.figures;
    json.update({{"width", pair.width},
                 {"height", pair.height},
                 {"channels", pair.channels},
                 {"compared", pair.rule},
                 {"white", pair.white},
                 {"ignored_channels", pair.ignored_channels},
                 {"non_finite_a", figures.non_finite_a},
                 {"non_finite_b", figures.non_finite_b},
                 {"max_error", figures.max_error},
                 {"rms_error", figures.rms_error},
                 {"psnr_db", number_json(figures.psnr)},
                 {"ssim", number_json(figures.ssim)},
                 {"pixels", figures.pixels},
                 {"pixels_over", figures.pixels_over},
                 {"share_over", double(figures.pixels_over) / double(figures.pixels)},
                 {"worst", figures.worst ? pixel_json(*figures.worst) : Json(nullptr)}});
    return json;
}

} // namespace

const char* to_string(Verdict verdict) {
    switch (verdict) {
    case Verdict::equal:
        return "equal";
    case Verdict::different:
        return "different";
    case Verdict::not_comparable:
        return "not comparable";
    case Verdict::missing:
        return "missing";
    case Verdict::unreadable:
        break;
    }
    return "unreadable";
}

size_t ComparisonRecord::count(Verdict verdict) const {
    return size_t(
        std::count_if(pairs.begin(), pairs.end(), [&](const PairRecord& pair) { return pair.verdict == verdict; }));
}

std::string to_json(const ComparisonRecord& comparison) {
    Json json{{"program", "proxima"},
              {"version", PROXIMA_VERSION},
              {"a", comparison.a},
              {"b", comparison.b},
              {"tolerance", comparison.tolerance},
              {"allowed_share", comparison.allowed_share},
              {"failures", comparison.failures()},
              {"pairs", Json::array()}};
    for (const PairRecord& pair : comparison.pairs)
        json["pairs"].push_back(pair_json(pair));
    // A path that is not UTF-8 must not end the run.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace proxima
