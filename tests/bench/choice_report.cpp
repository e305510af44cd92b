// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/choice_report.h"
#include "renderer/device_costs.h"
#include "renderer/method_choice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>

namespace proxima::bench {
namespace {

const char* name_of(SearchMethod method) {
    return method == SearchMethod::cloud ? "cloud" : "grid";
}

/// Of one set: mean and worst of `loss`, a function of a row.
template <class Loss>
void print_losses(const std::vector<ChoiceRow>& rows, const char* set, const char* what, const Loss& loss) {
    double sum = 0, worst = 0;
    int count = 0;
    for (const ChoiceRow& row : rows)
        if (row.set == set) {
            sum += loss(row);
            worst = std::max(worst, loss(row));
            ++count;
        }
    fmt::print("{:<5}{}: loss {:.2f} % in the mean, {:.1f} % at worst, {} scenes\n", set, what, 100 * sum / count,
               100 * worst, count);
}

void print_costs(const char* name, const MethodCosts& c) {
    fmt::print(".{} = {{.build_ms = {:.3g}, .primitive = {:.3g}, .reference = {:.3g}, .voxel = {:.3g}, .map_ms = "
               "{:.3g}, .brick = {:.3g}, .ray = {:.3g}, .lookup = {:.3g}, .shared = {:g}}}\n",
               name, c.build_ms, c.primitive, c.reference, c.voxel, c.map_ms, c.brick, c.ray, c.lookup, c.shared);
}

/// What `costs` are worth on measured times.
void print_choices(const std::vector<ChoiceRow>& rows, const DeviceCosts& costs, const char* name) {
    fmt::print("{}:\n", name);
    for (const char* set : {"fit", "test"}) {
        double prior = 0, counted = 0;
        int count = 0, wrong = 0, clear_and_wrong = 0;
        for (const ChoiceRow& row : rows)
            if (row.set == set) {
                const OfMethods<double> ms = predicted_ms(costs, row.space, row.of.grid.work.rays);
                const double measured = std::log(row.of.cloud.frame_ms / row.of.grid.frame_ms);
                const double foretold = std::log(ms.cloud / ms.grid);
                const double by_counts =
                    std::log(costs.of.cloud.frame(row.of.cloud.work) / costs.of.grid.frame(row.of.grid.work));
                prior += (foretold - measured) * (foretold - measured);
                counted += (by_counts - measured) * (by_counts - measured);
                wrong += (foretold < 0) != (measured < 0);
                clear_and_wrong +=
                    (foretold < 0) != (measured < 0) && std::abs(foretold) > std::log(MethodChoice::clear);
                ++count;
            }
        fmt::print(
            "{:<5}cloud over grid off by {:.2f} times (rms) from a look, {:.2f} from counts; {} of {} by the wrong "
            "method, {} of them clearly\n",
            set, std::exp(std::sqrt(prior / count)), std::exp(std::sqrt(counted / count)), wrong, count,
            clear_and_wrong);
        print_losses(rows, set, "the prior alone", [&](const ChoiceRow& row) {
            const OfMethods<double> ms = predicted_ms(costs, row.space, row.of.grid.work.rays);
            return (ms.cloud < ms.grid ? row.of.cloud : row.of.grid).frame_ms / row.best_ms() - 1;
        });
        print_losses(rows, set, "120 frames, by reckoning", [&](const ChoiceRow& row) {
            return simulated_ms(costs, row, 0.1 * row.best_ms(), 120) / row.best_ms() - 1;
        });
    }
}

} // namespace

std::string line_of(const ChoiceRow& row) {
    return fmt::format("{:<5}{:<32}{:>10.3f}{:>10.3f}{:>8}{:>8}{:>8g}{:>10.3f}{:>8.1f} %\n", row.set, row.scene,
                       row.of.grid.frame_ms, row.of.cloud.frame_ms, name_of(row.first), name_of(row.last),
                       row.trial_frames, row.auto_ms, 100 * row.loss());
}

void print_rows(const std::vector<ChoiceRow>& rows) {
    fmt::print("{:<5}{:<32}{:>10}{:>10}{:>8}{:>8}{:>8}{:>10}{:>10}\n", "set", "scene", "grid ms", "cloud ms", "first",
               "last", "trials", "auto ms", "loss");
    for (const ChoiceRow& row : rows)
        std::fputs(line_of(row).c_str(), stdout);
    for (const char* set : {"fit", "test"}) {
        print_losses(rows, set, "auto as it ran, all included", [](const ChoiceRow& row) { return row.loss(); });
        print_losses(rows, set, "always the grid",
                     [](const ChoiceRow& row) { return row.of.grid.frame_ms / row.best_ms() - 1; });
        print_losses(rows, set, "always the cloud",
                     [](const ChoiceRow& row) { return row.of.cloud.frame_ms / row.best_ms() - 1; });
    }
}

void print_fit(const std::vector<ChoiceRow>& rows) {
    for (const double shared : {cuda_costs.of.grid.shared, cpu_costs.of.grid.shared}) {
        const DeviceCosts costs = fit_costs(rows, shared);
        print_costs("grid", costs.of.grid);
        print_costs("cloud", costs.of.cloud);
        print_choices(rows, costs, shared > 0 ? "fitted to a CPU" : "fitted to a GPU");
    }
    print_choices(rows, cpu_costs, "cpu_costs as they are");
    print_choices(rows, cuda_costs, "cuda_costs as they are");
}

} // namespace proxima::bench
