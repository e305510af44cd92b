// SPDX-License-Identifier: Apache-2.0
// Ways a command can end early that are neither the scene's, a device's nor a file's fault. main.cpp turns each into
// an exit code.
#pragma once
#include <stdexcept>
#include <string>
#include <utility>

namespace proxima {

/// The command line asks for something that cannot be. The message ends with what to write instead. Exit code 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The scene has mistakes; `report` shows each with its place. Exit code 1.
struct SceneRejected : std::runtime_error {
    std::string report;
    SceneRejected(const std::string& message, std::string report)
        : std::runtime_error(message), report(std::move(report)) {}
};

/// The pictures that were compared are not equal. Exit code 4.
struct PicturesDiffer : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Frames are missing, damaged, or of something else. Exit code 4.
struct FramesIncomplete : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A signal asked the run to stop, and the frame in flight has been finished. Exit code 128 + signal.
struct Interrupted : std::runtime_error {
    int signal;
    explicit Interrupted(int signal)
        : std::runtime_error("stopped by signal " + std::to_string(signal)), signal(signal) {}
};

} // namespace proxima
