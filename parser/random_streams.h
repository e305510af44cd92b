// SPDX-License-Identifier: Apache-2.0
// POV-Ray's random numbers: independent linear congruential generators, named by small numbers.
#pragma once
#include <cstdint>
#include <vector>

namespace proxima {

class RandomStreams {
public:
    /// Starts a stream from a number in the range of int32_t, whose fraction is dropped. Returns the stream's number.
    uint32_t seed(double value) {
        states_.push_back(uint32_t(int32_t(value)));
        return uint32_t(states_.size() - 1);
    }
    bool has(double stream) const { return stream >= 0 && stream < double(states_.size()); }
    /// The next number of a stream, in [0, 1].
    double next(uint32_t stream) {
        states_[stream] = states_[stream] * 1812433253u + 12345u;
        return double(states_[stream]) * (1.0 / 4294967295.0);
    }

private:
    std::vector<uint32_t> states_;
};

} // namespace proxima
