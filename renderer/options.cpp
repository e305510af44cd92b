// SPDX-License-Identifier: Apache-2.0
#include "renderer/options.h"
#include "renderer/errors.h"
#include "renderer/frame_range.h"
#include "renderer/option_values.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace proxima {
namespace {

/// The options as the user wrote them; empty where absent.
struct SceneTexts {
    std::string scene, size = "640x480", frames, subset, clock;
    std::vector<std::string> include_paths, declares;
    bool cyclic = false;
};

struct DeviceTexts {
    std::string device = "auto", accelerator = "auto", grid = "auto", precision = "float", threads = "0";
};

struct RenderTexts {
    SceneTexts scene;
    DeviceTexts device;
    std::string output, samples = "1", tolerances = "exact", display, view, bits, ocio, progress = "auto", stats_json;
};

struct CompareTexts {
    SceneTexts scene; ///< `scene` is A
    DeviceTexts device{.precision = "double"};
    std::string b, tolerance, allow = "0", heatmap, report, json, time_limit = "600";
    bool povray = false, linear = false;
};

void add_scene(CLI::App& command, SceneTexts& texts) {
    command.add_option("SCENE", texts.scene, "The scene file")->required();
}

void add_scene_options(CLI::App& command, SceneTexts& texts) {
    command.add_option("--size", texts.size, "Width x height in pixels [640x480]")->type_name("WxH");
    command.add_option("--frames", texts.frames, "The animation: sets clock and numbering (1-100, 1-100x2, 1,3,5..9)")
        ->type_name("RANGE");
    command.add_option("--clock", texts.clock, "A still's clock, or an animation's first and last [0:1]")
        ->type_name("V|A:B");
    command.add_flag("--cyclic", texts.cyclic, "The clock stops one step short of its last value");
    command.add_option("--declare", texts.declares, "Declares NAME before the scene is read; repeatable")
        ->type_name("NAME=VALUE")
        ->expected(1)
        ->take_all();
    command.add_option("--include-path", texts.include_paths, "Folder for #include, after the scene's; repeatable")
        ->type_name("DIR")
        ->expected(1)
        ->take_all();
}

void add_device_options(CLI::App& command, DeviceTexts& texts) {
    command.add_option("--device", texts.device, "auto, cpu, cuda or cuda:N [auto: a CUDA device if there is one]")
        ->type_name("DEVICE");
    command.add_option("--accel", texts.accelerator, "How rays find spheres: auto, grid, brute [auto]")
        ->type_name("METHOD");
    command.add_option("--grid", texts.grid, "Voxels along each axis [auto: chosen from the scene]")
        ->type_name("N|NxNxN");
    command.add_option("--precision", texts.precision, "float or double [" + texts.precision + "]")->type_name("P");
    command.add_option("--threads", texts.threads, "CPU threads [0: all cores]")->type_name("N");
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

constexpr const char* povray_group = "With --povray";

CLI::App* add_compare(CLI::App& app, CompareTexts& texts) {
    CLI::App* compare = app.add_subcommand("compare", "Compare two pictures, two sequences, or POV-Ray with Proxima");
    add_scene_options(*compare, texts.scene);
    add_device_options(*compare, texts.device);
    compare->add_option("--subset", texts.scene.subset, "The frames of --frames to compare now [all]")
        ->type_name("RANGE");
    compare->add_option("--time-limit", texts.time_limit, "Seconds that POV-Ray has for a frame [600]")->type_name("S");
    for (CLI::Option* option : compare->get_options())
        if (option != compare->get_help_ptr())
            option->group(povray_group);
    compare->get_option("--frames")
        ->group("Options")
        ->description("The animation; of two sequences the frames to compare");
    compare->get_option("--threads")->group("Options");

    compare
        ->add_option("A", texts.scene.scene, "A picture, a sequence like a.####.exr, a folder; a scene with --povray")
        ->required();
    compare->add_option("B", texts.b, "What to compare it with");
    compare->add_flag("--povray", texts.povray, "Render the scene A with POV-Ray and with Proxima");
    compare->add_option("--tolerance", texts.tolerance, "Largest error that is equal; white is 1 [0; --povray 2/65535]")
        ->type_name("T");
    compare->add_option("--allow", texts.allow, "Percent of the pixels that may be over the tolerance [0]")
        ->type_name("P");
    compare->add_flag("--linear", texts.linear, "Decode sRGB and gamma levels to linear light first");
    compare->add_option("--heatmap", texts.heatmap, "Write A, B and their difference side by side")->type_name("H.png");
    compare->add_option("--report", texts.report, "Write a page with all pairs and their pictures")->type_name("DIR");
    compare->add_option("--json", texts.json, "Write the figures as JSON")->type_name("FILE");
    compare->footer(
        "Files of 8 and 16 bits are compared by their levels as stored (8 bits times 257 beside 16), half\n"
        "and float files by their numbers. Size and encoding must agree; alpha is compared where both have\n"
        "it and must be opaque where one has it. A pixel that is not finite is never equal.\n"
        "Exit codes: 0 equal, 4 a difference, 3 a file could not be read, 2 the command line is wrong.\n"
        "Examples:\n"
        "  proxima compare a.png b.png --tolerance 1/255 --heatmap difference.png\n"
        "  proxima compare 'a.####.exr' 'b.####.exr' --tolerance 0.001 --report report\n"
        "  proxima compare ball.scn --povray --size 320x240\n");
    return compare;
}

Animation read_animation(const SceneTexts& texts) {
    const bool has_clock = !texts.clock.empty();
    const ClockValues clock = has_clock ? parse_clock(texts.clock) : ClockValues{};
    if (texts.frames.empty()) {
        if (!texts.subset.empty())
            throw UsageError("--subset: it chooses from an animation's frames; give --frames A-B too");
        if (texts.cyclic)
            throw UsageError("--cyclic: only an animation goes round; give --frames A-B too");
        if (clock.final)
            throw UsageError(
                fmt::format("--clock {}: a still has one clock; write --clock {}, or give --frames A-B too",
                            texts.clock, clock.initial));
        return Animation::still(has_clock ? std::optional(clock.initial) : std::nullopt);
    }
    if (has_clock && !clock.final)
        throw UsageError(fmt::format("--clock {0}: an animation's clock is a range; write --clock 0:{0}", texts.clock));

    const std::vector<int64_t> all = parse_frame_range("--frames", texts.frames);
    std::vector<int64_t> frames = texts.subset.empty() ? all : parse_frame_range("--subset", texts.subset);
    const std::unordered_set<int64_t> known(all.begin(), all.end());
    for (const int64_t frame : frames)
        if (!known.contains(frame))
            throw UsageError(
                fmt::format("--subset {}: frame {} is not one of --frames {}; --frames is the whole animation",
                            texts.subset, frame, texts.frames));
    Animation animation = Animation::sequence(all, std::move(frames));
    animation.cyclic = texts.cyclic;
    if (clock.final) {
        animation.initial_clock = clock.initial;
        animation.final_clock = *clock.final;
    }
    return animation;
}

SceneOptions read_scene_options(const SceneTexts& texts) {
    SceneOptions options;
    options.scene = texts.scene;
    options.include_paths.assign(texts.include_paths.begin(), texts.include_paths.end());
    for (const std::string& declare : texts.declares)
        options.declares.push_back(parse_declare(declare));
    std::tie(options.width, options.height) = parse_size(texts.size);
    options.animation = read_animation(texts);
    return options;
}

OutputName read_output(const RenderTexts& texts, const SceneOptions& scene) {
    const bool still = scene.animation.is_still;
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

FrameSettings read_frame_settings(const SceneOptions& scene, const DeviceTexts& texts) {
    FrameSettings frame{.width = scene.width, .height = scene.height};
    frame.precision = parse_choice<Precision>("--precision", texts.precision,
                                              {{"float", Precision::float32}, {"double", Precision::float64}});
    frame.accelerator = parse_choice<Accelerator>(
        "--accel", texts.accelerator,
        {{"auto", Accelerator::automatic}, {"grid", Accelerator::grid}, {"brute", Accelerator::brute}});
    if (texts.grid != "auto")
        frame.grid = parse_grid(texts.grid);
    return frame;
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

/// The side of compare that renders.
void read_programs(const CompareTexts& texts, CompareOptions& options) {
    if (!texts.b.empty())
        throw UsageError(fmt::format("{}: --povray compares one scene with itself; leave B out", texts.b));
    options.scene = read_scene_options(texts.scene);
    if (options.scene.animation.has_no_step())
        throw UsageError(fmt::format("--frames {}: POV-Ray has no clock in an animation of one frame; give the whole "
                                     "animation and choose with --subset, or a still's --clock",
                                     texts.scene.frames));
    options.frame = read_frame_settings(options.scene, texts.device);
    options.frame.tolerances = Tolerances::povray;
    options.device = parse_device(texts.device.device);
    options.time_limit = double(parse_count("--time-limit", texts.time_limit, 1, 1'000'000));
}

CompareOptions read_compare_options(const CLI::App& command, const CompareTexts& texts) {
    CompareOptions options;
    options.povray = texts.povray;
    options.linear = texts.linear;
    if (texts.povray) {
        read_programs(texts, options);
    } else {
        for (const CLI::Option* option : command.get_options())
            if (option->get_group() == povray_group && option->count() > 0)
                throw UsageError(
                    fmt::format("{}: only --povray renders; pictures are compared as they are", option->get_name()));
        if (texts.b.empty())
            throw UsageError(fmt::format("{}: there is nothing to compare it with; write A and B, or --povray after a "
                                         "scene",
                                         texts.scene.scene));
        options.a = texts.scene.scene;
        options.b = texts.b;
        if (!texts.scene.frames.empty())
            options.frames = parse_frame_range("--frames", texts.scene.frames);
    }
    options.threads = parse_count("--threads", texts.device.threads, 0, 4096);
    options.tolerance = texts.tolerance.empty() ? (texts.povray ? 2.0 / 65535 : 0) : parse_tolerance(texts.tolerance);
    options.allowed_share = parse_percent("--allow", texts.allow);
    const auto path = [](const std::string& text) {
        return text.empty() ? std::nullopt : std::optional<std::filesystem::path>(text);
    };
    if (!texts.heatmap.empty() && std::filesystem::path(texts.heatmap).extension() != ".png")
        throw UsageError(fmt::format("--heatmap {}: it is a PNG; end the name in .png", texts.heatmap));
    options.heatmap = path(texts.heatmap);
    options.report = path(texts.report);
    options.json = path(texts.json);
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
    if (render->parsed())
        return read_render_options(render_texts);
    if (compare->parsed())
        return read_compare_options(*compare, compare_texts);
    if (check->parsed())
        return CheckOptions{read_scene_options(check_texts)};
    if (!devices->parsed())
        throw UsageError("no command; write `proxima render SCENE`, or see `proxima --help`");
    return devices_options;
}

} // namespace proxima
