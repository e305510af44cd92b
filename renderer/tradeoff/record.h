// SPDX-License-Identifier: Apache-2.0
// What `proxima tradeoff` found: settings with their time and error, which of them are worth having, and what to take.
#pragma once
#include "renderer/tradeoff/picture_error.h"
#include "renderer/tradeoff/quality_setting.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace proxima {

/// Milliseconds: the median of the repeats.
struct TradeoffPoint {
    QualitySetting setting{};
    std::string options{};         ///< of `proxima render`
    std::vector<double> repeats{}; ///< of the small picture, in the order measured
    double pilot_ms = 0;           ///< of the small picture
    double ms = 0;                 ///< of the whole one: what grows with the pixels, grown
    double rays = 0;               ///< of the camera, a pixel of a moment
    PictureError error{};
    bool on_front = false; ///< no other setting is as fast or faster and as accurate or more, and better in one

    /// The longest repeat less the shortest, over the median.
    double spread() const;
    /// The shortest and the longest of the repeats, as times of the whole picture.
    std::pair<double, double> range() const;
};

/// A way to write the picture.
struct FilePoint {
    std::string bits{}, compression{}, file{};
    uint64_t bytes = 0;
    std::vector<double> repeats{};
    double ms = 0; ///< to encode the small picture
    PictureError error{};
};

/// The cheapest setting whose error is at most `levels`; none when there is none, or when the reference is not as good
/// as that itself.
struct Recommendation {
    double levels = 0; ///< see PictureError::levels
    std::optional<size_t> point{};
};

struct TradeoffAspect {
    std::string name, reason;
    size_t options = 1;
};

struct TradeoffRecord {
    std::string scene, device;
    int64_t frame = 0;
    uint32_t width = 0, height = 0, pilot_width = 0, pilot_height = 0;
    uint32_t repeats = 0;
    double budget = 0, seconds = 0;
    std::string reference{};        ///< its options
    PictureError reference_error{}; ///< its own, estimated by its two halves: of less, nothing can be told
    std::vector<TradeoffAspect> aspects{};
    std::vector<TradeoffPoint> points{}; ///< by rising time
    size_t left_out = 0;                 ///< combinations that looked promising and that there was no time for
    std::vector<FilePoint> files{};
    std::vector<Recommendation> recommendations{};

    /// Half of the settings were measured with no more spread than this.
    double noise() const;
};

double median(std::vector<double> values);

/// Sorts the points by time, marks the front (in ms and error.levels) and makes the recommendations.
void conclude(TradeoffRecord& record);

} // namespace proxima
