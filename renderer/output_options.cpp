// SPDX-License-Identifier: Apache-2.0
#include "renderer/output_options.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"

#include <filesystem>
#include <optional>

namespace proxima {
namespace {

OutputName read_output(const OutputTexts& texts, const SceneOptions& scene) {
    const bool still = scene.animation.is_still;
    if (texts.output.empty() && scene.scene == "-")
        throw UsageError("-: a scene from standard input has no name; give -o OUT too");
    if (texts.output.empty())
        return OutputName(scene.scene.stem().string() + (still ? ".png" : ".%04d.png"));
    OutputName output(texts.output);
    if (still && output.has_frame_number())
        throw UsageError(fmt::format("-o {}: a still has no frame number; take '#' or '%d' out of the name, or give "
                                     "--frames A-B",
                                     texts.output));
    if (!still && !output.has_frame_number()) {
        const std::filesystem::path name(texts.output);
        throw UsageError(fmt::format("-o {}: an animation's frames need names of their own; write {}.####{}",
                                     texts.output, (name.parent_path() / name.stem()).string(),
                                     name.extension().string()));
    }
    return output;
}

} // namespace

void add_output_options(CLI::App& command, OutputTexts& texts) {
    command
        .add_option("-o,--output", texts.output,
                    "Picture file: .png .exr .tif .jpg; #### or %04d is the frame [SCENE.png]")
        ->type_name("OUT");
    command.add_option("--bits", texts.bits, "8, 16, half or float a channel [8; half for .exr]")->type_name("B");
    command.add_option("--progress", texts.progress, "auto, plain, json or none, on standard error [auto]")
        ->type_name("STYLE");
    command.add_option("--stats-json", texts.stats_json, "Write what each step cost as JSON")->type_name("FILE");
}

void read_output_options(const OutputTexts& texts, RenderOptions& options) {
    options.output = read_output(texts, options.scene);
    options.type =
        choose_sample_type(options.output->format(), texts.bits.empty() ? std::nullopt : std::optional(texts.bits));
    options.progress = parse_choice<ProgressStyle>("--progress", texts.progress,
                                                   {{"auto", ProgressStyle::automatic},
                                                    {"plain", ProgressStyle::plain},
                                                    {"json", ProgressStyle::json},
                                                    {"none", ProgressStyle::none}});
    if (!texts.stats_json.empty())
        options.stats_json = texts.stats_json;
}

} // namespace proxima
