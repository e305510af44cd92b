// SPDX-License-Identifier: Apache-2.0
// What was counted and what was timed of each way to render each scene, as a table that a file holds.
#pragma once
#include "renderer/frame_cost.h"

#include <filesystem>
#include <string>
#include <vector>

namespace proxima::bench {

struct ChoiceRow {
    std::string set; ///< "fit" or "test"
    std::string scene;
    bool has_cloud = false;
    double density = 0; ///< voxels a primitive
    FrameWork work;
    FrameCost timed, predicted;
};

/// Frames of a scene for which the renderer chose itself.
struct AutoRow {
    std::string scene;
    bool has_cloud = false;
    double density = 0;   ///< of the last frame's choice
    double frame_ms = 0;  ///< median of build, cloud and trace
    double choose_ms = 0; ///< of all frames, over PlanChooser::interval
};

struct ChoiceTable {
    std::vector<ChoiceRow> rows;
    std::vector<AutoRow> automatic;
};

/// Tab-separated, with a line of names.
void write_table(const std::filesystem::path& path, const ChoiceTable& table);
ChoiceTable read_table(const std::filesystem::path& path);

/// The coefficients that make the least relative errors on rows of one method; none is negative.
WorkCosts fit_costs(const std::vector<ChoiceRow>& rows, bool has_cloud, bool goes_together);

} // namespace proxima::bench
