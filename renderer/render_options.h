// SPDX-License-Identifier: Apache-2.0
// The command line of `proxima render`: how the picture is made here; where it goes and in which colours, see
// output_options.h and color_options.h.
#pragma once
#include "renderer/color_options.h"
#include "renderer/multi_gpu_options.h"
#include "renderer/output_options.h"
#include "renderer/shared_options.h"

namespace proxima {

struct RenderTexts {
    SceneTexts scene;
    DeviceTexts device;
    OutputTexts output;
    ColorTexts color;
    MultiGpuTexts multi_gpu;
    std::string samples = "1", antialias = "none", tolerances = "exact";
    std::string max_error;
    bool verify_error = false;
};

CLI::App* add_render(CLI::App& app, RenderTexts& texts);
/// The same pictures, looked at.
CLI::App* add_verify(CLI::App& app, RenderTexts& texts);

/// `command` is what one of them made; takes a POV-Ray .ini's texts over. Throws UsageError and FileError.
RenderOptions read_render_options(const CLI::App& command, RenderTexts& texts);
VerifyOptions read_verify_options(const CLI::App& command, RenderTexts& texts);

} // namespace proxima
