// SPDX-License-Identifier: Apache-2.0
// Whether frames are made by grid or by cloud: by what a look at the scene predicts, and where that is close, by trying
// both. One for a device; what the frames of all its workers took goes in, the method of the next one comes out.
#pragma once
#include "renderer/frame_renderer.h"
#include "renderer/method_prior.h"

#include <algorithm>
#include <array>
#include <mutex>

namespace proxima {

/// Any member may be called by any thread.
class MethodChoice {
public:
    static constexpr uint32_t look_interval = 64;                        ///< frames
    static constexpr uint64_t first_interval = 64, last_interval = 1024; ///< frames from trial to trial
    static constexpr double clear = 2;         ///< times: predictions that are further apart are taken
    static constexpr double moved = 1.5;       ///< times: by so much they move before what was timed counts no more
    static constexpr double hysteresis = 0.05; ///< a method must be better by so much to take over
    static constexpr double plain = 2;         ///< times: a difference that need not be timed twice
    static constexpr uint32_t timings = 3; ///< of a trial; the least counts, for workers of a device disturb each other
    static constexpr uint32_t settled = 4; ///< timings of the method in use before a trial; the least of the last

    explicit MethodChoice(const DeviceCosts& costs) : costs_(costs) {}

    struct Frame {
        SearchMethod method = SearchMethod::grid;
        bool looks = false; ///< see() is waited for
        uint64_t epoch = 0; ///< of equal settings; never 0 for frames that end() wants to know of
        MethodRecord record;
    };

    /// Begins a frame for which the choice is free. It starts anew when the settings have changed, or the number of
    /// primitives has by much.
    Frame begin(const FrameSettings& settings, uint64_t primitives) {
        const std::lock_guard lock(mutex_);
        if (const FrameSettings key = key_of(settings); epoch_ == 0 || key != key_ || has_changed(primitives)) {
            const uint64_t epoch = epoch_ + 1;
            reset();
            epoch_ = epoch;
            key_ = key;
            primitives_ = primitives;
        }
        Frame frame;
        if (primitives < costs_.fewest) {
            frame.record.reason = MethodReason::few;
            return frame;
        }
        frame.epoch = epoch_;
        frame.looks = !has_looked_ || since_look_ >= look_interval;
        since_look_ = frame.looks ? 1 : since_look_ + 1;
        if (!frame.looks)
            pick(frame);
        return frame;
    }

    /// What the frame that looks has found; says its method.
    void see(Frame& frame, const EmptySpace& space) {
        const std::lock_guard lock(mutex_);
        const OfMethods<double> predicted = predicted_ms(costs_, space, rays_of(key_));
        if (!has_looked_ || distance(ratio_of(predicted), trial_ratio_) > moved) {
            trial_ratio_ = ratio_of(predicted);
            next_trial_ = frames_;
            interval_ = first_interval;
            is_measured_ = is_trying_ = false;
            if (!has_looked_)
                method_ = best_of(predicted);
        }
        has_looked_ = true;
        space_ = space;
        predicted_ = predicted;
        pick(frame);
    }

    /// The frame is done; build, map and trace took so long. The worker `is_warm` when it has made a frame by that
    /// method in this epoch before: the first one makes room in memory.
    void end(const Frame& frame, double milliseconds, bool is_warm) {
        const std::lock_guard lock(mutex_);
        if (frame.epoch != epoch_ || !is_warm)
            return;
        times_[frame.method].add(milliseconds);
        if (!is_trying_ || frame.method == method_ || frame.record.reason != MethodReason::trial)
            return;
        const double least = times_[frame.method].least(), other = times_[method_].least();
        if (++timed_ >= timings || distance(least, other) > plain)
            settle(least<(1 - hysteresis) * other, least> plain * other);
    }

    /// The next frame may show something else: it looks.
    void expect_change() {
        const std::lock_guard lock(mutex_);
        since_look_ = look_interval;
    }

    /// What a frame gets that must not depend on others or on clocks.
    void decide_alone(Frame& frame, const FrameSettings& settings, const EmptySpace& space) const {
        frame.record.reason = space.primitives < costs_.fewest ? MethodReason::few : MethodReason::prior;
        frame.record.space = space;
        frame.record.predicted = predicted_ms(costs_, space, rays_of(settings));
        frame.method = frame.record.reason == MethodReason::few ? SearchMethod::grid : best_of(frame.record.predicted);
    }

    /// Rays of the camera that a whole picture has.
    static double rays_of(const FrameSettings& settings) {
        const double side = settings.antialiasing.depth;
        const bool is_grid = settings.antialiasing.method == Antialiasing::Method::grid;
        return double(settings.width) * settings.height * (is_grid ? side * side + 1 : settings.samples);
    }

private:
    /// The last few.
    struct Times {
        std::array<double, settled> last{};
        uint32_t count = 0;

        void add(double ms) { last[count++ % settled] = ms; }
        double least() const {
            return count > 0 ? *std::min_element(last.begin(), last.begin() + std::min(count, settled)) : 0.0;
        }
    };

    /// What of the settings decides how long frames take.
    static FrameSettings key_of(const FrameSettings& settings) {
        FrameSettings key = settings.with_rows({});
        key.aovs = {};
        key.in_halves = false;
        return key;
    }
    bool has_changed(uint64_t primitives) const {
        return double(primitives) > moved * double(primitives_) || double(primitives) * moved < double(primitives_);
    }
    static SearchMethod best_of(const OfMethods<double>& ms) {
        return ms.cloud < ms.grid ? SearchMethod::cloud : SearchMethod::grid;
    }
    static double ratio_of(const OfMethods<double>& ms) { return ms.cloud / ms.grid; }
    static double distance(double a, double b) { return std::max(a / b, b / a); }

    void pick(Frame& frame) {
        ++frames_;
        if (distance(ratio_of(predicted_), 1) > clear) {
            method_ = best_of(predicted_);
            is_measured_ = is_trying_ = false;
            next_trial_ = frames_;
        } else if (!is_trying_ && frames_ > next_trial_ && times_[method_].count >= settled) {
            is_trying_ = true;
            timed_ = 0;
            times_[other_than(method_)] = {};
        }
        frame.method = is_trying_ ? other_than(method_) : method_;
        frame.record = {.reason = is_trying_     ? MethodReason::trial
                                  : is_measured_ ? MethodReason::measured
                                                 : MethodReason::prior,
                        .space = space_,
                        .predicted = predicted_,
                        .measured = {times_.grid.least(), times_.cloud.least()}};
    }

    /// After a trial that was in vain by far the next one comes later.
    void settle(bool changes, bool in_vain) {
        is_trying_ = false;
        interval_ = changes || !is_measured_ ? first_interval : 2 * interval_;
        interval_ = std::clamp(interval_, in_vain ? 4 * first_interval : first_interval, last_interval);
        is_measured_ = true;
        next_trial_ = frames_ + interval_;
        trial_ratio_ = ratio_of(predicted_);
        if (changes)
            method_ = other_than(method_);
    }

    void reset() {
        has_looked_ = is_measured_ = is_trying_ = false;
        since_look_ = 0;
        frames_ = next_trial_ = 0;
        interval_ = first_interval;
        times_ = {};
    }

    DeviceCosts costs_;
    std::mutex mutex_;
    FrameSettings key_;
    uint64_t epoch_ = 0, primitives_ = 0;
    bool has_looked_ = false;
    uint32_t since_look_ = 0;
    EmptySpace space_;
    OfMethods<double> predicted_;
    double trial_ratio_ = 1; ///< the predicted one at the last trial
    SearchMethod method_ = SearchMethod::grid;
    bool is_measured_ = false; ///< both have been timed
    bool is_trying_ = false;   ///< frames are by the other method, to be timed
    uint32_t timed_ = 0;
    uint64_t frames_ = 0, next_trial_ = 0, interval_ = first_interval;
    OfMethods<Times> times_;
};

} // namespace proxima
