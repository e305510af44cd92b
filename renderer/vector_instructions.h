// SPDX-License-Identifier: Apache-2.0
// Kernels compiled a second time for the vector instructions that most x86-64 processors have but not all, chosen where
// they run. Arithmetic stays what it was: nothing is contracted, and no order changes.
#pragma once
#include <cstdint>

namespace proxima {

#if defined(__x86_64__) && defined(__GNUC__)

template <class Kernel> [[gnu::target("avx2"), gnu::flatten]] void run_with_avx2(const Kernel& kernel, uint32_t index) {
    kernel(index);
}
inline bool has_avx2() {
    static const bool has = __builtin_cpu_supports("avx2") > 0;
    return has;
}
template <class Kernel> void run_with_vectors(const Kernel& kernel, uint32_t index) {
    if (has_avx2())
        run_with_avx2(kernel, index);
    else
        kernel(index);
}

#else

template <class Kernel> void run_with_vectors(const Kernel& kernel, uint32_t index) {
    kernel(index);
}

#endif

} // namespace proxima
