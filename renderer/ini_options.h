// SPDX-License-Identifier: Apache-2.0
// What a POV-Ray .ini says, taken over where the command line says nothing.
#pragma once
#include "renderer/povray_ini.h"
#include "renderer/shared_options.h"

#include <string>

namespace proxima {

/// Takes `value`, of a POV-Ray .ini, unless the command line gives `option` or there is none.
void take(const CLI::App& command, const char* option, std::string& text, std::string value);

/// If SCENE is a POV-Ray .ini, takes from it what the command line does not say about the scene. Throws UsageError and
/// FileError.
IniOptions apply_ini(const CLI::App& command, SceneTexts& texts);

/// The same for what the commands that render have besides.
void apply_ini_rendering(const CLI::App& command, const IniOptions& ini, SceneTexts& scene, DeviceTexts& device,
                         std::string& antialias);

} // namespace proxima
