// SPDX-License-Identifier: Apache-2.0
// The experiments of `proxima bench`: what each of them measures, and what it makes of that.
#pragma once
#include "renderer/bench/bench_table.h"
#include "renderer/options.h"

#include <functional>

namespace proxima {

/// The figures of R. Thomas and S. K. Semwal, "Ray Tracing using 3D Grid Simulations", 2014.
std::vector<BenchRow> seed_rows(const BenchOptions& options, size_t devices);
void conclude_seed(BenchReport& report, BenchScenes& scenes);

/// Scenes from full to empty, with one number of spheres.
std::vector<BenchRow> sparse_rows(const BenchOptions& options, size_t devices);
void conclude_sparse(BenchReport& report, BenchScenes& scenes);

/// Scenes from small to large, and maps.
std::vector<BenchRow> scale_rows(const BenchOptions& options, size_t devices);
void conclude_scale(BenchReport& report, BenchScenes& scenes);

/// The settings that all experiments share.
FrameSettings bench_frame(const BenchOptions& options, Accelerator accelerator);
/// A row for each of the methods "brute", "grid", "cloud", "auto", "paper-grid" and "paper-cloud" that is named. `grid`
/// is voxels along each axis, `brick` those of a brick of the cloud; 0: by the renderer's own rule.
BenchRow bench_row(const BenchOptions& options, const std::string& method, uint32_t grid = 0, uint32_t brick = 0);

/// The curve of `value` over the number of spheres, of the rows that are wanted and have one.
ChartSeries curve(const std::vector<BenchRow>& rows, const std::string& name, size_t color,
                  const std::function<bool(const BenchRow&)>& wanted,
                  const std::function<double(const BenchRow&)>& value);

} // namespace proxima
