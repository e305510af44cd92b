// SPDX-License-Identifier: Apache-2.0
// The process's memory, as the system counts it.
#pragma once
#include <cstdint>
#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace proxima {

/// What was resident at most up to now.
inline uint64_t peak_host_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return uint64_t(usage.ru_maxrss) * 1024; // Linux counts in KiB
}

/// What is resident now; 0 where the system does not tell.
inline uint64_t host_bytes() {
    std::ifstream file("/proc/self/statm");
    uint64_t size = 0, resident = 0;
    file >> size >> resident;
    return resident * uint64_t(sysconf(_SC_PAGESIZE));
}

} // namespace proxima
