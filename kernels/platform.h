// SPDX-License-Identifier: Apache-2.0
// What differs between a plain C++ compiler and nvcc. Only this file and vector_math.h name __CUDACC__.
#pragma once

/// Marks a function that runs on the host and on the device.
#if defined(__CUDACC__)
#define HD __host__ __device__
#else
#define HD
#endif

/// For the few functions that every ray runs hundreds of times: compilers think them too big to inline.
#if defined(__CUDACC__)
#define HD_INNER __host__ __device__ __forceinline__
#else
#define HD_INNER __attribute__((always_inline)) inline
#endif

/// For what few scenes need: a function of its own, so that it takes no registers and no cache from the others.
#if defined(__CUDACC__)
#define HD_RARE __host__ __device__ __noinline__
#else
#define HD_RARE __attribute__((noinline))
#endif

#include <cstdint>

namespace proxima {

/// Adds `value` to `*counter` atomically and returns what was there before.
HD inline uint32_t atomic_add(uint32_t* counter, uint32_t value) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(counter, value);
#else
    return __atomic_fetch_add(counter, value, __ATOMIC_RELAXED);
#endif
}

HD inline uint64_t atomic_add(uint64_t* counter, uint64_t value) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(reinterpret_cast<unsigned long long*>(counter), static_cast<unsigned long long>(value));
#else
    return __atomic_fetch_add(counter, value, __ATOMIC_RELAXED);
#endif
}

/// Stores `value` atomically and returns what was there before.
HD inline uint32_t atomic_exchange(uint32_t* place, uint32_t value) {
#if defined(__CUDA_ARCH__)
    return atomicExch(place, value);
#else
    return __atomic_exchange_n(place, value, __ATOMIC_RELAXED);
#endif
}

/// Stores `value` atomically if `expected` was there; returns what was there before.
HD inline uint32_t atomic_compare_exchange(uint32_t* place, uint32_t expected, uint32_t value) {
#if defined(__CUDA_ARCH__)
    return atomicCAS(place, expected, value);
#else
    __atomic_compare_exchange_n(place, &expected, value, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED);
    return expected;
#endif
}

/// Sets bits of `*place` atomically.
HD inline void atomic_or(uint32_t* place, uint32_t bits) {
#if defined(__CUDA_ARCH__)
    atomicOr(place, bits);
#else
    __atomic_fetch_or(place, bits, __ATOMIC_RELAXED);
#endif
}

/// The zeros above the highest bit, and below the lowest one; `bits` is not 0.
HD inline int32_t leading_zeros(uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __clz(int(bits));
#else
    return __builtin_clz(bits);
#endif
}
HD inline int32_t trailing_zeros(uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __ffs(int(bits)) - 1;
#else
    return __builtin_ctz(bits);
#endif
}

/// Adds to a counter that all threads add to at the same time: a warp adds as one.
HD inline void count_up(uint64_t* counter, uint32_t amount) {
#if defined(__CUDA_ARCH__)
    const unsigned active = __activemask();
    const uint32_t sum = __reduce_add_sync(active, amount);
    if (threadIdx.x % 32 == unsigned(__ffs(int(active)) - 1) && sum > 0)
        atomic_add(counter, uint64_t(sum));
#else
    if (amount > 0)
        atomic_add(counter, uint64_t(amount));
#endif
}

/// Takes `amount` of what a counter counts, below 2^8 where threads take at the same time, and returns what was there
/// before: a warp takes as one.
HD inline uint64_t take_from(uint64_t* counter, uint32_t amount) {
#if defined(__CUDA_ARCH__)
    if (amount >= 256)
        return atomic_add(counter, uint64_t(amount));
    const unsigned active = __activemask(), below = active & ((1u << threadIdx.x % 32) - 1);
    uint32_t before = 0, sum = 0;
    for (int bit = 0; bit < 8; ++bit) {
        const unsigned with_bit = __ballot_sync(active, amount >> bit & 1);
        before += uint32_t(__popc(with_bit & below)) << bit;
        sum += uint32_t(__popc(with_bit)) << bit;
    }
    const int leader = __ffs(int(active)) - 1;
    uint64_t first = 0;
    if (below == 0)
        first = atomic_add(counter, uint64_t(sum));
    return __shfl_sync(active, first, leader) + before;
#else
    return atomic_add(counter, uint64_t(amount));
#endif
}

/// Reads a value that other threads may store at the same time.
template <class T> HD T load_relaxed(const T* place) {
#if defined(__CUDA_ARCH__)
    return *reinterpret_cast<const volatile T*>(place);
#else
    return __atomic_load_n(place, __ATOMIC_RELAXED);
#endif
}

/// Stores a value that other threads may store at the same time.
template <class T> HD void store_relaxed(T* place, T value) {
#if defined(__CUDA_ARCH__)
    *reinterpret_cast<volatile T*>(place) = value;
#else
    __atomic_store_n(place, value, __ATOMIC_RELAXED);
#endif
}

} // namespace proxima
