// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/measure.h"
#include "renderer/bench/paper_renderers.h"
#include "renderer/choose_devices.h"
#include "renderer/device_error.h"
#include "renderer/errors.h"
#include "renderer/stop_signal.h"
#include "renderer/timing.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <map>
#include <new>
#include <tuple>
#include <xxhash.h>

namespace proxima {
namespace {

/// Sixteen frames are once round.
MotionTime moment(uint32_t frame) {
    return {double(frame % 16) / 16, double(frame), 1.0 / 16};
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

/// The medians of all frames of a row.
class Medians {
public:
    void add(const FrameStatistics& s) {
        const double steps[] = {s.motion_ms, s.build_ms, s.cloud_ms, s.trace_ms};
        for (size_t i = 0; i < 4; ++i)
            values_[i].push_back(steps[i]);
        values_[4].push_back(steps[0] + steps[1] + steps[2] + steps[3]);
    }
    void write_to(BenchRow& row) const {
        double* const places[] = {&row.motion_ms, &row.build_ms, &row.map_ms, &row.trace_ms, &row.frame_ms};
        for (size_t i = 0; i < 5; ++i)
            *places[i] = median(values_[i]);
        row.frames = uint32_t(values_[0].size());
    }

private:
    std::vector<double> values_[5];
};

double mean_lookups(const Image& image) {
    uint64_t sum = 0, rays = 0;
    for (const AovSample& sample : image.aovs) {
        sum += sample.steps;
        rays += sample.steps > 0;
    }
    return rays ? double(sum) / double(rays) : 0.0;
}

void measure_row(BenchRow& row, const BenchDevice& device, const SceneProgram& scene, const MeasureLimits& limits) {
    const std::unique_ptr<FrameRenderer> renderer = row.is_paper() ? device.make_paper() : device.make();
    renderer->set_scene(scene, row.frame.precision);
    Image image;
    uint32_t frame = 0;
    const auto render = [&](const FrameSettings& settings, uint32_t at) {
        const MotionTime time = moment(at);
        return renderer->render(settings, {&time, 1}, image);
    };
    const Stopwatch watch;
    // The first frame shows what all methods must show, and makes room: it counts only where there is time for no
    // other.
    FrameStatistics last = render(row.frame, frame);
    row.picture = XXH3_64bits(image.rgb.data(), image.rgb.size() * sizeof(float));
    Medians medians;
    if (watch.milliseconds() > 1000 * limits.seconds)
        medians.add(last);
    else
        do
            medians.add(last = render(row.frame, ++frame));
        while (frame < limits.repeats && watch.milliseconds() < 1000 * limits.seconds);
    medians.write_to(row);
    row.device_name = renderer->name();
    row.used = last.method;
    row.grid = last.grid;
    row.brick = last.brick;
    row.references = last.references;
    row.device_bytes = last.peak_device_bytes;
    if (row.is_paper() || last.method == "brute" || !row.counts_lookups)
        return;
    FrameSettings counting = row.frame; // last, since it takes memory
    counting.aovs.steps = true;
    render(counting, frame);
    row.lookups = mean_lookups(image);
}

std::string told(const BenchRow& row) {
    const auto [x, y, z] = row.grid;
    const std::string voxels = x ? fmt::format(" {}x{}x{}", x, y, z) : "";
    return row.failure.empty() ? fmt::format("{}{}: {:.3f} ms", row.used, voxels, row.frame_ms) : row.failure;
}

} // namespace

std::vector<BenchDevice> bench_devices(const DeviceChoice& choice, unsigned threads, bool both) {
    std::vector<ChosenDevice> chosen = choose_devices(choice, threads);
    if (choice.is_automatic()) {
        chosen.resize(1);
        if (both && chosen[0].is_gpu)
            chosen.push_back(choose_devices({{{DeviceChoice::Item::Kind::cpu}}}, threads)[0]);
    }
    std::vector<BenchDevice> devices;
    for (const ChosenDevice& device : chosen) {
        const int ordinal = device.is_gpu ? std::stoi(device.name.substr(device.name.find(':') + 1)) : 0;
        devices.push_back({device.name, device.make, [=] {
                               return device.is_gpu ? baselines::make_paper_cuda_renderer(ordinal)
                                                    : baselines::make_paper_cpu_renderer(threads);
                           }});
    }
    return devices;
}

void measure(std::vector<BenchRow>& rows, const std::vector<BenchDevice>& devices, BenchScenes& scenes,
             const MeasureLimits& limits) {
    const StopSignal stop;
    size_t done = 0;
    for (BenchRow& row : rows) {
        if (stop.caught())
            throw Interrupted(stop.caught());
        try {
            const auto scene = scenes.load(row.scene, row.spheres, row.frame.width, row.frame.height);
            measure_row(row, devices[row.device], *scene, limits);
        } catch (const DeviceError& error) {
            if (error.kind != DeviceError::Kind::out_of_memory)
                throw;
            row.failure = "out of memory";
        } catch (const std::bad_alloc&) {
            row.failure = "out of memory";
        }
        row.device_name = devices[row.device].name;
        std::fputs(fmt::format("{} of {}: {}, {} {} spheres, {}, {}: {}\n", ++done, rows.size(), row.experiment,
                               row.spheres, row.scene, row.device_name, row.method, told(row))
                       .c_str(),
                   stderr);
    }
}

void mark_best(std::vector<BenchRow>& rows) {
    std::map<std::tuple<std::string, std::string, uint64_t, size_t, std::string>, BenchRow*> best;
    for (BenchRow& row : rows) {
        if (!row.candidate || !row.failure.empty())
            continue;
        BenchRow*& place = best[{row.experiment, row.scene, row.spheres, row.device, row.method}];
        if (!place || row.frame_ms < place->frame_ms)
            place = &row;
    }
    for (const auto& [key, row] : best)
        row->best = true;
}

std::vector<const BenchRow*> different_pictures(const std::vector<BenchRow>& rows) {
    std::map<std::tuple<std::string, uint64_t, size_t, uint32_t, uint32_t>, uint64_t> first;
    std::vector<const BenchRow*> different;
    for (const BenchRow& row : rows) {
        if (!row.failure.empty())
            continue;
        const auto [place, is_new] =
            first.try_emplace({row.scene, row.spheres, row.device, row.frame.width, row.frame.height}, row.picture);
        if (!is_new && place->second != row.picture)
            different.push_back(&row);
    }
    return different;
}

} // namespace proxima
