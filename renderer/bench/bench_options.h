// SPDX-License-Identifier: Apache-2.0
// The options of `proxima bench`: their declaration to CLI11, and their texts in, checked values out.
#pragma once
#include "renderer/options.h"

#include <CLI/CLI.hpp>
#include <string>

namespace proxima {

struct BenchTexts {
    std::string name, output, device = "auto", threads = "0", size, repeats, spheres, scenes;
    bool full = false, json = false;
};

CLI::App* add_bench(CLI::App& app, BenchTexts& texts);

/// Throws UsageError.
BenchOptions read_bench_options(const BenchTexts& texts);

} // namespace proxima
