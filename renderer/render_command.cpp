// SPDX-License-Identifier: Apache-2.0
// The order of work of `proxima render`: everything that can be refused is refused first; then scenes are evaluated on
// one thread, rendered on those of the devices, and coloured, encoded and written on the writer's.
#include "renderer/atomic_file.h"
#include "renderer/choose_devices.h"
#include "renderer/commands.h"
#include "renderer/device_error.h"
#include "renderer/errors.h"
#include "renderer/frame_audit.h"
#include "renderer/frame_finisher.h"
#include "renderer/frame_scheduler.h"
#include "renderer/frame_source.h"
#include "renderer/frame_writer.h"
#include "renderer/leftovers.h"
#include "renderer/render_workers.h"
#include "renderer/scene_source.h"
#include "renderer/stop_signal.h"
#include "renderer/tradeoff/choose_quality.h"
#include "renderer/tradeoff/quality_setting.h"

#include <atomic>
#include <cstdio>
#include <fmt/format.h>
#include <functional>
#include <future>
#include <tbb/global_control.h>
#include <tbb/info.h>

namespace proxima {
namespace {

void print_frames(const RenderOptions& options) {
    for (const int64_t frame : options.scene.animation.frames)
        fmt::print("{} {}\n", frame, options.output->path(frame).string());
}

/// Leaves the frames that are not complete yet. Returns those that are.
std::vector<AuditedFrame> skip_complete(const RenderOptions& options, SceneSource& scene, const FrameHash& hash,
                                        const std::vector<std::string>& backends, Animation& animation) {
    std::vector<AuditedFrame> kept;
    animation.frames.clear();
    for (AuditedFrame& frame : audit_frames(options, scene, hash, backends))
        if (frame.state == FrameState::complete)
            kept.push_back(std::move(frame));
        else
            animation.frames.push_back(frame.frame);
    return kept;
}

void check_outputs(const RenderOptions& options) {
    for (const int64_t frame : {options.scene.animation.frames.front(), options.scene.animation.frames.back()})
        check_writable(options.output->path(frame));
    for (const auto& file : {options.stats_json, options.timeline})
        if (file)
            check_writable(*file);
}

/// What earlier runs that were killed left of this run's files.
size_t remove_all_leftovers(const RenderOptions& options) {
    std::vector<std::filesystem::path> files;
    for (const int64_t frame : options.scene.animation.frames)
        files.push_back(options.output->path(frame));
    return remove_leftovers(files);
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    write_file(path, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

void write_statistics(const RenderOptions& options, const RunRecord& run, const Timeline& timeline) {
    if (options.stats_json)
        write_text(*options.stats_json, to_json(run, timeline));
    if (options.timeline)
        write_text(*options.timeline, to_svg(timeline));
}

std::vector<std::string> backends_of(const StartedDevices& started) {
    std::vector<std::string> backends;
    for (const StartedDevice& device : started.devices)
        backends.emplace_back(backend_of(device.device.name));
    return backends;
}

/// Encoding is the work of one thread a frame.
unsigned writer_threads(const RenderOptions& options) {
    const unsigned cores = unsigned(tbb::info::default_concurrency());
    return options.threads > 0 ? std::min(options.threads, cores) : cores;
}

/// --max-error's choice, put into `options`.
std::optional<QualityChoice> choose_quality(RenderOptions& options, const StopSignal& stop) {
    if (!options.max_error)
        return std::nullopt;
    check_outputs(options);
    QualityChoice choice = choose_quality(options.scene, options.frame, *options.max_error, options.threads, stop);
    apply(choice.setting, options.scene, options.frame);
    return choice;
}

/// Says once, of the first frame that float does not hold, what that means.
class FitNote {
public:
    FitNote(Precision asked, Progress& progress) : asked_(asked), progress_(progress) {}

    void look_at(const FloatFit& fit) {
        if (fit.holds() || asked_ == Precision::float64 || said_.exchange(true))
            return;
        progress_.note(fit.reason() + (asked_ == Precision::automatic
                                           ? ": it is rendered in double"
                                           : ": rendered in float all the same, as --precision float asks for"));
    }

private:
    Precision asked_;
    Progress& progress_;
    std::atomic<bool> said_ = false;
};

std::string describe(const QualityRequest& request, const QualityChoice& choice) {
    return fmt::format("--max-error {}: {}; predicted {} (by {}, in {:.1f} s)", request.text, choice.options,
                       error_text(request.limit, choice.predicted), choice.pilot, choice.ms / 1000);
}

QualityRecord record_of(const QualityRequest& request, const QualityChoice& choice) {
    return {request.text, choice.options, choice.pilot, choice.ms, choice.predicted, choice.measured};
}

/// Renders with `options`, of which `choice` is a part; `asked` is what the user wrote.
void render_frames(const RenderOptions& options, const RenderOptions& asked, std::optional<QualityChoice> choice,
                   const StopSignal& stop, const Stopwatch& wall) {
    Animation animation = options.scene.animation; // the frames to render
    FrameFinisher finisher(options);

    auto starting_devices = std::async(std::launch::async, start_devices, options.device, options.threads);
    SceneSource scene(options.scene);
    check_outputs(options);
    scene.scenes(animation.frames.front());
    std::fputs(scene.messages(false).c_str(), stderr);
    StartedDevices started = starting_devices.get();

    RunRecord run{.scene = options.scene.scene.string(),
                  .width = options.frame.width,
                  .height = options.frame.height,
                  .samples = options.frame.samples,
                  .spheres = scene.program().spheres.size() + scene.program().ellipsoids.size(),
                  .moving = scene.program().motion.moving_spheres()};
    std::vector<AuditedFrame> kept;
    if (options.skip_existing)
        kept = skip_complete(options, scene, finisher.hash(), backends_of(started), animation);
    Progress progress(options.progress, animation.frames.size());
    if (options.skip_existing)
        progress.note(fmt::format("{} of {} frames are there", kept.size(), kept.size() + animation.frames.size()));
    if (const size_t removed = remove_all_leftovers(options); removed > 0)
        progress.note(
            fmt::format("removed {} unfinished {} of earlier runs", removed, removed == 1 ? "file" : "files"));
    for (const std::string& failure : started.failures)
        progress.note(failure);
    if (animation.has_no_step())
        progress.note(fmt::format("an animation of one frame has no step from clock to clock (POV-Ray's is NaN then); "
                                  "clock is {} and clock_delta 0",
                                  animation.initial_clock));
    if (choice) {
        progress.note(describe(*options.max_error, *choice));
        if (options.max_error->is_verified && !animation.frames.empty()) {
            measure_choice(*choice, asked.scene, asked.frame, animation.frames.front(),
                           *started.devices.front().renderer, stop);
            progress.note(fmt::format("--max-error {}: frame {} has {}", options.max_error->text,
                                      choice->measured_frame, error_text(options.max_error->limit, *choice->measured)));
        }
        run.quality = record_of(*options.max_error, *choice);
    }
    WorkPlan plan = plan_work(std::move(started.devices), options.multi_gpu, options.frame, animation.frames.size());
    FaultPlan faults(options.multi_gpu.faults);
    FitNote fit_note(options.frame.precision, progress);
    fit_note.look_at(scene.float_fit());
    const bool is_timed = options.timeline || options.stats_json;
    Timeline timeline(is_timed ? animation.frames.size() : 0);
    const RunWatch watch{.faults = &faults, .timeline = is_timed ? &timeline : nullptr};
    finisher.start(progress, watch);
    finisher.show_kept(kept);
    FrameWriter writer(animation.frames.size(), std::ref(finisher), writer_threads(options),
                       [&](const FrameRecord& record) { finisher.announce(record); });
    FrameQueue queue(animation.frames.size(), plan.workers.size(), plan.bands, plan.devices);
    FrameSource source(scene, animation, queue, plan.workers.size() > 1);
    FrameScheduler scheduler(
        queue, writer,
        {.settings = options.frame,
         .describe =
             [&](const FrameTask& task) {
                 const FloatFit& fit = task.scenes.fit;
                 fit_note.look_at(fit);
                 return FrameRecord{.frame = task.frame,
                                    .file = options.output->path(task.frame).string(),
                                    .precision = precision_name(chosen_precision(options.frame.precision, fit.holds())),
                                    .scene = task.facts};
             },
         .note = [&](const std::string& text) { progress.note(text); },
         .scenes_by_script = [&](int64_t frame) { return scene.scenes_by_script(frame); },
         .watch = watch});
    const auto measure = [&] {
        run.parse_ms = scene.parse_ms();
        run.evaluate_ms = scene.evaluate_ms();
        run.wall_ms = wall.milliseconds();
    };
    try {
        std::exception_ptr device_error; // what is finished by then is written, and counts
        try {
            scheduler.run(std::move(plan.workers), stop);
        } catch (const DeviceError&) {
            device_error = std::current_exception();
        }
        run.frames = writer.finish();
        source.join();
        measure();
        write_statistics(options, run, timeline);
        if (device_error)
            std::rethrow_exception(device_error);
        if (stop.caught() && run.frames.size() < animation.frames.size())
            throw Interrupted(stop.caught());
        finisher.finish();
    } catch (const std::exception& error) {
        measure();
        finisher.write_page(run, error.what());
        throw;
    }
    finisher.write_page(run, {});
    if (choice && choice->measured && !options.max_error->limit.holds(*choice->measured))
        throw PicturesDiffer(fmt::format("--max-error {}: frame {} has {}; the frames are there, but ask for less",
                                         options.max_error->text, choice->measured_frame,
                                         error_text(options.max_error->limit, *choice->measured)));
}

} // namespace

void render_command(const RenderOptions& asked) {
    const Stopwatch wall;
    const StopSignal stop;
    if (asked.dry_run)
        return print_frames(asked);
    if (asked.scene.animation.frames.empty()) {
        std::fputs("proxima: note: nothing to render: there are fewer frames than shards\n", stderr);
        return;
    }
    std::optional<tbb::global_control> limit;
    if (asked.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, asked.threads);
    RenderOptions options = asked;
    std::optional<QualityChoice> choice = choose_quality(options, stop);
    render_frames(options, asked, std::move(choice), stop, wall);
}

} // namespace proxima
