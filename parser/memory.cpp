// SPDX-License-Identifier: Apache-2.0
#include "parser/memory.h"

#include <fstream>
#include <unistd.h>

namespace proxima {

uint64_t resident_bytes() {
    // Pages: the whole size, those in memory, and of these the ones that are shared or files.
    uint64_t size = 0, resident = 0, shared = 0;
    std::ifstream file("/proc/self/statm");
    if (!(file >> size >> resident >> shared) || resident < shared)
        return 0;
    return (resident - shared) * uint64_t(::sysconf(_SC_PAGESIZE));
}

uint64_t machine_bytes() {
    return uint64_t(::sysconf(_SC_PHYS_PAGES)) * uint64_t(::sysconf(_SC_PAGESIZE));
}

} // namespace proxima
