// SPDX-License-Identifier: Apache-2.0
#include "parser/scene_script.h"

#include "parser/evaluator.h"

#include <algorithm>
#include <fmt/format.h>

namespace proxima {

TokenProgram* ScriptSources::program(uint32_t file, Diagnostics& diagnostics) {
    if (programs.size() <= file)
        programs.resize(file + 1);
    if (!programs[file])
        programs[file] = std::make_unique<TokenProgram>(parse_text(files, file, symbols, diagnostics));
    return programs[file]->valid ? programs[file].get() : nullptr;
}

uint32_t ScriptSources::standard_file(const StandardFile& file) {
    const auto known = std::ranges::find(standard, &file);
    if (known != standard.end())
        return uint32_t(known - standard.begin());
    const uint32_t index = files.add_text(fmt::format("{} (built in)", file.name), standard_text(file));
    standard.resize(index + 1);
    standard[index] = &file;
    return index;
}

struct SceneScript::Implementation {
    ScriptSources sources;
};

SceneScript::SceneScript(const std::filesystem::path& path, std::vector<std::filesystem::path> include_paths,
                         Diagnostics& diagnostics)
    : implementation_(std::make_unique<Implementation>()) {
    ScriptSources& sources = implementation_->sources;
    sources.program(sources.files.open_scene(path, std::move(include_paths)), diagnostics);
}

SceneScript::~SceneScript() = default;
SceneScript::SceneScript(SceneScript&&) noexcept = default;

SceneProgram SceneScript::evaluate(const EvaluationSettings& settings, Diagnostics& diagnostics) {
    return Evaluator(implementation_->sources, settings, diagnostics).run();
}

const SourceFiles& SceneScript::files() const {
    return implementation_->sources.files;
}

} // namespace proxima
