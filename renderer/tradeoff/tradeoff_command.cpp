// SPDX-License-Identifier: Apache-2.0
// The order of work of `proxima tradeoff`: the folder first, so that nothing is measured in vain; then the measuring,
// the pictures, and what follows from them.
#include "renderer/choose_devices.h"
#include "renderer/commands.h"
#include "renderer/errors.h"
#include "renderer/stop_signal.h"
#include "renderer/tradeoff/measurement.h"
#include "renderer/tradeoff/page.h"
#include "renderer/tradeoff/text.h"

#include <cstdio>
#include <tbb/global_control.h>

namespace proxima {

void tradeoff_command(const TradeoffOptions& options) {
    const Stopwatch watch;
    const StopSignal stop;
    if (options.scene.animation.frames.empty())
        throw UsageError("--shard: nothing to measure: there are fewer frames than shards");
    std::optional<tbb::global_control> limit;
    if (options.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
    TradeoffPage page(options.folder);
    const auto renderer = choose_renderer(options.device, options.threads);
    const int64_t frame = options.scene.animation.frames.front();
    QualityPilot pilot(options.scene, options.frame, {frame}, *renderer, stop);
    std::fputs(pilot.messages().c_str(), stderr);

    TradeoffRecord record{.scene = options.scene.scene.string(),
                          .device = renderer->name(),
                          .frame = frame,
                          .width = options.frame.width,
                          .height = options.frame.height,
                          .repeats = options.repeats,
                          .budget = double(options.budget)};
    TradeoffMeasurement measurement(pilot, options, [&](const std::string& text) {
        if (!options.quiet)
            std::fprintf(stderr, "proxima: %6.1f s  %s\n", watch.milliseconds() / 1000, text.c_str());
    });
    measurement.run(record);
    conclude(record);
    page.add_reference(measurement.reference());
    for (size_t i = 0; i < record.points.size(); ++i)
        page.add_point(i, measurement.picture(record.points[i].setting), measurement.reference());
    page.add_files(record, measurement.reference());
    record.seconds = watch.milliseconds() / 1000;
    page.finish(record);
    std::fputs(tradeoff_text(record).c_str(), stdout);
    std::printf("\n%s has the page\n", (options.folder / "index.html").c_str());
}

} // namespace proxima
