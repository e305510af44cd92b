// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/choose_quality.h"
#include "renderer/errors.h"
#include "renderer/timing.h"
#include "renderer/tradeoff/quality_pilot.h"
#include "renderer/tradeoff/quality_space.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tuple>

namespace proxima {
namespace {

constexpr uint32_t pilot_side = 160; // pixels

std::vector<int64_t> pilot_frames(const Animation& animation) {
    if (animation.is_still)
        return animation.frames;
    std::vector<int64_t> frames{animation.initial_frame, animation.middle_frame, animation.final_frame};
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

/// One way to choose: an option for each aspect.
struct Candidate {
    std::array<size_t, quality_aspects> options{};
    QualitySetting setting;
    double rays = 0; ///< see most_rays
};

class QualitySearch {
public:
    QualitySearch(QualityPilot& pilot, const QualityRequest& request)
        : pilot_(pilot), limit_(request.limit), scene_(pilot.program()), space_(quality_space(scene_, pilot.asked())),
          reference_(pilot.render(reference_quality(scene_, pilot.asked()))) {
        if (request.keeps_sampling)
            options(QualityAspect::sampling) = {pilot.asked()};
        if (request.keeps_precision)
            options(QualityAspect::precision) = {pilot.asked()};
        choose_precision();
        drop_what_costs_too_much_alone();
    }

    /// The first in order that keeps the limit; else the most accurate one that was looked at, which does not.
    std::pair<QualitySetting, PictureError> run() {
        if (options(QualityAspect::sampling).size() > 1)
            sampling_figures_.emplace_back(base().samples, limit_.figure(worst_error(sampled(base()), reference_)));
        std::pair<QualitySetting, PictureError> best{pilot_.asked(), {}};
        bool has_best = false;
        for (const Candidate& candidate : candidates()) {
            if (!promises(candidate))
                continue;
            const PictureError error = error_of(candidate.setting);
            if (limit_.holds(error))
                return {candidate.setting, error};
            if (!has_best || limit_.figure(error) < limit_.figure(best.second))
                best = {candidate.setting, error};
            has_best = true;
        }
        if (!has_best) {
            Candidate finest; // the first option of every aspect
            finest.setting = setting_of(finest.options);
            best = {finest.setting, error_of(finest.setting)};
        }
        return best;
    }

private:
    std::vector<QualitySetting>& options(QualityAspect aspect) { return space_[size_t(aspect)].settings; }

    QualitySetting setting_of(const std::array<size_t, quality_aspects>& choice) const {
        QualitySetting setting = pilot_.asked();
        for (size_t aspect = 0; aspect < quality_aspects; ++aspect)
            take(QualityAspect(aspect), space_[aspect].settings[choice[aspect]], setting);
        return setting;
    }

    QualitySetting base() {
        QualitySetting base = pilot_.asked();
        base.samples = 4;
        base.antialiasing = {};
        base.precision = options(QualityAspect::precision).front().precision;
        return base;
    }

    /// Float alone, where it changes next to nothing: then nothing needs to be rendered in double to find the rest.
    void choose_precision() {
        std::vector<QualitySetting>& precisions = options(QualityAspect::precision);
        if (precisions.size() == 1)
            return;
        QualitySetting setting = base();
        const std::vector<PilotPicture> exact = pilot_.render(setting);
        take(QualityAspect::precision, precisions.back(), setting);
        if (4 * limit_.figure(worst_error(pilot_.render(setting), exact)) <= limit_.most)
            precisions = {precisions.back()};
    }

    /// What each option changes alone, at few samples: those that change more than is allowed are left out.
    void drop_what_costs_too_much_alone() {
        const QualitySetting whole_setting = base();
        const std::vector<PilotPicture> whole = pilot_.render(whole_setting);
        for (size_t aspect = 1; aspect < quality_aspects; ++aspect) {
            std::vector<QualitySetting> kept;
            for (const QualitySetting& option : space_[aspect].settings) {
                QualitySetting setting = whole_setting;
                take(QualityAspect(aspect), option, setting);
                const PictureError change = kept.empty() ? PictureError{} : worst_error(pilot_.render(setting), whole);
                if (!limit_.holds(change))
                    break; // and so will the cheaper ones
                kept.push_back(option);
                changes_[aspect].push_back(change);
            }
            space_[aspect].settings = std::move(kept);
        }
    }

    /// All, in the order in which they are tried.
    std::vector<Candidate> candidates() {
        std::vector<Candidate> all(1);
        for (size_t aspect = 0; aspect < quality_aspects; ++aspect) {
            std::vector<Candidate> longer;
            for (const Candidate& candidate : all)
                for (size_t option = 0; option < space_[aspect].settings.size(); ++option) {
                    longer.push_back(candidate);
                    longer.back().options[aspect] = option;
                }
            all = std::move(longer);
        }
        for (Candidate& candidate : all) {
            candidate.setting = setting_of(candidate.options);
            candidate.rays = most_rays(scene_, candidate.setting, rays_a_pixel(candidate.setting));
        }
        // Of equal ones, first those that end paths early.
        std::ranges::stable_sort(all, {}, [](const Candidate& candidate) {
            return std::tuple(candidate.rays, -candidate.setting.overrides.adc_bailout.value_or(0.0f));
        });
        return all;
    }

    double rays_a_pixel(const QualitySetting& setting) {
        const auto method = setting.antialiasing.method;
        if (method == Antialiasing::Method::none || method == Antialiasing::Method::grid)
            return rays_of(setting);
        QualitySetting alone = pilot_.asked();
        take(QualityAspect::sampling, setting, alone);
        uint64_t rays = 0;
        for (const PilotPicture& picture : sampled(alone))
            rays += picture.camera_rays;
        const double pixels = double(pilot_.width()) * pilot_.height() * double(pilot_.frames().size());
        return double(rays) / pixels / alone.shutter_samples;
    }

    /// Whether a candidate is worth a look: what its parts do alone, added up, is within the limit.
    bool promises(const Candidate& candidate) {
        QualitySetting alone = pilot_.asked();
        take(QualityAspect::sampling, candidate.setting, alone);
        std::vector<PictureError> changes;
        for (size_t aspect = 1; aspect < quality_aspects; ++aspect)
            changes.push_back(changes_[aspect][candidate.options[aspect]]);
        if (is_hopeless(alone))
            return false;
        const PictureError sampling = worst_error(sampled(alone), reference_);
        if (alone.antialiasing.method == Antialiasing::Method::none)
            sampling_figures_.emplace_back(alone.samples, limit_.figure(sampling));
        return limit_.holds(combine(sampling, changes));
    }

    /// Samples in a regular sequence: the error falls with their number, but no faster than that grows.
    bool is_hopeless(const QualitySetting& setting) const {
        if (setting.antialiasing.method != Antialiasing::Method::none)
            return false;
        return std::ranges::any_of(sampling_figures_, [&](const auto& known) {
            const auto [samples, figure] = known;
            return samples > 1 && figure * std::min(1.0, double(samples) / setting.samples) > limit_.most;
        });
    }

    PictureError error_of(const QualitySetting& setting) {
        for (const auto& [known, pictures] : sampled_)
            if (known == setting)
                return worst_error(pictures, reference_);
        return worst_error(pilot_.render(setting), reference_);
    }

    /// Pictures in the most accurate precision with all but the sampling as asked; each is made once.
    const std::vector<PilotPicture>& sampled(QualitySetting setting) {
        setting.precision = options(QualityAspect::precision).front().precision;
        for (const auto& [known, pictures] : sampled_)
            if (known == setting)
                return pictures;
        return sampled_.emplace_back(setting, pilot_.render(setting)).second;
    }

    QualityPilot& pilot_;
    const ErrorLimit limit_;
    const SceneProgram scene_;
    std::array<QualityOptions, quality_aspects> space_;
    std::vector<PilotPicture> reference_;
    std::array<std::vector<PictureError>, quality_aspects> changes_;
    std::vector<std::pair<uint32_t, double>> sampling_figures_; ///< number of samples, error of a plain sequence
    std::vector<std::pair<QualitySetting, std::vector<PilotPicture>>> sampled_;
};

} // namespace

QualityChoice choose_quality(const SceneOptions& scene, const FrameSettings& frame, const QualityRequest& request,
                             unsigned threads, const StopSignal& stop) {
    if (scene.scene == "-")
        throw UsageError("-: --max-error reads the scene more than once, and standard input can be read once; save "
                         "the scene in a file");
    const Stopwatch watch;
    const auto renderer = make_cpu_renderer(threads);
    QualityPilot pilot(scene, frame, pilot_frames(scene.animation), *renderer, stop);
    pilot.resize(pilot_side);
    const auto [setting, error] = QualitySearch(pilot, request).run();
    QualityChoice choice{.setting = setting, .options = option_text(setting, pilot.asked()), .predicted = error};
    choice.pilot = fmt::format("{}x{}", pilot.width(), pilot.height());
    if (!scene.animation.is_still)
        choice.pilot += fmt::format(", frames {}", fmt::join(pilot.frames(), ", "));
    choice.ms = watch.milliseconds();
    if (!request.limit.holds(error))
        throw UsageError(
            fmt::format("--max-error {}: no setting keeps it in a picture of {}; the nearest is {} with {}",
                        request.text, choice.pilot, choice.options, error_text(request.limit, error)));
    return choice;
}

void measure_choice(QualityChoice& choice, const SceneOptions& scene, const FrameSettings& asked, int64_t frame,
                    FrameRenderer& renderer, const StopSignal& stop) {
    QualityPilot pilot(scene, asked, {frame}, renderer, stop);
    const auto picture = pilot.render(choice.setting);
    const auto reference = pilot.render(reference_quality(pilot.program(), pilot.asked()));
    choice.measured = worst_error(picture, reference);
    choice.measured_frame = frame;
}

std::string error_text(const ErrorLimit& limit, const PictureError& error) {
    return limit.is_levels ? fmt::format("{:.3g}/255", error.levels) : fmt::format("{:.3g}", error.rms);
}

} // namespace proxima
