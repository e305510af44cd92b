// SPDX-License-Identifier: Apache-2.0
#include "parser/scene_script.h"

#include "parser/evaluator.h"

namespace proxima {

TokenProgram* ScriptSources::program(uint32_t file, Diagnostics& diagnostics) {
    if (programs.size() <= file)
        programs.resize(file + 1);
    if (!programs[file])
        programs[file] = std::make_unique<TokenProgram>(parse_text(files, file, symbols, diagnostics));
    return programs[file]->valid ? programs[file].get() : nullptr;
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
