// SPDX-License-Identifier: Apache-2.0
// How long a step took, in milliseconds of wall-clock time.
#pragma once
#include <chrono>

namespace proxima {

class Stopwatch {
public:
    double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Runs `step`, adds its milliseconds to `total`, and passes its result on.
template <class Step> decltype(auto) timed(double& total, Step&& step) {
    struct Adder {
        double& total;
        Stopwatch watch;
        ~Adder() { total += watch.milliseconds(); }
    } adder{total, {}};
    return step();
}

} // namespace proxima
