// SPDX-License-Identifier: Apache-2.0
// Failures of a device, by what the user can do about them.
#pragma once
#include <stdexcept>
#include <string>

namespace proxima {

struct DeviceError : std::runtime_error {
    enum class Kind {
        unavailable,   ///< asked for by name and not there (a mistake on the command line)
        out_of_memory, ///< exit code 33
        lost,          ///< exit code 75: try again elsewhere
        scene,         ///< the scene needs more than a kernel's fixed lists hold
    };
    Kind kind;
    DeviceError(Kind kind, const std::string& message) : std::runtime_error(message), kind(kind) {}
};

} // namespace proxima
