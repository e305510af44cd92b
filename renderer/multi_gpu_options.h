// SPDX-License-Identifier: Apache-2.0
// Options that say how several devices share the work.
#pragma once
#include "renderer/options.h"

#include <CLI/CLI.hpp>
#include <string>

namespace proxima {

/// As the user wrote them; empty where absent.
struct MultiGpuTexts {
    std::string multi_gpu = "auto", in_flight, tile_rows, inject;
    bool discard = false;
};

void add_multi_gpu_options(CLI::App& command, MultiGpuTexts& texts);
/// Throws UsageError.
MultiGpuOptions read_multi_gpu_options(const MultiGpuTexts& texts, const DeviceChoice& device);

} // namespace proxima
