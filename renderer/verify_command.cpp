// SPDX-License-Identifier: Apache-2.0
// The order of work of `proxima verify`.
#include "renderer/color.h"
#include "renderer/commands.h"
#include "renderer/errors.h"
#include "renderer/frame_audit.h"
#include "renderer/tradeoff/choose_quality.h"

#include <cstdio>
#include <fmt/format.h>

namespace proxima {
namespace {

const char* name_of(FrameState state) {
    switch (state) {
    case FrameState::missing:
        return "missing";
    case FrameState::corrupt:
        return "corrupt";
    case FrameState::foreign:
        return "foreign";
    case FrameState::complete:
        break;
    }
    return "complete";
}

/// Who may have made the frames.
std::vector<std::string> backends_of(const DeviceChoice& device) {
    if (device.is_automatic())
        return {"cpu", "cuda"};
    std::vector<std::string> backends;
    for (const DeviceChoice::Item& item : device.items)
        backends.emplace_back(item.kind == DeviceChoice::Item::Kind::cpu ? "cpu" : "cuda");
    return backends;
}

} // namespace

void verify_command(const VerifyOptions& verify) {
    RenderOptions options = verify.render;
    const StopSignal stop;
    if (options.max_error)
        apply(choose_quality(options.scene, options.frame, *options.max_error, options.threads, stop).setting,
              options.scene, options.frame);
    SceneSource scene(options.scene);
    const FrameHash hash(options, ColorTransform(options.color).identity());
    size_t wrong = 0;
    for (const AuditedFrame& frame : audit_frames(options, scene, hash, backends_of(options.device))) {
        if (frame.state == FrameState::complete)
            continue;
        ++wrong;
        fmt::print("{} frame {}, {}: {}\n", name_of(frame.state), frame.frame, frame.file.string(), frame.reason);
    }
    const size_t total = options.scene.animation.frames.size();
    fmt::print("{} of {} frames are complete\n", total - wrong, total);
    if (wrong > 0)
        throw FramesIncomplete(fmt::format("{} of {} frames are not what {} makes; render them with --skip-existing",
                                           wrong, total, options.scene.scene.string()));
}

} // namespace proxima
