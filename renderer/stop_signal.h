// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM as a question that a loop asks between frames.
#pragma once
#include <csignal>

namespace proxima {

/// While it lives, the first SIGINT or SIGTERM is only remembered, as are those that come with it (`timeout` and farms
/// send several). The loop then has less than two seconds to come to an end, or else the process ends with exit code
/// 128 + n; a signal that comes a second later or more ends it at once, as usual. A file that grows past the process's
/// limit is an error for the one who writes it, not a signal.
class StopSignal {
public:
    StopSignal();
    ~StopSignal();
    StopSignal(const StopSignal&) = delete;
    StopSignal& operator=(const StopSignal&) = delete;

    /// The signal that came, or 0.
    int caught() const;

private:
    struct sigaction old_interrupt_, old_terminate_, old_file_size_, old_alarm_;
};

} // namespace proxima
