// SPDX-License-Identifier: Apache-2.0
// How well `--accel auto` chooses, by the clock, and what a unit of a frame's work takes on a device.
// choice_bench measure cpu|cuda:N TABLE [FRAMES [SCALE [WIDTH]]]   times all ways to render all scenes
// choice_bench fit TABLE                                          coefficients from that table
// choice_bench loss TABLE                                         what is lost to the better of grid and cloud
#include "renderer/frame_renderer.h"
#include "renderer/plan_chooser.h"
#include "tests/bench/choice_scenes.h"
#include "tests/bench/choice_table.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <map>

using namespace proxima;
using namespace proxima::bench;

namespace {

/// On the CPU a step's time is that of the processor, on one thread, since others use the machine too.
class ProcessorClock : public StepWatch {
public:
    void begin(FrameStep step) override {
        stop();
        running_ = step;
        since_ = now();
    }
    /// The steps' milliseconds since the last call.
    FrameCost take(double& choose) {
        stop();
        const FrameCost cost{spent_[FrameStep::build], spent_[FrameStep::map], spent_[FrameStep::trace]};
        choose += spent_[FrameStep::choose];
        spent_.clear();
        running_ = FrameStep::write;
        return cost;
    }

private:
    static double now() {
        timespec time;
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
    }
    void stop() { spent_[running_] += now() - since_; }

    std::map<FrameStep, double> spent_;
    FrameStep running_ = FrameStep::write;
    double since_ = 0;
};

struct Frames {
    FrameCost median;  ///< on the CPU the least
    double total = 0;  ///< of build, map and trace
    double first_choose = 0; ///< of the frame that looks for the first time
    double choose = 0;       ///< in the mean, of the frames that count, with what frames by another method took longer
    FrameStatistics last;
};

class Machine {
public:
    Machine(const std::string& device, int frames) : device_(device), frames_(frames), is_cpu_(device == "cpu") {}

    /// On a renderer that knows nothing of other scenes.
    void set_scene(const SceneProgram& scene) {
        renderer_.reset();
        if (is_cpu_)
            renderer_ = make_cpu_renderer(1);
        else
            renderer_ = make_cuda_renderer(std::atoi(device_.substr(device_.find(':') + 1).c_str()));
        if (is_cpu_)
            renderer_->set_watch(&clock_);
        renderer_->set_scene(scene, Precision::float32);
    }
    FramePlan plan(const FrameSettings& settings) { return renderer_->plan(settings, {}, true); }
    Frames render(const FrameSettings& settings, int times_as_many = 1) {
        Frames result;
        std::vector<double> builds, maps, traces, totals;
        std::vector<std::string> methods;
        double ignored = 0;
        clock_.take(ignored);
        const int frames = frames_ * times_as_many;
        for (int frame = -2; frame < frames; ++frame) {
            result.last = renderer_->render(settings, image_);
            FrameCost cost{result.last.build_ms, result.last.cloud_ms, result.last.trace_ms};
            double choose = is_cpu_ ? 0 : result.last.choose_ms;
            if (is_cpu_)
                cost = clock_.take(choose);
            result.first_choose = frame == -2 ? choose : result.first_choose;
            if (frame < 0)
                continue; // memory is made
            result.choose += choose / frames;
            builds.push_back(cost.build), maps.push_back(cost.map), traces.push_back(cost.trace);
            totals.push_back(cost.total()), methods.push_back(result.last.method);
        }
        result.median = {typical(builds), typical(maps), typical(traces)};
        result.total = typical(totals);
        for (size_t i = 0; i < totals.size(); ++i)
            if (methods[i] != result.last.method)
                result.choose += (totals[i] - result.total) / frames;
        return result;
    }

private:
    /// A GPU is ours alone; on the CPU others make times longer, never shorter.
    double typical(std::vector<double> values) const {
        std::sort(values.begin(), values.end());
        return is_cpu_ ? values.front() : values[values.size() / 2];
    }

    std::unique_ptr<FrameRenderer> renderer_;
    std::string device_;
    int frames_;
    bool is_cpu_;
    ProcessorClock clock_;
    Image image_;
};

/// `auto` is run over so many times the frames of the others: over more than one look.
constexpr int looks_of_frames = 4;

void measure(Machine& machine, SceneSet set, double scale, uint32_t width, ChoiceTable& table,
             const std::string& file) {
    for (size_t place = 0; place < choice_scene_count(set); ++place) {
        const ChoiceScene scene = choice_scene(set, place, scale);
        machine.set_scene(scene.scene);
        FrameSettings settings;
        settings.width = width;
        settings.height = width * 9 / 16;
        FramePlan plan = machine.plan(settings);
        for (size_t i = 0; i < plan.methods.size(); ++i) {
            const PlannedMethod& method = plan.methods[i];
            if (i > 0 && method.plan.has_cloud() == plan.methods[i - 1].plan.has_cloud() &&
                method.size == plan.methods[i - 1].size)
                continue; // as fine as it is worth
            settings.accelerator = method.plan.has_cloud() ? Accelerator::cloud : Accelerator::grid;
            settings.density = method.plan.voxels_per_primitive;
            const Frames frames = machine.render(settings);
            table.rows.push_back({set == SceneSet::fit ? "fit" : "test", scene.name, method.plan.has_cloud(),
                                  settings.density, method.work, frames.median, method.cost});
        }
        settings.accelerator = Accelerator::automatic;
        settings.density = 0;
        machine.set_scene(scene.scene);
        const Frames frames = machine.render(settings, looks_of_frames);
        const PlannedMethod& picked = plan.methods[plan.picked];
        table.automatic.push_back({scene.name, frames.last.method == "cloud", picked.plan.voxels_per_primitive,
                                   frames.total, frames.choose});
        fmt::print(stderr, "{}: {} {:g}; choosing {:.2f} ms at first, {:.3f} ms a frame\n", scene.name,
                   frames.last.method, picked.plan.voxels_per_primitive, frames.first_choose, frames.choose);
        write_table(file, table);
    }
}

void print_costs(const char* name, const WorkCosts& c) {
    fmt::print("{}: {{.build_fixed = {:.4g}, .primitive = {:.4g}, .cell = {:.4g}, .link = {:.4g}, .mark = {:.4g}, "
               ".map_fixed = {:.4g}, .brick = {:.4g}, .distance = {:.4g}, .trace_fixed = {:.4g}, .pixel = {:.4g}, "
               ".lookup = {:.4g}, .test = {:.4g}}}\n",
               name, c.build_fixed, c.primitive, c.cell, c.link, c.mark, c.map_fixed, c.brick, c.distance,
               c.trace_fixed, c.pixel, c.lookup, c.test);
}

/// Root mean squares of the relative errors.
void print_errors(const std::vector<ChoiceRow>& rows, bool has_cloud, const WorkCosts& costs) {
    double sums[4]{};
    size_t count = 0;
    for (const ChoiceRow& row : rows)
        if (row.has_cloud == has_cloud) {
            const FrameCost cost = costs.cost(row.work);
            const double errors[] = {cost.build / row.timed.build - 1, has_cloud ? cost.map / row.timed.map - 1 : 0,
                                     cost.trace / row.timed.trace - 1, cost.total() / row.timed.total() - 1};
            for (int i = 0; i < 4; ++i)
                sums[i] += errors[i] * errors[i];
            ++count;
        }
    fmt::print("  errors (rms): build {:.1f} %, map {:.1f} %, trace {:.1f} %, frame {:.1f} %\n",
               100 * std::sqrt(sums[0] / count), 100 * std::sqrt(sums[1] / count), 100 * std::sqrt(sums[2] / count),
               100 * std::sqrt(sums[3] / count));
}

/// What choices by `costs` lose, on every scene; its own cost left out.
template <class Predict>
void print_losses(const ChoiceTable& table, const std::string& set, bool tells, const Predict& predict) {
    std::map<std::string, std::vector<const ChoiceRow*>> scenes;
    std::vector<std::string> order;
    for (const ChoiceRow& row : table.rows)
        if (row.set == set) {
            if (scenes[row.scene].empty())
                order.push_back(row.scene);
            scenes[row.scene].push_back(&row);
        }
    double sum = 0, worst = 0, automatic_sum = 0, automatic_worst = 0;
    size_t right = 0;
    if (tells)
        fmt::print("| scene | grid | | cloud | | picked | | auto, choosing included | "
                   "|\n|---|---|---|---|---|---|---|---|---|\n");
    for (const std::string& scene : order) {
        const auto cheapest = [&](int cloud, const auto& cost) {
            const ChoiceRow* best = nullptr;
            for (const ChoiceRow* row : scenes[scene])
                if ((cloud < 0 || row->has_cloud == bool(cloud)) && (!best || cost(*row) < cost(*best)))
                    best = row;
            return best;
        };
        const auto timed = [](const ChoiceRow& row) { return row.timed.total(); };
        const ChoiceRow *grid = cheapest(0, timed), *cloud = cheapest(1, timed), *best = cheapest(-1, timed);
        const ChoiceRow* picked = cheapest(-1, predict);
        const double loss = picked->timed.total() / best->timed.total() - 1;
        sum += loss;
        worst = std::max(worst, loss);
        right += picked->has_cloud == best->has_cloud;
        const auto own = std::find_if(table.automatic.begin(), table.automatic.end(),
                                      [&](const AutoRow& row) { return row.scene == scene; });
        const double auto_ms = own->frame_ms + own->choose_ms, auto_loss = auto_ms / best->timed.total() - 1;
        automatic_sum += auto_loss;
        automatic_worst = std::max(automatic_worst, auto_loss);
        if (tells)
            fmt::print("| {} | {:g} | {:.3f} | {:g} | {:.3f} | {} {:g} | {:.1f} % | {:.3f} | {:.1f} % |\n", scene,
                       grid->density, grid->timed.total(), cloud->density, cloud->timed.total(),
                       picked->has_cloud ? "cloud" : "grid", picked->density, 100 * loss, auto_ms, 100 * auto_loss);
    }
    fmt::print("{}: {} of {} scenes by the right method; loss {:.2f} % in the mean, {:.1f} % at worst; auto as run, "
               "choosing included: {:.2f} %, {:.1f} %\n",
               set, right, order.size(), 100 * sum / double(order.size()), 100 * worst,
               100 * automatic_sum / double(order.size()), 100 * automatic_worst);
}

void fit(const ChoiceTable& table) {
    std::vector<ChoiceRow> rows;
    for (const ChoiceRow& row : table.rows)
        if (row.set == "fit")
            rows.push_back(row);
    for (const bool together : {false, true}) {
        fmt::print("{}:\n", together ? "by the slowest of each group" : "by means");
        const CostCoefficients costs{fit_costs(rows, false, together), fit_costs(rows, true, together)};
        print_costs("grid", costs.grid);
        print_errors(rows, false, costs.grid);
        print_costs("cloud", costs.cloud);
        print_errors(rows, true, costs.cloud);
        for (const char* set : {"fit", "test"})
            print_losses(table, set, false, [&](const ChoiceRow& row) {
                return (row.has_cloud ? costs.cloud : costs.grid).cost(row.work).total();
            });
    }
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() == 2 && words[0] == "fit") {
        fit(read_table(words[1]));
    } else if (words.size() == 2 && words[0] == "loss") {
        for (const char* set : {"fit", "test"})
            print_losses(read_table(words[1]), set, true, [](const ChoiceRow& row) { return row.predicted.total(); });
    } else if (words.size() >= 3 && words[0] == "measure") {
        const auto number = [&](size_t place, double otherwise) {
            return words.size() > place ? std::atof(words[place].c_str()) : otherwise;
        };
        Machine machine(words[1], int(number(3, 32)));
        ChoiceTable table;
        for (const SceneSet set : {SceneSet::fit, SceneSet::test})
            measure(machine, set, number(4, 1), uint32_t(number(5, 1920)), table, words[2]);
    } else {
        std::fputs("choice_bench measure cpu|cuda:N TABLE [FRAMES [SCALE [WIDTH]]]\nchoice_bench fit TABLE\n"
                   "choice_bench loss TABLE\n",
                   stderr);
        return 2;
    }
}
