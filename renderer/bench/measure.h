// SPDX-License-Identifier: Apache-2.0
// Rows of a table to measure in, the same rows with what they took out: medians over frames in which everything moves
// and is built anew.
#pragma once
#include "renderer/bench/bench_scenes.h"
#include "renderer/device_choice.h"
#include "renderer/frame_renderer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace proxima {

/// A device of an experiment, and what renders on it: our way and the seed paper's.
struct BenchDevice {
    std::string name; ///< "cpu", "cuda:0"
    std::function<std::unique_ptr<FrameRenderer>()> make, make_paper;
};

/// The devices that `choice` means; by default the first CUDA device, or else the CPU, or `both`. Throws UsageError.
std::vector<BenchDevice> bench_devices(const DeviceChoice& choice, unsigned threads, bool both);

struct BenchRow {
    // What is measured.
    std::string experiment; ///< "figure 2"
    std::string scene;
    uint64_t spheres = 0;
    size_t device = 0;  ///< of the devices that are measured
    std::string method; ///< "brute", "grid", "cloud", "auto", "paper-grid", "paper-cloud"
    FrameSettings frame;
    bool candidate = false; ///< a resolution among others, of which the best is wanted
    bool counts_lookups = true;

    // What it took.
    bool best = false; ///< the candidate whose frame took least
    std::string failure;
    std::string device_name;
    std::string used; ///< "brute", "grid" or "cloud": what `auto` chose
    std::array<uint32_t, 3> grid{0, 0, 0};
    uint32_t brick = 0; ///< 0 without a cloud
    uint32_t frames = 0;
    double motion_ms = 0, build_ms = 0, map_ms = 0, trace_ms = 0, frame_ms = 0;
    std::optional<double> lookups; ///< voxels and bricks that a camera ray looks up, of those that enter the grid
    uint64_t references = 0, device_bytes = 0;
    uint64_t picture = 0; ///< a hash

    bool is_paper() const { return method.starts_with("paper"); }
};

struct MeasureLimits {
    uint32_t repeats = 5;
    double seconds = 0.5; ///< for a row: when they are over, no more frames are begun
};

/// Fills in every row; one that does not fit into memory gets a `failure`. Tells of each on standard error.
/// Throws FileError, SceneRejected, DeviceError, Interrupted.
void measure(std::vector<BenchRow>& rows, const std::vector<BenchDevice>& devices, BenchScenes& scenes,
             const MeasureLimits& limits);

/// Among the candidates that differ in their resolution alone, the best one gets its mark.
void mark_best(std::vector<BenchRow>& rows);

/// The rows whose picture is not that of the first row of the same scene on the same device.
std::vector<const BenchRow*> different_pictures(const std::vector<BenchRow>& rows);

} // namespace proxima
