// SPDX-License-Identifier: Apache-2.0
#include "renderer/frame_hash.h"

#include <bit>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace proxima {
namespace {

/// Every bit of a number.
std::string bits(double value) {
    return fmt::format("{:x}", std::bit_cast<uint64_t>(value));
}

std::string describe_layers(const FrameSettings& settings) {
    const auto& [depth, normal, id, steps] = settings.aovs;
    if (!settings.aovs.any())
        return {};
    const std::string layers = fmt::format(" layers {} {} {} {}", depth, normal, id, steps);
    const auto& grid = settings.grid;
    return steps ? fmt::format("{} by {} {} {} {} {} {} {}", layers, int(settings.accelerator), grid[0], grid[1],
                               grid[2], int(settings.metric), settings.brick, bits(settings.density))
                 : layers;
}

std::string describe(const FrameSettings& settings) {
    // How many members there are: a new one stops the compilation here. Does it change the picture? Then it belongs
    // into the text below; rows, in_halves, accelerator, grid, metric, brick and density do not, but for the layer that
    // counts steps.
    [[maybe_unused]] const auto& [m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14] = settings;
    const Antialiasing& antialiasing = settings.antialiasing;
    return fmt::format("size {}x{} samples {} antialias {} {} {} precision {} tolerances {}", settings.width,
                       settings.height, settings.samples, int(antialiasing.method), bits(antialiasing.threshold),
                       antialiasing.depth, int(settings.precision), int(settings.tolerances)) +
           describe_layers(settings);
}

std::string describe(const Shutter& shutter) {
    const auto& [open, close, samples] = shutter;
    return fmt::format("shutter {} {} {}", bits(open), bits(close), samples);
}

std::string describe(const SceneClock& time) {
    const auto& [clock, clock_delta, clock_on, frame_number, initial_frame, final_frame, initial_clock, final_clock] =
        time;
    return fmt::format("clock {} {} {} {} {} {} {} {}", bits(clock), bits(clock_delta), clock_on, bits(frame_number),
                       bits(initial_frame), bits(final_frame), bits(initial_clock), bits(final_clock));
}

} // namespace

FrameHash::FrameHash(const RenderOptions& options, std::string_view color)
    : settings_(fmt::format("proxima " PROXIMA_VERSION
                            " {} {} format {} type {} compression {} rate {}/{} color {} dither {}",
                            describe(options.frame), describe(options.scene.animation.shutter),
                            int(options.output->format()), int(options.type), int(options.compression),
                            options.rate.numerator, options.rate.denominator, color, options.dither)) {}

std::string FrameHash::of(int64_t frame, const SceneFacts& scene, std::string_view backend) const {
    return hash_text(fmt::format("{} frame {} scene {} {} backend {}", settings_, frame, scene.hash.text(),
                                 describe(scene.time), backend))
        .text();
}

std::string backend_of(std::string_view devices) {
    std::set<std::string_view> kinds;
    for (size_t begin = 0; begin <= devices.size();) {
        const std::string_view device = devices.substr(begin, devices.find(',', begin) - begin);
        kinds.insert(device.substr(0, device.find_first_of(":#")));
        begin += device.size() + 1;
    }
    return fmt::format("{}", fmt::join(kinds, "+"));
}

} // namespace proxima
