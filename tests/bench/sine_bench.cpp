// SPDX-License-Identifier: Apache-2.0
// What sines that are the same on CPU and GPU would cost the motion programs. Usage: sine_bench
#include "renderer/backend_cpu.h"
#include "tests/bench/portable_sine.h"

namespace proxima::bench {
/// The same on the first CUDA device; empty where there is none.
std::vector<double> measure_cuda_sines();
} // namespace proxima::bench

int main() {
    proxima::CpuBackend cpu;
    const std::vector<double> here = proxima::bench::measure_sines(cpu), there = proxima::bench::measure_cuda_sines();
    if (there.empty())
        std::printf("no CUDA device\n");
    else
        std::printf("the portable ones are %s on both\n", here == there ? "the same" : "NOT the same");
    return 0;
}
