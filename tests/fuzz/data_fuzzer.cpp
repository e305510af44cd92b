// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes are a data file, which is read to its end or to its first mistake.
#include "parser/data_file.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace proxima;
    DataFile file({reinterpret_cast<const char*>(data), size}, 0);
    try {
        for (Value value; file.read(value) && !file.ended();) {
        }
    } catch (const SceneError&) {
    }
    return 0;
}
