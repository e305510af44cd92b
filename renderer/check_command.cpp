// SPDX-License-Identifier: Apache-2.0
#include "renderer/commands.h"
#include "renderer/errors.h"
#include "renderer/scene_source.h"
#include "renderer/stop_signal.h"

#include <cstdio>
#include <fmt/format.h>

namespace proxima {
namespace {

std::string describe(const SceneProgram& program) {
    const auto line = [](const char* what, size_t count) { return fmt::format("  {:<12}{:>12}\n", what, count); };
    return line("spheres", program.spheres.size()) + line("ellipsoids", program.ellipsoids.size()) +
           line("planes", program.planes.size()) + line("lights", program.lights.size()) +
           line("materials", program.materials.size()) + line("pigments", program.pigments.size()) +
           line("finishes", program.finishes.size());
}

} // namespace

void check_command(const CheckOptions& options) {
    const StopSignal stop;
    const Animation& animation = options.scene.animation;
    const auto print = [](std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); };
    SceneSource scene(options.scene, print);
    size_t evaluations = 0;
    for (const int64_t frame : animation.frames) {
        if (stop.caught())
            throw Interrupted(stop.caught());
        evaluations += scene.load(frame);
    }
    std::fputs(scene.messages(true).c_str(), stderr);
    std::string text = fmt::format("{}: the scene is right\n", options.scene.scene.string());
    if (evaluations > 1)
        text += fmt::format("  evaluated for {} frames; of the last one:\n", evaluations);
    text += describe(scene.program());
    text += fmt::format("  read in {:.1f} ms, evaluated in {:.1f} ms\n", scene.parse_ms(), scene.evaluate_ms());
    std::fputs(text.c_str(), stdout);
}

} // namespace proxima
