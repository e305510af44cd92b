// SPDX-License-Identifier: Apache-2.0
#include "renderer/color_options.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"

namespace proxima {

void add_color_options(CLI::App& command, ColorTexts& texts) {
    command.add_option("--display", texts.display, "Display of the colour configuration [its default: sRGB]")
        ->type_name("D");
    command.add_option("--view", texts.view, "View of that display; Raw keeps linear numbers [Un-tone-mapped]")
        ->type_name("V");
    command.add_option("--look", texts.look, "Look of that configuration, applied before the view [none]")
        ->type_name("L");
    command
        .add_option("--colorspace", texts.space,
                    "Write numbers of this colour space instead of a view; .exr files too [the working space]")
        ->type_name("C");
    command
        .add_option("--working-space", texts.working_space,
                    "What a scene's red, green and blue mean: rec709 or acescg, linear [rec709]")
        ->type_name("W");
    command.add_option("--ocio", texts.ocio, "OpenColorIO configuration [$OCIO, else embedded]")->type_name("FILE");
    command.add_flag("--dither", texts.dither, "Round to 8 and 16 bits up or down by chance, the same in every run");
}

ColorSettings read_color_options(const ColorTexts& texts, SampleType type, bool with_view) {
    ColorSettings settings{.display = texts.display, .view = texts.view, .look = texts.look, .space = texts.space};
    if (!texts.ocio.empty())
        settings.config = texts.ocio;
    settings.working_space = parse_choice<WorkingSpace>(
        "--working-space", texts.working_space, {{"rec709", WorkingSpace::rec709}, {"acescg", WorkingSpace::acescg}});
    const bool names_view = !(texts.display.empty() && texts.view.empty());
    if (!texts.space.empty() && (names_view || with_view))
        throw UsageError(fmt::format("--colorspace {}: the files hold either a colour space or a view of a display; "
                                     "leave out --display, --view and --movie",
                                     texts.space));
    if (is_scene_linear(type) && texts.space.empty() && !with_view && (names_view || !texts.look.empty()))
        throw UsageError(
            "--display, --view, --look: this file holds scene-linear light, not a view of it; write a .png, "
            "name a --colorspace, or leave them out");
    if (is_scene_linear(type) && texts.dither)
        throw UsageError("--dither: half and float numbers are not rounded to levels; leave it out");
    settings.target = !texts.space.empty()    ? ColorTarget::space
                      : is_scene_linear(type) ? ColorTarget::scene_linear
                                              : ColorTarget::view;
    return settings;
}

} // namespace proxima
