// SPDX-License-Identifier: Apache-2.0
// A libFuzzer target: any bytes are a scene, which is parsed and evaluated. Nothing may crash, hang or leave the budget.
#include "parser/evaluator.h"

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace proxima;
    ScriptSources sources;
    sources.files.add_text("scene", std::string(reinterpret_cast<const char*>(data), size));
    EvaluationSettings settings;
    settings.budget = {.steps = 20'000, .bytes = 512u << 20, .seconds = 5};
    Diagnostics diagnostics;
    Evaluator(sources, settings, diagnostics).run();
    diagnostics.format(sources.files);
    return 0;
}
