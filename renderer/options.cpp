// SPDX-License-Identifier: Apache-2.0
#include "renderer/options.h"
#include "renderer/compare_options.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"
#include "renderer/povray_ini.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

namespace proxima {
namespace {

struct RenderTexts {
    SceneTexts scene;
    DeviceTexts device;
    std::string output, samples = "1", antialias = "none", tolerances = "exact", display, view, bits, ocio,
                        progress = "auto", stats_json;
};

void add_scene(CLI::App& command, SceneTexts& texts) {
    command.add_option("SCENE", texts.scene, "The scene file, - for standard input, or a POV-Ray .ini")->required();
}

CLI::App* add_render(CLI::App& app, RenderTexts& texts) {
    CLI::App* render = app.add_subcommand("render", "Render a scene into picture files");
    add_scene(*render, texts.scene);
    add_scene_options(*render, texts.scene);
    render
        ->add_option("-o,--output", texts.output,
                     "Picture file: .png .exr .tif .jpg; #### or %04d is the frame [SCENE.png]")
        ->type_name("OUT");
    render->add_option("--subset", texts.scene.subset, "The frames of --frames to render now [all]")
        ->type_name("RANGE");
    render->add_option("--samples", texts.samples, "Rays a pixel; 1 is its centre [1]")->type_name("N");
    add_antialias_option(*render, texts.antialias);
    add_device_options(*render, texts.device);
    render->add_option("--tolerances", texts.tolerances, "exact, or povray to compare with POV-Ray [exact]")
        ->type_name("T");
    render->add_option("--bits", texts.bits, "8, 16, half or float a channel [8; half for .exr]")->type_name("B");
    render->add_option("--display", texts.display, "Display of the colour configuration [its default: sRGB]")
        ->type_name("D");
    render->add_option("--view", texts.view, "View of that display; Raw keeps linear numbers [Un-tone-mapped]")
        ->type_name("V");
    render->add_option("--ocio", texts.ocio, "OpenColorIO configuration [$OCIO, else embedded]")->type_name("FILE");
    render->add_option("--progress", texts.progress, "auto, plain, json or none, on standard error [auto]")
        ->type_name("STYLE");
    render->add_option("--stats-json", texts.stats_json, "Write what each step cost as JSON")->type_name("FILE");
    render->footer("Examples:\n"
                   "  proxima render ball.scn\n"
                   "  proxima render ball.scn -o ball.exr --size 1920x1080 --samples 16\n"
                   "  proxima render orbit.scn -o out/orbit.####.png --frames 1-120 --cyclic\n"
                   "  proxima render orbit.scn -o out/orbit.####.png --frames 1-120 --cyclic --subset 31-60\n");
    return render;
}

/// Takes a text of a POV-Ray .ini unless the command line gives that option.
void take(const CLI::App& command, const char* option, std::string& text, std::string value) {
    if (command.count(option) == 0 && !value.empty())
        text = std::move(value);
}

/// Takes from a POV-Ray .ini, if SCENE is one, what the command line does not say about the scene.
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

/// The same for what the commands that render have besides.
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

OutputName read_output(const RenderTexts& texts, const SceneOptions& scene) {
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

RenderOptions read_render_options(const RenderTexts& texts) {
    RenderOptions options;
    options.scene = read_scene_options(texts.scene);
    options.output = read_output(texts, options.scene);
    options.type =
        choose_sample_type(options.output->format(), texts.bits.empty() ? std::nullopt : std::optional(texts.bits));
    if (is_scene_linear(options.type) && !(texts.display.empty() && texts.view.empty()))
        throw UsageError(
            "--display, --view: this file holds scene-linear light, not a view of it; write a .png, or leave "
            "them out");
    options.color = {texts.ocio.empty() ? std::nullopt : std::optional<std::filesystem::path>(texts.ocio),
                     texts.display, texts.view};

    options.frame = read_frame_settings(options.scene, texts.device);
    options.frame.samples = parse_count("--samples", texts.samples, 1, 65536);
    options.frame.antialiasing = parse_antialiasing(texts.antialias);
    if (options.frame.samples > 1 && options.frame.antialiasing.method != Antialiasing::Method::none)
        throw UsageError("--samples, --antialias: each says where the rays go; give one of them");
    options.frame.tolerances = parse_choice<Tolerances>("--tolerances", texts.tolerances,
                                                        {{"exact", Tolerances::exact}, {"povray", Tolerances::povray}});
    options.device = parse_device(texts.device.device);
    options.threads = parse_count("--threads", texts.device.threads, 0, 4096);
    options.progress = parse_choice<ProgressStyle>("--progress", texts.progress,
                                                   {{"auto", ProgressStyle::automatic},
                                                    {"plain", ProgressStyle::plain},
                                                    {"json", ProgressStyle::json},
                                                    {"none", ProgressStyle::none}});
    if (!texts.stats_json.empty())
        options.stats_json = texts.stats_json;
    return options;
}

/// CLI11 would only say that a command is missing.
void check_command_name(int argc, const char* const* argv) {
    static constexpr std::string_view names[] = {"render", "compare", "check", "devices"};
    const std::string_view name = argc > 1 ? argv[1] : "";
    if (name.starts_with('-') || std::find(std::begin(names), std::end(names), name) != std::end(names))
        return;
    if (name.empty())
        throw UsageError("no command; write `proxima render SCENE`, or see `proxima --help`");
    const std::string near = nearest_name(name, names);
    throw UsageError(fmt::format("'{}' is no command; write one of {}{}", name, fmt::join(names, ", "),
                                 near.empty() ? "" : fmt::format("; did you mean {}?", near)));
}

} // namespace

Command parse_command_line(int argc, const char* const* argv) {
    CLI::App app("Proxima renders scenes of spheres, written in a strict subset of POV-Ray's language.", "proxima");
    app.set_version_flag("--version", "proxima " PROXIMA_VERSION);
    app.require_subcommand(0, 1);
    app.footer("`proxima COMMAND --help` tells more.\n"
               "Exit codes: 0 done; 1 the scene is wrong; 2 the command line is wrong; 3 a file could not be read or\n"
               "written; 4 compare found a difference; 33 out of memory; 75 a device was lost, try again elsewhere;\n"
               "128+n after signal n.\n");

    RenderTexts render_texts;
    SceneTexts check_texts;
    DevicesOptions devices_options;
    const CLI::App* render = add_render(app, render_texts);
    CompareTexts compare_texts;
    const CLI::App* compare = add_compare(app, compare_texts);
    CLI::App* check = app.add_subcommand("check", "Read a scene, report every mistake, count what is in it");
    add_scene(*check, check_texts);
    add_scene_options(*check, check_texts);
    CLI::App* devices = app.add_subcommand("devices", "List what can render");
    devices->add_flag("--json", devices_options.json, "As JSON");

    check_command_name(argc, argv);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        return Information{app.help()};
    } catch (const CLI::CallForVersion& version) {
        return Information{std::string(version.what()) + '\n'};
    } catch (const CLI::ParseError& error) {
        throw UsageError(fmt::format("{}; `proxima --help` shows what can be written", error.what()));
    }
    if (render->parsed()) {
        const IniOptions ini = apply_ini(*render, render_texts.scene);
        apply_ini_rendering(*render, ini, render_texts.scene, render_texts.device, render_texts.antialias);
        take(*render, "--output", render_texts.output, ini.output);
        take(*render, "--bits", render_texts.bits, ini.bits);
        return read_render_options(render_texts);
    }
    if (compare->parsed()) {
        if (compare_texts.povray) {
            const IniOptions ini = apply_ini(*compare, compare_texts.scene);
            apply_ini_rendering(*compare, ini, compare_texts.scene, compare_texts.device, compare_texts.antialias);
        }
        return read_compare_options(*compare, compare_texts);
    }
    if (check->parsed()) {
        apply_ini(*check, check_texts);
        return CheckOptions{read_scene_options(check_texts)};
    }
    if (!devices->parsed())
        throw UsageError("no command; write `proxima render SCENE`, or see `proxima --help`");
    return devices_options;
}

} // namespace proxima
