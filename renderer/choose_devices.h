// SPDX-License-Identifier: Apache-2.0
// The --device option in, the devices that render out.
#pragma once
#include "renderer/device_choice.h"
#include "renderer/frame_renderer.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace proxima {

/// A device that was chosen, and how to make what renders on it. Each call of `make` gives one with memory and a stream
/// of its own, so that two of them have two frames in flight; it throws DeviceError.
struct ChosenDevice {
    std::string name; ///< as `proxima devices` has it; the second "cuda:0" of a list is "cuda:0#2"
    bool is_gpu = false;
    std::function<std::unique_ptr<FrameRenderer>()> make;
};

/// The devices that `choice` means, in its order: at least one. `threads` is the CPU's (0: all), which several of them
/// share.
/// Throws UsageError when one that was asked for by name is not there.
std::vector<ChosenDevice> choose_devices(const DeviceChoice& choice, unsigned threads);

/// A device that has been started: its first renderer is there.
struct StartedDevice {
    ChosenDevice device;
    std::unique_ptr<FrameRenderer> renderer;
};

struct StartedDevices {
    std::vector<StartedDevice> devices; ///< at least one
    std::vector<std::string> failures;  ///< what to tell of those that could not be started
};

/// Starts the devices that `choice` means, all at once: making a GPU's context takes a while. One that fails is left
/// out as long as there is another one; without a choice the CPU stands in for GPUs that cannot be used. Throws as
/// choose_devices, and what the last device failed with when none is left.
StartedDevices start_devices(const DeviceChoice& choice, unsigned threads);

/// The one device of a command that uses no more: the first of those. Throws as choose_devices and `make`, and
/// UsageError when a list was given.
std::unique_ptr<FrameRenderer> choose_renderer(const DeviceChoice& choice, unsigned threads);

} // namespace proxima
