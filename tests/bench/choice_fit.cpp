// SPDX-License-Identifier: Apache-2.0
// Least squares without negative coefficients, one coefficient after the other until they rest: the sums are convex.
#include "tests/bench/choice_table.h"

namespace proxima::bench {
namespace {

/// One equation: units of work, and the milliseconds that they took. Each is divided by its time, so that errors are
/// relative.
struct Equation {
    std::vector<double> units;
    double ms;
};

std::vector<double> fit(const std::vector<Equation>& equations) {
    const size_t count = equations.front().units.size();
    std::vector<double> solution(count, 0.0);
    for (int round = 0; round < 20000; ++round)
        for (size_t i = 0; i < count; ++i) {
            double slope = 0, square = 0;
            for (const Equation& equation : equations) {
                double rest = 1;
                for (size_t k = 0; k < count; ++k)
                    rest -= k == i ? 0 : solution[k] * equation.units[k] / equation.ms;
                slope += rest * equation.units[i] / equation.ms;
                square += equation.units[i] / equation.ms * (equation.units[i] / equation.ms);
            }
            solution[i] = square > 0 ? std::max(0.0, slope / square) : 0.0;
        }
    return solution;
}

} // namespace

DeviceCosts fit_costs(const std::vector<ChoiceRow>& rows, double shared) {
    constexpr double ns = 1e-6;
    DeviceCosts costs;
    for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud}) {
        MethodCosts& of = costs.of[method];
        of.shared = method == SearchMethod::grid ? shared : 0;
        std::vector<Equation> builds, maps, traces;
        for (const ChoiceRow& row : rows) {
            if (row.set != "fit")
                continue;
            const auto& [work, build, map, trace, frame] = row.of[method];
            builds.push_back({{1, ns * work.primitives, ns * work.references, ns * work.voxels}, build});
            if (map > 0)
                maps.push_back({{1, ns * work.bricks}, map});
            MethodCosts lookup{.lookup = 1, .shared = of.shared};
            traces.push_back({{ns * work.rays, lookup.trace(work)}, trace});
        }
        const std::vector<double> b = fit(builds), t = fit(traces);
        of.build_ms = b[0], of.primitive = b[1], of.reference = b[2], of.voxel = b[3];
        of.ray = t[0], of.lookup = t[1];
        if (maps.empty())
            continue;
        const std::vector<double> m = fit(maps);
        of.map_ms = m[0], of.brick = m[1];
    }
    return costs;
}

} // namespace proxima::bench
