// SPDX-License-Identifier: Apache-2.0
// Counts the bytes that a device's buffers hold.
#pragma once
#include <cstdint>

namespace proxima {

class MemoryMeter {
public:
    void add(uint64_t bytes) {
        now_ += bytes;
        peak_ = now_ > peak_ ? now_ : peak_;
    }
    void remove(uint64_t bytes) { now_ -= bytes; }
    uint64_t now() const { return now_; }
    uint64_t peak() const { return peak_; }

private:
    uint64_t now_ = 0;
    uint64_t peak_ = 0;
};

} // namespace proxima
