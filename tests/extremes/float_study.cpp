// SPDX-License-Identifier: Apache-2.0
// Usage: float_study [SCENES [SEED]]: how far float moves what random scenes show, against what float_fit estimates.
// The first half of them is what the estimate is scaled by; how often it errs is counted in the second half.
#include "tests/extremes/random_views.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <vector>

using namespace proxima;
using namespace proxima::testing;

namespace {

void report(const char* name, const std::vector<FloatTrial>& trials) {
    if (trials.empty())
        return;
    std::vector<double> ratios;
    uint64_t exceeded = 0, in_float = 0, unsafe = 0, wrong = 0, needless = 0;
    for (const FloatTrial& trial : trials) {
        const bool is_good = trial.measured <= FloatFit::most_pixels;
        ratios.push_back(trial.measured / trial.fit.pixels);
        exceeded += trial.measured > trial.fit.pixels;
        in_float += trial.fit.holds();
        unsafe += trial.fit.holds() && !is_good;
        wrong += trial.fit.holds() && trial.wrong > 0;
        needless += !trial.fit.holds() && is_good;
    }
    std::ranges::sort(ratios);
    const auto quantile = [&](double share) { return ratios[size_t(share * double(ratios.size() - 1))]; };
    fmt::print("{}: {} scenes; measured over estimated: median {:.2g}, 90 % {:.2g}, 99 % {:.2g}, most {:.2g}\n"
               "  {} exceed the estimate; {} are for float, of which {} move by more than 1/256 pixel and {} have a "
               "wrong hit;\n  {} are for double, of which {} would not move by more\n",
               name, trials.size(), quantile(0.5), quantile(0.9), quantile(0.99), ratios.back(), exceeded, in_float,
               unsafe, wrong, trials.size() - in_float, needless);
}

} // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
    const uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    fmt::print("seed {}\n", seed);
    std::mt19937_64 engine(seed);
    std::vector<FloatTrial> halves[2];
    for (int i = 0; i < count; ++i)
        if (const FloatTrial trial = try_float(random_view(engine)); trial.measured > 0)
            halves[i >= count / 2].push_back(trial);
    report("scaled by", halves[0]);
    report("tested", halves[1]);
}
