// SPDX-License-Identifier: Apache-2.0
// What was counted and timed of scenes by grid, by cloud and as the renderer chooses, as a table in a file;
// coefficients fitted on it, and what choices by them lose.
#pragma once
#include "renderer/method_prior.h"

#include <filesystem>
#include <string>
#include <vector>

namespace proxima::bench {

struct ChoiceRow {
    std::string set; ///< "fit" or "test"
    std::string scene;
    EmptySpace space;
    struct Timed {
        MethodWork work;
        double build_ms = 0, map_ms = 0, trace_ms = 0, frame_ms = 0; ///< medians
    };
    OfMethods<Timed> of;
    SearchMethod first = SearchMethod::grid, last = SearchMethod::grid; ///< that were chosen
    double trial_frames = 0;                                            ///< of those that were chosen for
    double auto_ms = 0;                                                 ///< the mean of those, with looks and trials

    double best_ms() const { return std::min(of.grid.frame_ms, of.cloud.frame_ms); }
    double loss() const { return auto_ms / best_ms() - 1; }
};

/// Tab-separated, with a line of names. Throws std::runtime_error.
void write_table(const std::filesystem::path& path, const std::vector<ChoiceRow>& rows);
std::vector<ChoiceRow> read_table(const std::filesystem::path& path);

/// The coefficients that make the least relative errors on rows of the set "fit"; none is negative. `shared`: the
/// grid's, which is not fitted.
DeviceCosts fit_costs(const std::vector<ChoiceRow>& rows, double shared);

/// The mean milliseconds of `frames` frames that MethodChoice chooses for when frames take as long as in `row`, a look
/// takes `look_ms`, and the first frame by a method twice its time.
double simulated_ms(const DeviceCosts& costs, const ChoiceRow& row, double look_ms, int frames);

} // namespace proxima::bench
