// SPDX-License-Identifier: Apache-2.0
#include "renderer/color_options.h"
#include "renderer/errors.h"

#include <filesystem>
#include <optional>

namespace proxima {

void add_color_options(CLI::App& command, ColorTexts& texts) {
    command.add_option("--display", texts.display, "Display of the colour configuration [its default: sRGB]")
        ->type_name("D");
    command.add_option("--view", texts.view, "View of that display; Raw keeps linear numbers [Un-tone-mapped]")
        ->type_name("V");
    command.add_option("--ocio", texts.ocio, "OpenColorIO configuration [$OCIO, else embedded]")->type_name("FILE");
}

ColorSettings read_color_options(const ColorTexts& texts, SampleType type, bool with_view) {
    if (is_scene_linear(type) && !with_view && !(texts.display.empty() && texts.view.empty()))
        throw UsageError(
            "--display, --view: this file holds scene-linear light, not a view of it; write a .png, or leave "
            "them out");
    return {texts.ocio.empty() ? std::nullopt : std::optional<std::filesystem::path>(texts.ocio), texts.display,
            texts.view};
}

} // namespace proxima
