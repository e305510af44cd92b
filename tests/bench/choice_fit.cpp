// SPDX-License-Identifier: Apache-2.0
// Least squares without negative coefficients, by leaving out what would be negative (Lawson and Hanson, "Solving Least
// Squares Problems", 1974, have a better way; with four unknowns this one does).
#include "tests/bench/choice_table.h"

#include <cmath>

namespace proxima::bench {
namespace {

/// One equation: units of work, and the milliseconds that they took.
struct Equation {
    std::vector<double> units;
    double ms;
};

/// Solves the normal equations of what is in use by elimination with pivots.
std::vector<double> solve(const std::vector<Equation>& equations, const std::vector<bool>& used) {
    const size_t n = used.size();
    std::vector<std::vector<double>> a(n, std::vector<double>(n + 1, 0.0));
    for (const Equation& equation : equations)
        for (size_t i = 0; i < n; ++i) {
            // Each is divided by its time: errors are relative. A unit's size does not matter then, but for rounding.
            const double x = equation.units[i] / equation.ms;
            for (size_t k = 0; k < n; ++k)
                a[i][k] += x * equation.units[k] / equation.ms;
            a[i][n] += x;
        }
    for (size_t i = 0; i < n; ++i)
        if (!used[i] || a[i][i] == 0)
            for (size_t k = 0; k <= n; ++k)
                a[i][k] = k == i ? 1.0 : 0.0;
    for (size_t i = 0; i < n; ++i)
        for (size_t k = 0; k < n; ++k)
            if (k != i && !used[k])
                a[i][k] = 0;
    for (size_t i = 0; i < n; ++i) {
        size_t pivot = i;
        for (size_t k = i + 1; k < n; ++k)
            if (std::abs(a[k][i]) > std::abs(a[pivot][i]))
                pivot = k;
        std::swap(a[i], a[pivot]);
        for (size_t k = 0; k < n; ++k)
            if (k != i) {
                const double factor = a[k][i] / a[i][i];
                for (size_t j = i; j <= n; ++j)
                    a[k][j] -= factor * a[i][j];
            }
    }
    std::vector<double> x(n);
    for (size_t i = 0; i < n; ++i)
        x[i] = a[i][n] / a[i][i];
    return x;
}

std::vector<double> fit(const std::vector<Equation>& equations) {
    std::vector<bool> used(equations.front().units.size(), true);
    for (;;) {
        std::vector<double> x = solve(equations, used);
        size_t least = 0;
        for (size_t i = 0; i < x.size(); ++i)
            if (x[i] < x[least])
                least = i;
        if (x[least] >= 0)
            return x;
        used[least] = false;
    }
}

} // namespace

WorkCosts fit_costs(const std::vector<ChoiceRow>& rows, bool has_cloud, bool goes_together) {
    constexpr double ns = 1e-6;
    std::vector<Equation> builds, maps, traces;
    for (const ChoiceRow& row : rows) {
        if (row.has_cloud != has_cloud)
            continue;
        const FrameWork& work = row.work;
        const FrameWork::Walk& walk = goes_together ? work.together : work.mean;
        builds.push_back(
            {{ns, ns * work.primitives, ns * work.cells, ns * work.links, ns * work.bricks}, row.timed.build});
        if (has_cloud)
            maps.push_back({{ns, ns * work.bricks, ns * work.distances}, row.timed.map});
        traces.push_back(
            {{ns, ns * work.pixels, ns * work.pixels * walk.lookups, ns * work.pixels * walk.tests}, row.timed.trace});
    }
    const std::vector<double> b = fit(builds), m = has_cloud ? fit(maps) : std::vector<double>(3), t = fit(traces);
    WorkCosts costs;
    costs.build_fixed = b[0], costs.primitive = b[1], costs.cell = b[2], costs.link = b[3], costs.mark = b[4];
    costs.map_fixed = m[0], costs.brick = m[1], costs.distance = m[2];
    costs.trace_fixed = t[0], costs.pixel = t[1], costs.lookup = t[2], costs.test = t[3];
    costs.goes_together = goes_together;
    return costs;
}

} // namespace proxima::bench
