// SPDX-License-Identifier: Apache-2.0
// The order of work of `proxima render`: everything that can be refused is refused first, then frames are rendered here
// and coloured, encoded and written on the writer's thread.
#include "renderer/atomic_file.h"
#include "renderer/choose_renderer.h"
#include "renderer/commands.h"
#include "renderer/errors.h"
#include "renderer/frame_finisher.h"
#include "renderer/scene_source.h"
#include "renderer/stop_signal.h"

#include <cstdio>
#include <fmt/format.h>
#include <functional>
#include <future>
#include <tbb/global_control.h>

namespace proxima {
namespace {

void check_outputs(const RenderOptions& options) {
    for (const int64_t frame : {options.scene.animation.frames.front(), options.scene.animation.frames.back()})
        check_writable(options.output->path(frame));
    if (options.stats_json)
        check_writable(*options.stats_json);
}

void write_statistics(const RenderOptions& options, const RunRecord& run) {
    if (!options.stats_json)
        return;
    const std::string text = to_json(run);
    write_file(*options.stats_json, {reinterpret_cast<const unsigned char*>(text.data()), text.size()});
}

} // namespace

void render_command(const RenderOptions& options) {
    const Stopwatch wall;
    const StopSignal stop;
    const Animation& animation = options.scene.animation;
    std::optional<tbb::global_control> limit;
    if (options.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
    FrameFinisher finisher(options);

    auto starting_renderer = std::async(std::launch::async, choose_renderer, options.device, options.threads);
    SceneSource scene(options.scene);
    check_outputs(options);
    scene.load(animation.frames.front());
    std::fputs(scene.messages(false).c_str(), stderr);
    const std::unique_ptr<FrameRenderer> renderer = starting_renderer.get();

    RunRecord run{.scene = options.scene.scene.string(),
                  .width = options.frame.width,
                  .height = options.frame.height,
                  .samples = options.frame.samples};
    Progress progress(options.progress, animation.frames.size());
    if (animation.has_no_step())
        progress.note(fmt::format("an animation of one frame has no step from clock to clock (POV-Ray's is NaN then); "
                                  "clock is {} and clock_delta 0",
                                  animation.initial_clock));
    std::optional<FrameWriter> writer;
    for (const int64_t frame : animation.frames) {
        if (stop.caught())
            break;
        const bool is_first = !writer;
        if (scene.load(frame) || is_first) {
            run.spheres = scene.program().spheres.size() + scene.program().ellipsoids.size();
            renderer->set_scene(scene.program(), options.frame.precision);
            scene.release_program();
        }
        if (is_first) { // loading it beside the first frame's rendering hides what it costs
            finisher.start(progress);
            writer.emplace(std::ref(finisher));
        }
        FinishedFrame finished{writer->take_image(), {}};
        finished.record = {.frame = frame,
                           .file = options.output->path(frame).string(),
                           .device = renderer->name(),
                           .precision = options.frame.precision == Precision::float64 ? "double" : "float"};
        finished.record.statistics = renderer->render(options.frame, finished.image);
        writer->push(std::move(finished));
    }
    if (writer)
        run.frames = writer->finish();
    run.parse_ms = scene.parse_ms();
    run.evaluate_ms = scene.evaluate_ms();
    run.wall_ms = wall.milliseconds();
    write_statistics(options, run);
    if (stop.caught() && run.frames.size() < animation.frames.size())
        throw Interrupted(stop.caught());
}

} // namespace proxima
