// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM as a question that a loop asks between frames.
#pragma once
#include <csignal>

namespace proxima {

/// While it lives, the first SIGINT or SIGTERM is only remembered; a second one ends the process as usual.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// The signal that came, or 0.
    int caught() const;

private:
    struct sigaction old_interrupt_, old_terminate_;
};

} // namespace proxima
