// SPDX-License-Identifier: Apache-2.0
// The CUDA backend: a device's verbs (for_each, reduce) and its buffers, on one stream of one GPU, by
// CUDA and CUB. The only place that starts kernels.
#pragma once
#include "kernels/platform.h"
#include "renderer/cuda_check.h"
#include "renderer/device_costs.h"
#include "renderer/image.h"
#include "renderer/memory_meter.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cub/device/device_reduce.cuh>
#include <memory>
#include <span>
#include <string>
#include <thrust/iterator/counting_iterator.h>

namespace proxima {

inline constexpr uint32_t block_threads = 128;

/// A kernel that waits for memory more than it computes says how many of its blocks are to share a multiprocessor; its
/// registers are then held down to that.
template <class Kernel> consteval uint32_t blocks_together() {
    if constexpr (requires { Kernel::blocks_together; })
        return Kernel::blocks_together;
    else
        return 1;
}

template <class Kernel>
__global__ void __launch_bounds__(block_threads, blocks_together<Kernel>())
    run_kernel(uint32_t count, const __grid_constant__ Kernel kernel) {
    const uint32_t index = blockIdx.x * blockDim.x + threadIdx.x;
    if (index < count)
        kernel(index);
}

template <class T> struct Combine {
    __host__ __device__ T operator()(const T& a, const T& b) const { return T::combine(a, b); }
};

class CudaBackend {
public:
    static constexpr uint64_t stack_memory = 1ull << 30;
    static constexpr const DeviceCosts& method_costs = cuda_costs;
    static constexpr uint32_t primitives_together = 1; ///< of an item of LinkPrimitives
    static constexpr bool traces_packets = false;
    static constexpr bool is_immediate = false; ///< verbs are done after the next synchronize()

    explicit CudaBackend(int ordinal = 0)
        : ordinal_(ordinal), stream_(make_stream(ordinal)), staging_(make_pinned(staging_bytes)), scratch_(*this),
          result_(*this) {}

    template <class T> class Buffer;
    template <class T> class Receipt;
    class Moment;

    std::string name() const { return "cuda:" + std::to_string(ordinal_); }
    MemoryMeter& memory() { return memory_; }
    /// Makes the device current in the calling thread.
    void activate() { cuda_check(cudaSetDevice(ordinal_)); }
    /// For all devices. Nothing is locked when the system does not allow it; copies then take longer.
    PageLock lock_pages(void* memory, size_t bytes) {
        if (cudaHostRegister(memory, bytes, cudaHostRegisterPortable) == cudaSuccess)
            return {memory, [](void* locked) { cudaHostUnregister(locked); }};
        cudaGetLastError();
        return {};
    }
    /// Lets the other device's memory be copied without a way through the host, where the two can do that.
    void expect_copies_from(CudaBackend& other) {
        int can = 0;
        if (other.ordinal_ == ordinal_ || cudaDeviceCanAccessPeer(&can, ordinal_, other.ordinal_) != cudaSuccess ||
            !can)
            return;
        activate();
        cudaDeviceEnablePeerAccess(other.ordinal_, 0);
        cudaGetLastError(); // it may have been enabled before
    }
    uint64_t available_memory() const {
        size_t free = 0, total = 0;
        cuda_check(cudaMemGetInfo(&free, &total));
        return free;
    }
    void synchronize() { cuda_check(cudaStreamSynchronize(stream_.get())); }

    /// Any thread. Kernels that have been started go on to their end.
    void cancel() { cancelled_ = true; }
    bool is_cancelled() const { return cancelled_; }

    /// Calls kernel(i) for every i below `count`, in no order.
    template <class Kernel> void for_each(uint32_t count, const Kernel& kernel) {
        if (count == 0)
            return;
        run_kernel<<<uint32_t((uint64_t(count) + block_threads - 1) / block_threads), block_threads, 0,
                     stream_.get()>>>(count, kernel);
        cuda_check(cudaGetLastError());
#ifndef NDEBUG
        synchronize(); // a fault is reported by the step that made it
#endif
    }

    /// The combination of kernel(i) for every i below `count`; T is a struct whose default is neutral and whose
    /// static combine(a, b) is associative.
    template <class T, class Kernel> T reduce(uint32_t count, const Kernel& kernel);

private:
    static constexpr size_t staging_bytes = 4u << 20, result_bytes = 256;

    struct StreamDeleter {
        using pointer = cudaStream_t;
        void operator()(cudaStream_t stream) const { cudaStreamDestroy(stream); }
    };
    struct PinnedDeleter {
        void operator()(std::byte* memory) const { cudaFreeHost(memory); }
    };
    using Stream = std::unique_ptr<CUstream_st, StreamDeleter>;
    using Pinned = std::unique_ptr<std::byte[], PinnedDeleter>;

    static Stream make_stream(int ordinal) {
        cuda_check(cudaSetDevice(ordinal));
        cudaStream_t stream;
        cuda_check(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
        return Stream(stream);
    }
    static Pinned make_pinned(size_t bytes) {
        void* memory = nullptr;
        cuda_check(cudaMallocHost(&memory, bytes));
        return Pinned(static_cast<std::byte*>(memory));
    }

    /// Raw memory that only grows.
    class ByteBuffer {
    public:
        explicit ByteBuffer(CudaBackend& backend) : backend_(&backend) {}
        ByteBuffer(const ByteBuffer&) = delete;
        ByteBuffer& operator=(const ByteBuffer&) = delete;
        ~ByteBuffer() { release(); }
        void reserve(size_t bytes) {
            if (bytes <= capacity_)
                return;
            release();
            cuda_check(cudaMalloc(&data_, bytes));
            capacity_ = bytes;
            backend_->memory_.add(bytes);
        }
        void* data() const { return data_; }
        size_t capacity() const { return capacity_; }
        void release() {
            cudaFree(data_);
            backend_->memory_.remove(capacity_);
            data_ = nullptr;
            capacity_ = 0;
        }

    private:
        CudaBackend* backend_;
        void* data_ = nullptr;
        size_t capacity_ = 0;
    };

    int ordinal_;
    std::atomic<bool> cancelled_{false};
    MemoryMeter memory_;
    Stream stream_;
    Pinned staging_;     ///< uploads are converted here; reductions arrive here
    ByteBuffer scratch_; ///< CUB's temporary storage
    ByteBuffer result_;  ///< of a reduction
};

/// Device memory that keeps its capacity when it shrinks. Its contents are lost when it grows.
template <class T> class CudaBackend::Buffer {
public:
    explicit Buffer(CudaBackend& backend) : backend_(&backend), bytes_(backend) {}

    void resize(size_t count) {
        bytes_.reserve(count * sizeof(T));
        size_ = count;
    }
    /// Gives the memory back, and the contents up.
    void free() {
        bytes_.release();
        size_ = 0;
    }
    /// Grows to `count` and copies convert(i) to each element, a piece at a time.
    template <class Convert> void upload(size_t count, const Convert& convert) {
        resize(count);
        T* staging = reinterpret_cast<T*>(backend_->staging_.get());
        const size_t piece = staging_bytes / sizeof(T);
        for (size_t first = 0; first < count; first += piece) {
            const size_t n = std::min(piece, count - first);
            for (size_t i = 0; i < n; ++i)
                new (staging + i) T(convert(first + i));
            cuda_check(cudaMemcpyAsync(data() + first, staging, n * sizeof(T), cudaMemcpyHostToDevice, stream()));
            backend_->synchronize();
        }
    }
    /// Becomes a copy of another device's memory.
    void copy_from(CudaBackend& other, std::span<const T> source) {
        resize(source.size());
        if (!source.empty())
            cuda_check(cudaMemcpyPeerAsync(data(), backend_->ordinal_, source.data(), other.ordinal_,
                                           source.size_bytes(), stream()));
    }
    void download(T* out) const {
        if (size_ == 0)
            return;
        cuda_check(cudaMemcpyAsync(out, data(), size_ * sizeof(T), cudaMemcpyDeviceToHost, stream()));
        backend_->synchronize();
    }
    void fill_bytes(int value) {
        if (size_ > 0)
            cuda_check(cudaMemsetAsync(data(), value, size_ * sizeof(T), stream()));
    }
    T read(size_t index) const {
        T value;
        cuda_check(cudaMemcpyAsync(&value, data() + index, sizeof(T), cudaMemcpyDeviceToHost, stream()));
        backend_->synchronize();
        return value;
    }

    std::span<T> view() { return {data(), size_}; }
    size_t size() const { return size_; }
    uint64_t bytes() const { return bytes_.capacity(); }

private:
    friend CudaBackend;
    T* data() const { return static_cast<T*>(bytes_.data()); }
    cudaStream_t stream() const { return backend_->stream_.get(); }

    CudaBackend* backend_;
    ByteBuffer bytes_;
    size_t size_ = 0;
};

/// A moment between two verbs, as the device passes it. Read after a synchronize().
class CudaBackend::Moment {
public:
    explicit Moment(CudaBackend& backend) : backend_(&backend) { cuda_check(cudaEventCreate(&event_)); }
    Moment(const Moment&) = delete;
    Moment& operator=(const Moment&) = delete;
    ~Moment() { cudaEventDestroy(event_); }
    void record() { cuda_check(cudaEventRecord(event_, backend_->stream_.get())); }
    double milliseconds_since(const Moment& other) const {
        float milliseconds = 0;
        cuda_check(cudaEventElapsedTime(&milliseconds, other.event_, event_));
        return milliseconds;
    }

private:
    CudaBackend* backend_;
    cudaEvent_t event_ = nullptr;
};

/// The first element of a buffer on its way to the host: there after the next synchronize().
template <class T> class CudaBackend::Receipt {
public:
    explicit Receipt(CudaBackend& backend) : backend_(&backend), memory_(make_pinned(sizeof(T))) {
        new (memory_.get()) T{};
    }
    void request(const Buffer<T>& from) {
        cuda_check(
            cudaMemcpyAsync(memory_.get(), from.data(), sizeof(T), cudaMemcpyDeviceToHost, backend_->stream_.get()));
    }
    const T& value() const { return *reinterpret_cast<const T*>(memory_.get()); }

private:
    CudaBackend* backend_;
    Pinned memory_;
};

template <class T, class Kernel> T CudaBackend::reduce(uint32_t count, const Kernel& kernel) {
    if (count == 0)
        return T{};
    static_assert(sizeof(T) <= result_bytes);
    result_.reserve(result_bytes);
    size_t bytes = 0;
    const auto run = [&](void* storage) {
        cuda_check(cub::DeviceReduce::TransformReduce(storage, bytes, thrust::counting_iterator<uint32_t>(0),
                                                      static_cast<T*>(result_.data()), count, Combine<T>{}, kernel, T{},
                                                      stream_.get()));
    };
    run(nullptr);
    scratch_.reserve(bytes);
    run(scratch_.data());
    cuda_check(cudaMemcpyAsync(staging_.get(), result_.data(), sizeof(T), cudaMemcpyDeviceToHost, stream_.get()));
    synchronize();
    return *reinterpret_cast<const T*>(staging_.get());
}

} // namespace proxima
