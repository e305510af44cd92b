// SPDX-License-Identifier: Apache-2.0
#include "renderer/ini_options.h"
#include "renderer/errors.h"

#include <utility>

namespace proxima {

void take(const CLI::App& command, const char* option, std::string& text, std::string value) {
    if (command.count(option) == 0 && !value.empty())
        text = std::move(value);
}

IniOptions apply_ini(const CLI::App& command, SceneTexts& texts) {
    if (!is_povray_ini(texts.scene))
        return {};
    IniOptions ini = read_povray_ini(texts.scene);
    texts.scene = ini.scene;
    take(command, "--size", texts.size, ini.size);
    take(command, "--clock", texts.clock, ini.clock);
    if (command.count("--frames") == 0) {
        texts.frames = ini.frames;
        texts.cyclic = texts.cyclic || ini.cyclic;
    }
    texts.declares.insert(texts.declares.begin(), ini.declares.begin(), ini.declares.end()); // the last one counts
    texts.include_paths.insert(texts.include_paths.end(), ini.include_paths.begin(), ini.include_paths.end());
    return ini;
}

void apply_ini_rendering(const CLI::App& command, const IniOptions& ini, SceneTexts& scene, DeviceTexts& device,
                         std::string& antialias) {
    if (command.count("--frames") == 0)
        take(command, "--subset", scene.subset, ini.subset);
    take(command, "--threads", device.threads, ini.threads);
    const bool has_samples = command.get_option_no_throw("--samples") && command.count("--samples") > 0;
    if (has_samples || command.count("--antialias") > 0)
        return;
    if (!ini.antialias_refusal.empty())
        throw UsageError(ini.antialias_refusal);
    take(command, "--antialias", antialias, ini.antialias);
}

} // namespace proxima
