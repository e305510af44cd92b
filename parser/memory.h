// SPDX-License-Identifier: Apache-2.0
// How much memory there is, and how much this process holds.
#pragma once
#include <cstdint>

namespace proxima {

/// Bytes that belong to this process alone and are in memory; mapped files are not counted. 0 when it cannot be told.
uint64_t resident_bytes();

/// Bytes of the machine's memory.
uint64_t machine_bytes();

} // namespace proxima
