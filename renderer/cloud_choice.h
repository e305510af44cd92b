// SPDX-License-Identifier: Apache-2.0
// Whether a scene is worth a cloud. How far apart things are goes in, frame by frame; the choice comes out.
#pragma once
#include <cstdint>

namespace proxima {

/// A cloud costs its distances and a finer grid, and saves steps where they are long: the mean distance over its empty
/// bricks tells the two apart (Cohen and Sheffer's own measure; the bounds are from tests/bench/NOTES.md). It is only
/// looked at now and then, since a scene changes slowly and looking takes the building of a cloud; between the two
/// bounds everything stays as it was.
class CloudChoice {
public:
    /// `fewest`: primitives below which a device gains nothing by a cloud.
    explicit CloudChoice(uint32_t fewest) : fewest_(fewest) {}

    /// To be asked once a frame: whether this frame should be built with a cloud and its distance reported.
    bool is_due(uint32_t primitives) {
        if (primitives < fewest_) {
            cloud_ = false;
            frames_left_ = 0;
            return false;
        }
        if (frames_left_ == 0) {
            frames_left_ = interval;
            return true;
        }
        --frames_left_;
        return false;
    }
    void report(double mean_distance) {
        if (mean_distance >= worth)
            cloud_ = true;
        else if (mean_distance < not_worth)
            cloud_ = false;
    }
    bool uses_cloud() const { return cloud_; }

    static constexpr uint32_t interval = 63; ///< frames between two looks
    static constexpr double worth = 4.0, not_worth = 3.0;

private:
    uint32_t fewest_;
    uint32_t frames_left_ = 0;
    bool cloud_ = false;
};

} // namespace proxima
