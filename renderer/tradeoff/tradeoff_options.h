// SPDX-License-Identifier: Apache-2.0
// The command line of `proxima tradeoff`.
#pragma once
#include "renderer/shared_options.h"

namespace proxima {

struct TradeoffTexts {
    SceneTexts scene;
    DeviceTexts device;
    std::string tolerances = "exact", output, budget = "60", repeats = "3";
    bool quiet = false;
};

CLI::App* add_tradeoff(CLI::App& app, TradeoffTexts& texts);

/// `command` is what it made; takes a POV-Ray .ini's texts over. Throws UsageError and FileError.
TradeoffOptions read_tradeoff_options(const CLI::App& command, TradeoffTexts& texts);

} // namespace proxima
