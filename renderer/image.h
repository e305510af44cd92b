// SPDX-License-Identifier: Apache-2.0
// A picture in memory: linear Rec.709, three samples a pixel, rows from top to bottom; and the layers beside it.
#pragma once
#include "kernels/aov_sample.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace proxima {

/// Memory that a device copies into without asking the operating system: locked while this lives. A copy locks nothing.
class PageLock {
public:
    PageLock() = default;
    PageLock(void* memory, void (*unlock)(void*)) : memory_(memory, unlock) {}
    PageLock(const PageLock&) {}
    PageLock(PageLock&&) noexcept = default;
    PageLock& operator=(PageLock other) noexcept {
        memory_ = std::move(other.memory_);
        return *this;
    }
    explicit operator bool() const { return bool(memory_); }

private:
    std::unique_ptr<void, void (*)(void*)> memory_{nullptr, [](void*) {}};
};

struct Image {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> rgb;         ///< width * height * 3, unless there are halves
    std::vector<uint16_t> halves{}; ///< the same as bits of half-floats, finite ones
    std::vector<uint8_t> levels{};  ///< of a file with 8 bits, where colour conversion makes them at once
    std::vector<AovSample> aovs{};  ///< one a pixel, or none at all
    PageLock lock{};                ///< of the samples

    /// Makes it a picture of that size, unless it is one: its rows may then be written by several threads.
    void fit(uint32_t new_width, uint32_t new_height, bool in_halves = false, bool has_aovs = false) {
        const std::size_t size = std::size_t(new_width) * new_height * 3;
        const std::size_t floats = in_halves ? 0 : size;
        aovs.resize(has_aovs ? size / 3 : 0);
        if (width == new_width && height == new_height && rgb.size() == floats && halves.size() == size - floats)
            return;
        lock = {};
        width = new_width;
        height = new_height;
        rgb.resize(floats);
        halves.resize(size - floats);
    }
    void* samples() { return halves.empty() ? static_cast<void*>(rgb.data()) : halves.data(); }
    std::size_t bytes() const { return rgb.size() * sizeof(float) + halves.size() * sizeof(uint16_t); }
    float* row(uint32_t y) { return rgb.data() + std::size_t(y) * width * 3; }
    uint16_t* row_of_halves(uint32_t y) { return halves.data() + std::size_t(y) * width * 3; }
    AovSample* row_of_aovs(uint32_t y) { return aovs.data() + std::size_t(y) * width; }
};

} // namespace proxima
