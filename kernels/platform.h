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

/// Stores a value that other threads may store at the same time.
template <class T> HD void store_relaxed(T* place, T value) {
#if defined(__CUDA_ARCH__)
    *reinterpret_cast<volatile T*>(place) = value;
#else
    __atomic_store_n(place, value, __ATOMIC_RELAXED);
#endif
}

} // namespace proxima
