// SPDX-License-Identifier: Apache-2.0
// The command line of `proxima compare`.
#pragma once
#include "renderer/shared_options.h"

namespace proxima {

struct CompareTexts {
    SceneTexts scene; ///< `scene` is A
    DeviceTexts device{.precision = "double"};
    std::string b, antialias = "none", tolerance, allow = "0", heatmap, report, json, time_limit = "600";
    bool povray = false, linear = false;
};

CLI::App* add_compare(CLI::App& app, CompareTexts& texts);

/// `command` is what add_compare made. Throws UsageError.
CompareOptions read_compare_options(const CLI::App& command, const CompareTexts& texts);

} // namespace proxima
