// SPDX-License-Identifier: Apache-2.0
// The CPU backend: a device's verbs (for_each, reduce) and its buffers, by oneTBB on the host's cores.
#pragma once
#include "kernels/platform.h"
#include "renderer/device_costs.h"
#include "renderer/device_error.h"
#include "renderer/image.h"
#include "renderer/memory_meter.h"
#include "renderer/vector_instructions.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <string>
#include <sys/mman.h>
#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace proxima {

class CpuBackend {
public:
    /// Rays in flight that have stacks: enough to keep the cores busy.
    static constexpr uint64_t stack_memory = 16ull << 20;
    static constexpr const DeviceCosts& method_costs = cpu_costs;
    static constexpr uint32_t primitives_together = 64; ///< of an item of LinkPrimitives
    static constexpr bool traces_packets = true;        ///< has for_each_packet
    static constexpr bool is_immediate = true;          ///< a verb is done when it returns

    /// `threads` 0 is one for each core that the process may use; there are never more.
    explicit CpuBackend(unsigned threads = 0) : arena_(usable(threads)) {}

    template <class T> class Buffer;
    template <class T> class Receipt;
    class Moment;

    std::string name() const { return "cpu"; }
    MemoryMeter& memory() { return memory_; }
    uint64_t available_memory() const { return uint64_t(sysconf(_SC_AVPHYS_PAGES)) * uint64_t(sysconf(_SC_PAGESIZE)); }
    void activate() {}
    PageLock lock_pages(void*, size_t) { return {}; }
    void expect_copies_from(CpuBackend&) {}
    void synchronize() {}

    /// Any thread: what for_each is doing ends soon, unfinished, and it does nothing more.
    void cancel() { cancellation_.cancel_group_execution(); }
    bool is_cancelled() { return cancellation_.is_group_execution_cancelled(); }

    /// Calls kernel(i) for every i below `count`, in no order.
    template <class Kernel> void for_each(uint32_t count, const Kernel& kernel) {
        arena_.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<uint32_t>(0, count, 64),
                [&](const auto& range) {
                    const Kernel local = kernel; // the compiler sees that nothing else writes to it
                    for (uint32_t i = range.begin(); i != range.end(); ++i)
                        local(i);
                },
                cancellation_);
        });
    }

    /// The same for kernels that work on packets of rays, with the widest vector instructions that the processor has.
    template <class Kernel> void for_each_packet(uint32_t count, const Kernel& kernel) {
        arena_.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<uint32_t>(0, count, 4),
                [&](const auto& range) {
                    for (uint32_t i = range.begin(); i != range.end(); ++i)
                        run_with_vectors(kernel, i);
                },
                cancellation_);
        });
    }

    /// The combination of kernel(i) for every i below `count`; T is a struct whose default is neutral and whose
    /// static combine(a, b) is associative.
    template <class T, class Kernel> T reduce(uint32_t count, const Kernel& kernel) {
        return arena_.execute([&] {
            return tbb::parallel_deterministic_reduce(
                tbb::blocked_range<uint32_t>(0, count, 4096), T{},
                [&](const auto& range, T sum) {
                    for (uint32_t i = range.begin(); i != range.end(); ++i)
                        sum = T::combine(sum, kernel(i));
                    return sum;
                },
                [](const T& a, const T& b) { return T::combine(a, b); });
        });
    }

private:
    static int usable(unsigned threads) {
        const int cores = tbb::info::default_concurrency();
        return threads ? std::min(int(threads), cores) : cores;
    }

    tbb::task_arena arena_;
    tbb::task_group_context cancellation_{tbb::task_group_context::isolated};
    MemoryMeter memory_;
};

/// Device memory that keeps its capacity when it shrinks. Its contents are lost when it grows.
template <class T> class CpuBackend::Buffer {
public:
    explicit Buffer(CpuBackend& backend) : backend_(&backend) {}
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() { release(); }

    void resize(size_t count) {
        if (count > capacity_) {
            release();
            data_ = static_cast<T*>(::operator new(count * sizeof(T), std::align_val_t(alignment), std::nothrow));
            if (!data_)
                throw DeviceError(DeviceError::Kind::out_of_memory,
                                  "cpu: out of memory (" + std::to_string(count * sizeof(T) >> 20) + " MiB)");
            madvise(data_, count * sizeof(T), MADV_HUGEPAGE); // lists are read at random; a refusal costs only time
            capacity_ = count;
            backend_->memory().add(capacity_ * sizeof(T));
        }
        size_ = count;
    }
    /// Gives the memory back, and the contents up.
    void free() {
        release();
        size_ = 0;
    }
    /// Grows to `count` and calls convert(i) for each element.
    template <class Convert> void upload(size_t count, const Convert& convert) {
        resize(count);
        T* data = data_;
        backend_->for_each(uint32_t(count), [&, data](uint32_t i) { new (data + i) T(convert(i)); });
    }
    /// Becomes a copy of another device's memory.
    void copy_from(CpuBackend&, std::span<const T> source) {
        resize(source.size());
        if (!source.empty())
            std::memcpy(static_cast<void*>(data_), source.data(), source.size_bytes());
    }
    void download(T* out) const {
        if (size_ > 0)
            std::memcpy(static_cast<void*>(out), data_, size_ * sizeof(T));
    }
    void fill_bytes(int value) {
        if (size_ > 0)
            std::memset(static_cast<void*>(data_), value, size_ * sizeof(T));
    }
    T read(size_t index) const { return data_[index]; }

    std::span<T> view() { return {data_, size_}; }
    size_t size() const { return size_; }
    uint64_t bytes() const { return capacity_ * sizeof(T); }

private:
    static constexpr size_t alignment = size_t(2) << 20; // a huge page
    void release() {
        ::operator delete(data_, std::align_val_t(alignment));
        backend_->memory().remove(capacity_ * sizeof(T));
        data_ = nullptr;
        capacity_ = 0;
    }

    CpuBackend* backend_;
    T* data_ = nullptr;
    size_t size_ = 0;
    size_t capacity_ = 0;
};

/// A moment between two verbs.
class CpuBackend::Moment {
public:
    explicit Moment(CpuBackend&) {}
    void record() { time_ = std::chrono::steady_clock::now(); }
    double milliseconds_since(const Moment& other) const {
        return std::chrono::duration<double, std::milli>(time_ - other.time_).count();
    }

private:
    std::chrono::steady_clock::time_point time_;
};

/// The first element of a buffer on its way to the host: there after the next synchronize().
template <class T> class CpuBackend::Receipt {
public:
    explicit Receipt(CpuBackend&) {}
    void request(const Buffer<T>& from) { value_ = from.read(0); }
    const T& value() const { return value_; }

private:
    T value_{};
};

} // namespace proxima
