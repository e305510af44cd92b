// SPDX-License-Identifier: Apache-2.0
// How well `--accel auto` chooses, by the clock, and what a unit of a frame's work takes on a device.
#include "renderer/frame_renderer.h"
#include "renderer/method_choice.h"
#include "tests/bench/choice_report.h"
#include "tests/bench/choice_scenes.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fmt/format.h>

using namespace proxima;
using namespace proxima::bench;

namespace {

constexpr const char* usage = R"(choice_bench cpu|cuda:N TABLE [FRAMES [SCALE [WIDTH]]]
    times 64 scenes by grid, by cloud and by auto; medians of FRAMES [30] frames at WIDTH [1920] pixels, of auto the
    mean of four times as many with its looks and trials; SCALE [25] times 3,000 to 40,000 spheres
choice_bench fit TABLE
    the coefficients of renderer/device_costs.h from that table's set "fit", and what choices by them would lose
choice_bench loss TABLE
    the table as it was printed
)";

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + long(values.size() / 2), values.end());
    return values[values.size() / 2];
}

double frame_ms(const FrameStatistics& s) {
    return s.build_ms + s.cloud_ms + s.trace_ms;
}

/// A scene on a device, of which no frame was made yet.
class Measurement {
public:
    Measurement(const std::string& device, const SceneProgram& scene, uint32_t width, int frames)
        : renderer_(device == "cpu" ? make_cpu_renderer(0)
                                    : make_cuda_renderer(std::atoi(device.substr(device.find(':') + 1).c_str()))),
          frames_(frames) {
        renderer_->set_scene(scene, Precision::float32);
        settings_.width = width;
        settings_.height = width * 9 / 16;
        settings_.in_halves = true; // reading back is not what is measured
    }

    /// What auto takes, from a state in which it knows nothing.
    void choose(ChoiceRow& row) {
        settings_.tolerances = Tolerances::povray; // room for the method that it starts with is made in other frames
        renderer_->render(settings_, image_);
        renderer_->lock_pages(image_);
        const double one = frame_ms(renderer_->render(settings_, image_));
        settings_.tolerances = Tolerances::exact;
        const int wanted = 4 * frames_, frames = affordable(one, wanted, 3000);
        std::vector<double> last;
        double sum = 0;
        row.trial_frames = 0;
        for (int i = 0; i < frames; ++i) {
            const FrameStatistics statistics = renderer_->render(settings_, image_);
            const SearchMethod method = statistics.method == "cloud" ? SearchMethod::cloud : SearchMethod::grid;
            const double ms = frame_ms(statistics);
            sum += ms;
            row.trial_frames += statistics.choice.reason == MethodReason::trial;
            row.first = i == 0 ? method : row.first;
            if (method != row.last)
                last.clear();
            row.last = method;
            last.push_back(ms);
        }
        row.auto_ms = (sum + (wanted - frames) * median(last)) / wanted; // those that there is no time for go on alike
    }

    void time(ChoiceRow& row, SearchMethod method) {
        ChoiceRow::Timed& timed = row.of[method];
        FrameSettings settings = settings_;
        settings.accelerator = method == SearchMethod::cloud ? Accelerator::cloud : Accelerator::grid;
        const double one = frame_ms(renderer_->render(settings, image_)); // makes room
        std::vector<double> builds, maps, traces, sums;
        FrameStatistics statistics;
        for (int i = affordable(one, frames_, 1000); i > 0; --i) {
            statistics = renderer_->render(settings, image_);
            builds.push_back(statistics.build_ms);
            maps.push_back(statistics.cloud_ms);
            traces.push_back(statistics.trace_ms);
            sums.push_back(frame_ms(statistics));
        }
        timed.build_ms = median(builds), timed.map_ms = median(maps), timed.trace_ms = median(traces);
        timed.frame_ms = median(sums);
        timed.work.references = double(statistics.references);
        timed.work.rays = MethodChoice::rays_of(settings);
        timed.work.voxels = double(statistics.grid[0]) * statistics.grid[1] * statistics.grid[2];
    }

    /// Lookups of a small picture, and what a look finds.
    void count(ChoiceRow& row) {
        FrameSettings settings = settings_;
        settings.in_halves = false;
        settings.width /= 8;
        settings.height /= 8;
        settings.aovs.steps = true;
        Image image;
        row.space = renderer_->render(settings, image).choice.space;
        for (const SearchMethod method : {SearchMethod::grid, SearchMethod::cloud}) {
            settings.accelerator = method == SearchMethod::cloud ? Accelerator::cloud : Accelerator::grid;
            renderer_->render(settings, image);
            double sum = 0;
            for (const AovSample& sample : image.aovs)
                sum += sample.steps;
            row.of[method].work.lookups = sum / double(image.aovs.size());
        }
        row.of.cloud.work.voxels = 64.0 * double(row.space.bricks - row.space.empty);
    }

private:
    /// Frames that take one_ms, as many as there is time for, but a few.
    static int affordable(double one_ms, int wanted, double milliseconds) {
        return std::min(wanted, std::max(5, int(milliseconds / one_ms)));
    }

    std::unique_ptr<FrameRenderer> renderer_;
    FrameSettings settings_;
    Image image_;
    int frames_;
};

void measure(const std::string& device, const char* file, int frames, double scale, uint32_t width) {
    std::vector<ChoiceRow> rows;
    for (const SceneSet set : {SceneSet::test, SceneSet::fit})
        for (size_t place = 0; place < choice_scene_count(set); ++place) {
            const ChoiceScene scene = choice_scene(set, place, scale);
            ChoiceRow row;
            row.set = set == SceneSet::fit ? "fit" : "test";
            row.scene = scene.name;
            Measurement measurement(device, scene.scene, width, frames);
            measurement.choose(row);
            measurement.time(row, SearchMethod::grid);
            measurement.time(row, SearchMethod::cloud);
            measurement.count(row);
            std::fputs(line_of(row).c_str(), stderr);
            rows.push_back(row);
            write_table(file, rows);
        }
    print_rows(rows);
}

} // namespace

int main(int argc, char** argv) {
    const auto number = [&](int index, double otherwise) { return argc > index ? std::atof(argv[index]) : otherwise; };
    if (argc < 3) {
        std::fputs(usage, stderr);
        return 2;
    }
    try {
        const bool fits = std::strcmp(argv[1], "fit") == 0;
        if (fits || std::strcmp(argv[1], "loss") == 0) {
            const std::vector<ChoiceRow> rows = read_table(argv[2]);
            if (!fits)
                return print_rows(rows), 0;
            return print_fit(rows), 0;
        }
        measure(argv[1], argv[2], int(number(3, 30)), number(4, 25), uint32_t(number(5, 1920)));
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "choice_bench: {}\n", error.what());
        return 1;
    }
}
