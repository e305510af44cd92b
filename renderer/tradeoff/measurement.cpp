// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/measurement.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace proxima {
namespace {

constexpr uint32_t smallest_side = 48, first_side = 64; ///< pixels of the longer side
constexpr uint32_t base_samples = 4;
constexpr uint32_t most_samples = 24; ///< that are measured: more come close to the reference's own error
constexpr size_t most_combinations = 48;

} // namespace

TradeoffMeasurement::TradeoffMeasurement(QualityPilot& pilot, const TradeoffOptions& options,
                                         std::function<void(const std::string&)> say)
    : pilot_(pilot), options_(options), say_(std::move(say)), space_(quality_space(pilot.program(), pilot.asked())),
      reference_setting_(reference_quality(pilot.program(), pilot.asked())) {
    choose_size();
}

/// Two references and the rest together take about 500 samples a pixel in double, and as many moments each.
void TradeoffMeasurement::choose_size() {
    QualitySetting probe = reference_setting_;
    probe.antialiasing = {};
    probe.samples = 1;
    pilot_.resize(first_side);
    pilot_.render_first(probe); // what is allocated and loaded once
    const PilotPicture picture = pilot_.render_first(probe);
    const double rays = rays_of(reference_setting_);
    const double samples = (2 * rays + 130 * options_.repeats) * (rays < 30 ? 0.7 : 1.0);
    const double pixels = double(pilot_.width()) * pilot_.height();
    const double ms_a_pixel = std::max(picture.ms - picture.build_ms, 1e-3) / pixels;
    const double fitting = options_.budget * 1000 / (samples * ms_a_pixel);
    const double side = first_side * std::sqrt(fitting / pixels);
    pilot_.resize(uint32_t(std::clamp(side, double(smallest_side), 65536.0)));
}

QualitySetting TradeoffMeasurement::base() const {
    QualitySetting base = pilot_.asked();
    base.precision = Precision::float32;
    base.samples = base_samples;
    base.antialiasing = {};
    return base;
}

/// All samplings with the rest as asked; every other option of the other aspects at the base's samples.
std::vector<QualitySetting> TradeoffMeasurement::alone() const {
    std::vector<QualitySetting> settings;
    for (const QualityOptions& aspect : space_) {
        for (const QualitySetting& option : aspect.settings) {
            if (aspect.aspect == QualityAspect::sampling && option.samples > most_samples)
                continue;
            QualitySetting setting = base();
            take(aspect.aspect, option, setting);
            if (std::ranges::find(settings, setting) == settings.end())
                settings.push_back(setting);
        }
    }
    for (const auto method : {Antialiasing::Method::squares})
        for (const float threshold : {0.1f, 0.3f}) {
            settings.push_back(base());
            settings.back().samples = 1;
            settings.back().antialiasing = {method, threshold, 3};
        }
    return settings;
}

void TradeoffMeasurement::run(TradeoffRecord& record) {
    say_(fmt::format("pictures of {}x{}; the reference: {}", pilot_.width(), pilot_.height(),
                     option_text(reference_setting_, pilot_.asked())));
    reference_ = pilot_.render_first(reference_setting_);
    const PilotPicture second = pilot_.render_first(second_reference(reference_setting_));
    record.reference_error = measure_error(second.image, reference_.image);
    record.reference_error.rms /= 2; // of one of two halves, by sqrt 2; of their mean, by sqrt 2 again
    record.reference_error.levels /= 2;
    std::ranges::transform(reference_.image.rgb, second.image.rgb, reference_.image.rgb.begin(),
                           [](float a, float b) { return 0.5f * (a + b); });
    record.reference = option_text(reference_setting_, pilot_.asked());
    measure(alone());
    std::vector<QualitySetting> combinations = promising();
    while (!combinations.empty()) { // a few at a time, the most promising of all parts of the front first
        const size_t count = std::min<size_t>(combinations.size(), 6);
        if (watch_.milliseconds() > options_.budget * 900) {
            left_out_ = combinations.size();
            break;
        }
        measure({combinations.begin(), combinations.begin() + ptrdiff_t(count)});
        combinations.erase(combinations.begin(), combinations.begin() + ptrdiff_t(count));
    }
    for (const QualityOptions& aspect : space_)
        record.aspects.push_back({name_of(aspect.aspect), aspect.reason, aspect.settings.size()});
    for (const Measured& measured : measured_)
        record.points.push_back(measured.point);
    record.left_out = left_out_;
    record.pilot_width = pilot_.width();
    record.pilot_height = pilot_.height();
}

/// Settings of one scene after the other, so that each scene goes to the device once.
void TradeoffMeasurement::measure(std::vector<QualitySetting> settings) {
    while (!settings.empty()) {
        const QualitySetting first = settings.front();
        const auto rest = std::stable_partition(settings.begin(), settings.end(), [&](const QualitySetting& setting) {
            return shares_scene(setting, first);
        });
        measure_group({settings.begin(), rest});
        settings.erase(settings.begin(), rest);
    }
}

/// The repeats of a setting lie apart, so that what disturbs the machine for a while disturbs all settings alike.
void TradeoffMeasurement::measure_group(const std::vector<QualitySetting>& settings) {
    say_(fmt::format("{} settings, {} times each", settings.size(), options_.repeats));
    QualitySetting warm = settings.front();
    warm.samples = 1;
    warm.antialiasing = {};
    pilot_.render_first(warm);
    const size_t first = measured_.size();
    for (const QualitySetting& setting : settings)
        measured_.push_back(
            {.point = {.setting = setting, .options = option_text(setting, pilot_.asked())}, .image = {}});
    std::vector<std::vector<double>> whole(settings.size()); // what repeats say of the whole picture
    const double growth =
        double(options_.frame.width) * options_.frame.height / (double(pilot_.width()) * pilot_.height());
    for (uint32_t repeat = 0; repeat < options_.repeats; ++repeat)
        for (size_t i = 0; i < settings.size(); ++i) {
            PilotPicture picture = pilot_.render_first(settings[i]);
            TradeoffPoint& point = measured_[first + i].point;
            point.repeats.push_back(picture.ms);
            whole[i].push_back(picture.build_ms + (picture.ms - picture.build_ms) * growth);
            if (repeat > 0)
                continue;
            point.rays =
                double(picture.camera_rays) / (double(pilot_.width()) * pilot_.height()) / settings[i].shutter_samples;
            point.error = measure_error(picture.image, reference_.image);
            measured_[first + i].image = std::move(picture.image);
        }
    for (size_t i = 0; i < settings.size(); ++i) {
        TradeoffPoint& point = measured_[first + i].point;
        point.pilot_ms = median(point.repeats);
        point.ms = median(whole[i]);
        say_(fmt::format("{:10.2f} ms {:8.3f}/255  {}", point.ms, point.error.levels, point.options));
    }
}

const TradeoffMeasurement::Measured* TradeoffMeasurement::find(const QualitySetting& setting) const {
    const auto found =
        std::ranges::find_if(measured_, [&](const Measured& measured) { return measured.point.setting == setting; });
    return found == measured_.end() ? nullptr : &*found;
}

const Image& TradeoffMeasurement::picture(const QualitySetting& setting) const {
    return find(setting)->image;
}

/// Combinations that would be on the front if errors added up by their squares and times were multiplied: those not
/// measured yet, spread over the whole front.
std::vector<QualitySetting> TradeoffMeasurement::promising() const {
    struct Prediction {
        QualitySetting setting;
        PictureError error;
        double ms;
    };
    const Measured& base_point = *find(base());
    std::vector<Prediction> predictions;
    for (const QualitySetting& sampling : space_[0].settings) {
        QualitySetting setting = base();
        take(QualityAspect::sampling, sampling, setting);
        if (const Measured* measured = find(setting))
            predictions.push_back({setting, measured->point.error, measured->point.ms});
    }
    for (size_t aspect = 1; aspect < quality_aspects; ++aspect) {
        const std::vector<QualitySetting>& options = space_[aspect].settings;
        std::vector<Prediction> longer;
        double factor = 0; // a cheaper option that seems slower than a more accurate one is noise
        for (size_t i = options.size(); i-- > 0;) {
            QualitySetting alone = base();
            take(QualityAspect(aspect), options[i], alone);
            const Measured& measured = *find(alone);
            const PictureError change = measure_error(measured.image, base_point.image);
            factor = std::max(factor, measured.point.ms / base_point.point.ms);
            for (Prediction prediction : predictions) {
                take(QualityAspect(aspect), options[i], prediction.setting);
                prediction.error = combine(prediction.error, {change});
                prediction.ms *= factor;
                longer.push_back(std::move(prediction));
            }
        }
        predictions = std::move(longer);
    }
    std::ranges::stable_sort(predictions, {}, &Prediction::ms);
    std::vector<QualitySetting> front;
    double best = 1e300;
    for (const Prediction& prediction : predictions)
        if (prediction.error.levels < best) {
            best = prediction.error.levels;
            if (!find(prediction.setting))
                front.push_back(prediction.setting);
        }
    std::vector<QualitySetting> spread; // first every eighth, then every fourth, ...
    for (size_t step = 8; step > 0; step /= 2)
        for (size_t i = 0; i < front.size() && spread.size() < most_combinations; i += step)
            if (std::ranges::find(spread, front[i]) == spread.end())
                spread.push_back(front[i]);
    return spread;
}

} // namespace proxima
