// SPDX-License-Identifier: Apache-2.0
// Runs the GPU tests, or says why it cannot and leaves with the code that ctest takes for "skipped".
#define DOCTEST_CONFIG_IMPLEMENT
#include "renderer/frame_renderer.h"

#include <cstdio>
#include <doctest/doctest.h>

int main(int argc, char** argv) {
    constexpr int skipped = 77;
    std::string reason;
    const auto devices = proxima::list_cuda_devices(reason);
    if (devices.empty()) {
        std::printf("skipped: GPU tests: %s\n", reason.c_str());
        return skipped;
    }
    for (const proxima::DeviceDescription& device : devices)
        std::printf("%s: %s, %s\n", device.id.c_str(), device.name.c_str(), device.note.c_str());
    return doctest::Context(argc, argv).run();
}
