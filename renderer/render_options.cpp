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

} // namespace

CLI::App* add_render(CLI::App& app, RenderTexts& texts) {
    CLI::App* render = app.add_subcommand("render", "Render a scene into picture files");
    add_scene(*render, texts.scene);
    add_scene_options(*render, texts.scene);
    add_choice_options(*render, texts.scene, "render");
    render->add_option("--samples", texts.samples, "Rays a pixel; 1 is its centre [1]")->type_name("N");
    add_antialias_option(*render, texts.antialias);
    add_device_options(*render, texts.device);
    add_multi_gpu_options(*render, texts.multi_gpu);
    render->add_option("--tolerances", texts.tolerances, "exact, or povray to compare with POV-Ray [exact]")
        ->type_name("T");
    add_output_options(*render, texts.output);
    add_color_options(*render, texts.color);
    render->footer("Examples:\n"
                   "  proxima render ball.scn\n"
                   "  proxima render ball.scn -o ball.exr --size 1920x1080 --samples 16\n"
                   "  proxima render orbit.scn -o out/orbit.####.png --frames 1-120 --cyclic\n"
                   "  proxima render orbit.scn -o out/orbit.####.png --frames 1-120 --cyclic --subset 31-60\n");
    return render;
}

RenderOptions read_render_options(const CLI::App& command, RenderTexts& texts) {
    const IniOptions ini = apply_ini(command, texts.scene);
    apply_ini_rendering(command, ini, texts.scene, texts.device, texts.antialias);
    take(command, "--output", texts.output.output, ini.output);
    take(command, "--bits", texts.output.bits, ini.bits);

    RenderOptions options;
    options.scene = read_scene_options(texts.scene);
    read_output_options(texts.output, options);
    options.color = read_color_options(texts.color, options.type, options.movie.has_value());
    options.frame = read_picture_settings(texts, options.scene);
    options.device = parse_device(texts.device.device);
    options.multi_gpu = read_multi_gpu_options(texts.multi_gpu, options.device);
    options.threads = parse_count("--threads", texts.device.threads, 0, 4096);
    return options;
}

} // namespace proxima
