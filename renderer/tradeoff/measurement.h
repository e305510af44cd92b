// SPDX-License-Identifier: Apache-2.0
// The measuring of `proxima tradeoff`: each aspect alone first, then the combinations that promise to be on the front,
// until the time is up.
#pragma once
#include "renderer/timing.h"
#include "renderer/tradeoff/quality_pilot.h"
#include "renderer/tradeoff/quality_space.h"
#include "renderer/tradeoff/record.h"

#include <functional>
#include <vector>

namespace proxima {

class TradeoffMeasurement {
public:
    /// `say` is told what is done. Chooses the pilot's size.
    TradeoffMeasurement(QualityPilot& pilot, const TradeoffOptions& options,
                        std::function<void(const std::string&)> say);

    /// Fills in points, aspects, reference and what was left out.
    void run(TradeoffRecord& record);

    const Image& reference() const { return reference_.image; }
    /// Of the point with these options.
    const Image& picture(const QualitySetting& setting) const;

private:
    struct Measured {
        TradeoffPoint point;
        Image image;
    };

    void choose_size();
    void measure(std::vector<QualitySetting> settings);
    void measure_group(const std::vector<QualitySetting>& settings);
    void measure_once(Measured& measured);
    const Measured* find(const QualitySetting& setting) const;
    std::vector<QualitySetting> alone() const;
    std::vector<QualitySetting> promising() const;
    QualitySetting base() const;

    QualityPilot& pilot_;
    const TradeoffOptions& options_;
    std::function<void(const std::string&)> say_;
    Stopwatch watch_;
    std::array<QualityOptions, quality_aspects> space_;
    QualitySetting reference_setting_;
    PilotPicture reference_;
    std::vector<Measured> measured_;
    size_t left_out_ = 0;
};

} // namespace proxima
