// SPDX-License-Identifier: Apache-2.0
// The order of work of `proxima bench`: rows are planned, measured, told, and written.
#include "renderer/atomic_file.h"
#include "renderer/bench/experiments.h"
#include "renderer/commands.h"
#include "renderer/errors.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <tbb/global_control.h>

namespace proxima {
namespace {

namespace fs = std::filesystem;
using Name = BenchOptions::Name;

struct Experiment {
    const char* name;
    std::vector<BenchRow> (*rows)(const BenchOptions&, size_t devices);
    void (*conclude)(BenchReport&, BenchScenes&);
};

Experiment experiment_of(Name name) {
    return name == Name::seed     ? Experiment{"seed", seed_rows, conclude_seed}
           : name == Name::sparse ? Experiment{"sparse", sparse_rows, conclude_sparse}
                                  : Experiment{"scale", scale_rows, conclude_scale};
}

/// Leaves the rows whose scene or experiment is named. Throws UsageError for a name that there is not.
void choose(std::vector<BenchRow>& rows, const std::vector<std::string>& names) {
    std::set<std::string> known;
    for (const BenchRow& row : rows)
        known.insert({row.scene, row.experiment});
    for (const std::string& name : names)
        if (!known.contains(name))
            throw UsageError(fmt::format("--only {}: not one of {}", name, fmt::join(known, ", ")));
    const auto is_named = [&](const BenchRow& row) {
        return std::ranges::any_of(
            names, [&](const std::string& name) { return name == row.scene || name == row.experiment; });
    };
    if (!names.empty())
        std::erase_if(rows, [&](const BenchRow& row) { return !is_named(row); });
}

/// Where the scene files lie: in the folder that was asked for, or in one of their own that goes away.
class SceneFolder {
public:
    explicit SceneFolder(const std::optional<fs::path>& output) : is_temporary_(!output) {
        std::error_code error;
        if (output) {
            folder_ = *output / "scenes";
            fs::create_directories(folder_, error);
            if (error)
                throw FileError(fmt::format("{}: the folder cannot be made: {}", folder_.string(), error.message()));
            return;
        }
        std::string name = (fs::temp_directory_path() / "proxima-bench-XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw FileError(fmt::format("{}: no folder can be made there", fs::temp_directory_path().string()));
        folder_ = name;
    }
    ~SceneFolder() {
        std::error_code ignored;
        if (is_temporary_)
            fs::remove_all(folder_, ignored);
    }
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;

    const fs::path& path() const { return folder_; }

private:
    fs::path folder_;
    bool is_temporary_;
};

void write_text(const fs::path& path, const std::string& text) {
    write_file(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

void write_report(const BenchReport& report, const fs::path& folder) {
    write_text(folder / (report.name + ".txt"), table_text(report));
    write_text(folder / (report.name + ".json"), table_json(report));
    write_text(folder / (report.name + ".csv"), table_csv(report));
    for (const auto& [name, svg] : report.charts)
        write_text(folder / (name + ".svg"), svg);
}

std::vector<std::string> describe(const BenchOptions& options, const std::vector<BenchDevice>& devices,
                                  const MeasureLimits& limits) {
    const FrameSettings frame = bench_frame(options, Accelerator::automatic);
    std::vector<std::string> notes;
    std::string reason;
    std::vector<DeviceDescription> known = list_cuda_devices(reason);
    known.push_back(describe_cpu(options.threads));
    for (const BenchDevice& device : devices)
        for (const DeviceDescription& description : known)
            if (description.id == device.name)
                notes.push_back(fmt::format("{}: {}, {}", device.name, description.name, description.note));
    notes.push_back(fmt::format("{}x{}, one light with shadows, float; milliseconds on the device, medians of {} "
                                "frames or of as many as {} s give",
                                frame.width, frame.height, limits.repeats, limits.seconds));
    return notes;
}

} // namespace

void bench_command(const BenchOptions& options) {
    std::optional<tbb::global_control> limit;
    if (options.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
    const Experiment experiment = experiment_of(options.name);
    const std::vector<BenchDevice> devices = bench_devices(options.device, options.threads, options.name == Name::seed);
    std::vector<BenchRow> rows = experiment.rows(options, devices.size());
    choose(rows, options.scenes);
    const SceneFolder folder(options.output);
    if (options.output)
        check_writable(*options.output / (std::string(experiment.name) + ".json"));
    BenchScenes scenes(folder.path());
    const MeasureLimits limits{options.repeats ? options.repeats : options.full ? 30u : 5u, options.full ? 3.0 : 0.4};
    BenchReport report{.name = experiment.name,
                       .notes = describe(options, devices, limits),
                       .rows = std::move(rows),
                       .beside = {},
                       .charts = {}};
    measure(report.rows, devices, scenes, limits);
    mark_best(report.rows);
    experiment.conclude(report, scenes);
    std::fputs((options.json ? table_json(report) : table_text(report)).c_str(), stdout);
    if (options.output)
        write_report(report, *options.output);
    if (const auto different = different_pictures(report.rows); !different.empty())
        throw PicturesDiffer(fmt::format("{} of {} rows made another picture than the first one of their scene: {}, {} "
                                         "{} spheres, {}, {}",
                                         different.size(), report.rows.size(), different[0]->experiment,
                                         different[0]->spheres, different[0]->scene, different[0]->device_name,
                                         different[0]->method));
}

} // namespace proxima
