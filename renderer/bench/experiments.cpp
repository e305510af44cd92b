// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/experiments.h"

namespace proxima {

FrameSettings bench_frame(const BenchOptions& options, Accelerator accelerator) {
    FrameSettings frame;
    frame.width = options.width ? options.width : options.full ? 1920 : 320;
    frame.height = options.height ? options.height : options.full ? 1080 : 180;
    frame.accelerator = accelerator;
    return frame;
}

BenchRow bench_row(const BenchOptions& options, const std::string& method, uint32_t grid, uint32_t brick) {
    BenchRow row;
    row.method = method;
    row.frame = bench_frame(options, method.ends_with("cloud")  ? Accelerator::cloud
                                     : method.ends_with("grid") ? Accelerator::grid
                                     : method == "brute"        ? Accelerator::brute
                                                                : Accelerator::automatic);
    row.frame.grid = {grid, grid, grid};
    row.frame.brick = brick;
    if (row.is_paper())
        row.frame.metric = Metric::city_block;
    return row;
}

ChartSeries curve(const std::vector<BenchRow>& rows, const std::string& name, size_t color,
                  const std::function<bool(const BenchRow&)>& wanted,
                  const std::function<double(const BenchRow&)>& value) {
    ChartSeries series{.name = name, .points = {}, .color = color};
    for (const BenchRow& row : rows)
        if (row.failure.empty() && wanted(row) && value(row) > 0)
            series.points.emplace_back(double(row.spheres), value(row));
    return series;
}

} // namespace proxima
