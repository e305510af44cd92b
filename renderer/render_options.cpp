// SPDX-License-Identifier: Apache-2.0
#include "renderer/render_options.h"
#include "renderer/errors.h"
#include "renderer/ini_options.h"
#include "renderer/option_values.h"

namespace proxima {
namespace {

FrameSettings read_picture_settings(const RenderTexts& texts, const SceneOptions& scene) {
    FrameSettings frame = read_frame_settings(scene, texts.device);
    frame.samples = parse_count("--samples", texts.samples, 1, 65536);
    frame.antialiasing = parse_antialiasing(texts.antialias);
    if (frame.samples > 1 && frame.antialiasing.method != Antialiasing::Method::none)
        throw UsageError("--samples, --antialias: each says where the rays go; give one of them");
    frame.tolerances = parse_choice<Tolerances>("--tolerances", texts.tolerances,
                                                {{"exact", Tolerances::exact}, {"povray", Tolerances::povray}});
    return frame;
}

/// Everything that decides what is in a frame.
void add_picture_options(CLI::App& command, RenderTexts& texts, const char* doing) {
    add_scene(command, texts.scene);
    add_scene_options(command, texts.scene);
    add_choice_options(command, texts.scene, doing);
    add_shutter_options(command, texts.scene);
    add_override_options(command, texts.scene);
    command.add_option("--samples", texts.samples, "Rays a pixel; 1 is its centre [1]")->type_name("N");
    add_antialias_option(command, texts.antialias);
    add_device_options(command, texts.device);
    command.add_option("--tolerances", texts.tolerances, "exact, or povray to compare with POV-Ray [exact]")
        ->type_name("T");
    add_color_options(command, texts.color);
    command
        .add_option("--max-error", texts.max_error,
                    "Choose the cheapest samples, precision, trace level ... that keep this error: RMS of linear light "
                    "(0.005), or N/255, RMS of displayed 8-bit levels (2/255)")
        ->type_name("E");
}

/// "0.005": RMS of linear light; "2/255": of levels.
QualityRequest read_quality_request(const CLI::App& command, const RenderTexts& texts, const FrameSettings& frame) {
    constexpr std::string_view levels = "/255";
    QualityRequest request{.text = texts.max_error, .limit = {}, .is_verified = texts.verify_error};
    request.limit.most = parse_ratio("--max-error", texts.max_error, "0.005, or 2/255 for levels of a display");
    request.limit.is_levels = std::string_view(texts.max_error).ends_with(levels);
    if (request.limit.is_levels)
        request.limit.most *= 255;
    else if (texts.max_error.find('/') != std::string::npos)
        throw UsageError(fmt::format("--max-error {}: write RMS of linear light like 0.005, or levels of a display "
                                     "like 2/255",
                                     texts.max_error));
    if (request.limit.most == 0)
        throw UsageError(
            fmt::format("--max-error {}: no picture is without error; write more than 0", texts.max_error));
    request.keeps_sampling =
        command.get_option("--samples")->count() > 0 || frame.antialiasing.method != Antialiasing::Method::none;
    request.keeps_precision = command.get_option("--precision")->count() > 0;
    return request;
}

} // namespace

CLI::App* add_render(CLI::App& app, RenderTexts& texts) {
    CLI::App* render = app.add_subcommand("render", "Render a scene into picture files");
    add_picture_options(*render, texts, "render");
    add_multi_gpu_options(*render, texts.multi_gpu);
    add_output_options(*render, texts.output);
    render->add_flag("--verify-error", texts.verify_error,
                     "Render the first frame's reference too, and say the error at its whole size; above --max-error "
                     "the exit code is 4");
    render->add_flag("--list-colorspaces", texts.color.list,
                     "Print the displays, views, looks and colour spaces that there are; needs no SCENE");
    render->footer(
        "Examples:\n"
        "  proxima render ball.scn\n"
        "  proxima render ball.scn -o ball.exr --size 1920x1080 --samples 16\n"
        "  proxima render orbit.scn -o out/orbit.####.png --frames 1-120 --cyclic\n"
        "  proxima render orbit.scn -o out/orbit.####.png --frames 1-120 --cyclic --subset 31-60\n"
        "  proxima render orbit.scn -o out/orbit.####.exr --frames 1-120 --cyclic --shard 2/4 --skip-existing\n"
        "  proxima render orbit.scn -o orbit.gif --frames 1-48 --cyclic\n"
        "  proxima render ball.scn -o ball.png --max-error 2/255 --verify-error\n");
    return render;
}

CLI::App* add_verify(CLI::App& app, RenderTexts& texts) {
    CLI::App* verify = app.add_subcommand("verify", "Check that frames are there, whole, and of this scene");
    add_picture_options(*verify, texts, "check");
    verify->get_option("SCENE")->required();
    verify->add_option("OUT", texts.output.output, "The files, as render's -o has them")->required();
    add_format_options(*verify, texts.output);
    verify->footer(
        "Every option that changes the picture must be as it was for render. Frames by the CPU and by CUDA are "
        "both\nright unless --device says which.\n"
        "Exit codes: 0 all are; 4 some are missing, corrupt or foreign, and listed.\n"
        "Example:\n"
        "  proxima verify orbit.scn out/orbit.####.exr --frames 1-120 --cyclic\n");
    return verify;
}

RenderOptions read_render_options(const CLI::App& command, RenderTexts& texts) {
    if (texts.scene.scene.empty())
        throw UsageError("SCENE is missing; write `proxima render SCENE`, or see `proxima render --help`");
    const IniOptions ini = apply_ini(command, texts.scene);
    apply_ini_rendering(command, ini, texts.scene, texts.device, texts.antialias);
    if (texts.output.output.empty())
        texts.output.output = ini.output;
    take(command, "--bits", texts.output.bits, ini.bits);

    RenderOptions options;
    options.scene = read_scene_options(texts.scene);
    read_output_options(texts.output, !texts.scene.shard.empty(), options);
    options.color = read_color_options(texts.color, options.type, options.movie.has_value());
    options.dither = texts.color.dither;
    options.frame = read_picture_settings(texts, options.scene);
    if (!texts.max_error.empty())
        options.max_error = read_quality_request(command, texts, options.frame);
    else if (texts.verify_error)
        throw UsageError("--verify-error: there is no error to keep; give --max-error too");
    options.frame.aovs = read_layers(texts.output, options);
    options.frame.in_halves = options.type == SampleType::half && options.scene.animation.shutter.samples == 1 &&
                              !options.movie && !options.report && options.color.target == ColorTarget::scene_linear &&
                              options.color.look.empty();
    options.device = parse_device(texts.device.device);
    options.multi_gpu = read_multi_gpu_options(texts.multi_gpu, options.device);
    options.threads = parse_count("--threads", texts.device.threads, 0, 4096);
    return options;
}

VerifyOptions read_verify_options(const CLI::App& command, RenderTexts& texts) {
    VerifyOptions options{read_render_options(command, texts)};
    if (holds_animation(options.render.output->format()))
        throw UsageError(fmt::format("{}: a .gif does not say what it is of; only picture files can be verified",
                                     texts.output.output));
    return options;
}

} // namespace proxima
