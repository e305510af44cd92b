// SPDX-License-Identifier: Apache-2.0
// The frame pipeline on the host's cores.
#include "renderer/backend_cpu.h"
#include "renderer/pipeline_renderer.h"

#include <fstream>

namespace proxima {

std::unique_ptr<FrameRenderer> make_cpu_renderer(unsigned threads, std::shared_ptr<MethodChoice> choice) {
    return std::make_unique<PipelineRenderer<CpuBackend>>(std::move(choice), threads);
}

DeviceDescription describe_cpu(unsigned threads) {
    DeviceDescription description{"cpu", "CPU", 0, ""};
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
            description.name = line.substr(line.find(": ") + 2);
            break;
        }
    description.memory = uint64_t(sysconf(_SC_PHYS_PAGES)) * uint64_t(sysconf(_SC_PAGESIZE));
    const int cores = tbb::info::default_concurrency();
    const int used = threads ? std::min(int(threads), cores) : cores;
    description.note = std::to_string(used) + (used == 1 ? " thread" : " threads");
    return description;
}

} // namespace proxima
