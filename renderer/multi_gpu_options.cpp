// SPDX-License-Identifier: Apache-2.0
#include "renderer/multi_gpu_options.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"

namespace proxima {

void add_multi_gpu_options(CLI::App& command, MultiGpuTexts& texts) {
    command
        .add_option("--multi-gpu", texts.multi_gpu,
                    "How several devices share the work: frames, tiles (of each frame), relay (the first builds what "
                    "the others trace) [auto: frames if there are enough of them, else tiles]")
        ->type_name("MODE");
    // For tests and measurements; --help is for those who render.
    constexpr const char* hidden = "";
    command.add_option("--in-flight", texts.in_flight)->group(hidden);
    command.add_option("--tile-rows", texts.tile_rows)->group(hidden);
    command.add_option("--inject", texts.inject)->group(hidden);
    command.add_flag("--discard", texts.discard)->group(hidden);
}

MultiGpuOptions read_multi_gpu_options(const MultiGpuTexts& texts, const DeviceChoice& device) {
    MultiGpuOptions options;
    options.mode = parse_choice<MultiGpu>("--multi-gpu", texts.multi_gpu,
                                          {{"auto", MultiGpu::automatic},
                                           {"frames", MultiGpu::frames},
                                           {"tiles", MultiGpu::tiles},
                                           {"relay", MultiGpu::relay}});
    if (options.mode == MultiGpu::relay && !device.is_automatic() && !device.is_several())
        throw UsageError("--multi-gpu relay: one device builds for the others; give --device at least two");
    if (!texts.in_flight.empty())
        options.in_flight = parse_count("--in-flight", texts.in_flight, 1, 16);
    if (!texts.tile_rows.empty()) {
        options.tile_rows = parse_count("--tile-rows", texts.tile_rows, 1, 65536);
        if (options.tile_rows % Rows::unit != 0)
            throw UsageError(fmt::format("--tile-rows {}: give a multiple of {}", options.tile_rows, Rows::unit));
    }
    options.discard = texts.discard;
    options.faults = parse_faults(texts.inject);
    return options;
}

} // namespace proxima
