// SPDX-License-Identifier: Apache-2.0
#include "renderer/output_options.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"

#include <filesystem>
#include <optional>

namespace proxima {
namespace {

std::optional<std::string> given(const std::string& text) {
    return text.empty() ? std::nullopt : std::optional(text);
}

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
    if (holds_animation(output.format()) && output.has_frame_number())
        throw UsageError(
            fmt::format("-o {}: a .gif holds all frames; take the frame number out of its name", texts.output));
    if (!still && !output.has_frame_number() && !holds_animation(output.format())) {
        const std::filesystem::path name(texts.output);
        throw UsageError(fmt::format("-o {}: an animation's frames need names of their own; write {}.####{}",
                                     texts.output, (name.parent_path() / name.stem()).string(),
                                     name.extension().string()));
    }
    return output;
}

std::optional<std::filesystem::path> read_movie(const OutputTexts& texts, const RenderOptions& options) {
    if (texts.movie.empty())
        return std::nullopt;
    if (options.scene.animation.is_still)
        throw UsageError(fmt::format("--movie {}: a still does not move; give --frames A-B too", texts.movie));
    if (holds_animation(options.output->format()))
        throw UsageError(
            fmt::format("--movie {}: a film is made of picture files; write -o OUT.####.png", texts.movie));
    return texts.movie;
}

} // namespace

void add_format_options(CLI::App& command, OutputTexts& texts) {
    command.add_option("--bits", texts.bits, "8, 16, half or float a channel [8; half for .exr]")->type_name("B");
    command
        .add_option("--compression", texts.compression,
                    "Of .exr: zip, zips, piz, none, or dwaa, which loses a little [zip]")
        ->type_name("C");
    command
        .add_option("--aov", texts.aov,
                    "Layers in the .exr too, some of depth,normal,id,steps: channels Z, N.X N.Y N.Z, id, steps")
        ->type_name("LIST");
    command
        .add_option("--fps", texts.fps,
                    "Frames a second, for --movie, .gif and .exr headers: 24, 29.97, 30000/1001 [24]")
        ->type_name("F");
}

void add_output_options(CLI::App& command, OutputTexts& texts) {
    command
        .add_option("-o,--output", texts.output,
                    "Picture file: .png .exr .tif .jpg; #### or %04d is the frame; .gif for a whole animation "
                    "[SCENE.png]")
        ->type_name("OUT");
    add_format_options(command, texts);
    command.add_option("--movie", texts.movie, "Make a film of the frames too, by ffmpeg: .mp4 or .webm")
        ->type_name("FILE");
    command.add_flag("--skip-existing", texts.skip_existing,
                     "Keep files that are whole and just what this run would write");
    command.add_flag("--dry-run", texts.dry_run, "Print the frames and their files, and render nothing");
    command
        .add_option("--progress", texts.progress, "auto, bar, plain, json, openjd or none, on standard error [auto]")
        ->type_name("STYLE");
    command.add_option("--stats-json", texts.stats_json, "Write what each step cost as JSON")->type_name("FILE");
    command.add_option("--timeline", texts.timeline, "Draw what ran when, on which device: .svg")->type_name("FILE");
    command
        .add_option("--report", texts.report,
                    "Write a page with the frames, what they took, what was chosen and what went wrong")
        ->type_name("DIR");
}

void read_output_options(const OutputTexts& texts, bool is_part, RenderOptions& options) {
    options.output = read_output(texts, options.scene);
    if (holds_animation(options.output->format()) && is_part)
        throw UsageError(
            fmt::format("-o {}: a .gif holds all frames at once; render parts to -o OUT.####.png", texts.output));
    if (holds_animation(options.output->format()) && texts.skip_existing)
        throw UsageError(
            fmt::format("--skip-existing: a .gif does not say what it is of; leave it out, or write -o OUT.####.png"));
    if (is_part && !texts.movie.empty())
        throw UsageError(
            fmt::format("--movie {0}: a part has not all frames; when all parts are there, run once more with "
                        "--skip-existing --movie {0} and without --shard",
                        texts.movie));
    options.type = choose_sample_type(options.output->format(), given(texts.bits));
    options.compression = choose_compression(options.output->format(), given(texts.compression));
    if (!texts.fps.empty())
        options.rate = parse_frame_rate(texts.fps);
    options.dry_run = texts.dry_run;
    options.skip_existing = texts.skip_existing;
    options.movie = read_movie(texts, options);
    options.progress = parse_choice<ProgressStyle>("--progress", texts.progress,
                                                   {{"auto", ProgressStyle::automatic},
                                                    {"bar", ProgressStyle::bar},
                                                    {"openjd", ProgressStyle::openjd},
                                                    {"plain", ProgressStyle::plain},
                                                    {"json", ProgressStyle::json},
                                                    {"none", ProgressStyle::none}});
    if (!texts.stats_json.empty())
        options.stats_json = texts.stats_json;
    if (!texts.timeline.empty())
        options.timeline = texts.timeline;
    if (!texts.report.empty())
        options.report = texts.report;
}

AovLayers read_layers(const OutputTexts& texts, const RenderOptions& options) {
    if (texts.aov.empty())
        return {};
    const AovLayers layers = parse_layers(texts.aov);
    if (options.output->format() != ImageFormat::exr)
        throw UsageError(fmt::format("--aov {}: only .exr files hold layers; write -o OUT.exr", texts.aov));
    if (layers.normal && options.compression == Compression::dwaa)
        throw UsageError(fmt::format("--aov {}: dwaa takes N.Y for a luminance and loses a part of it; choose another "
                                     "--compression, or leave normal out",
                                     texts.aov));
    return layers;
}

} // namespace proxima
