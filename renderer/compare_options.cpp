// SPDX-License-Identifier: Apache-2.0
#include "renderer/compare_options.h"
#include "renderer/errors.h"
#include "renderer/frame_range.h"
#include "renderer/option_values.h"

namespace proxima {
namespace {

constexpr const char* povray_group = "With --povray";

/// The side of compare that renders.
void read_programs(const CompareTexts& texts, CompareOptions& options) {
    if (!texts.b.empty())
        throw UsageError(fmt::format("{}: --povray compares one scene with itself; leave B out", texts.b));
    if (texts.scene.scene == "-")
        throw UsageError("-: two programs cannot read one standard input; save the scene in a file");
    options.scene = read_scene_options(texts.scene);
    if (options.scene.animation.has_no_step())
        throw UsageError(fmt::format("--frames {}: POV-Ray has no clock in an animation of one frame; give the whole "
                                     "animation and choose with --subset, or a still's --clock",
                                     texts.scene.frames));
    options.frame = read_frame_settings(options.scene, texts.device);
    options.frame.tolerances = Tolerances::povray;
    options.frame.antialiasing = parse_antialiasing(texts.antialias);
    if (options.frame.antialiasing.depth > 9)
        throw UsageError(fmt::format("--antialias {}: POV-Ray's depth is at most 9", texts.antialias));
    if (options.frame.antialiasing.threshold > 1)
        throw UsageError(fmt::format("--antialias {}: POV-Ray's threshold is at most 1", texts.antialias));
    options.device = parse_device(texts.device.device);
    options.time_limit = double(parse_count("--time-limit", texts.time_limit, 1, 1'000'000));
}

} // namespace

CLI::App* add_compare(CLI::App& app, CompareTexts& texts) {
    CLI::App* compare = app.add_subcommand("compare", "Compare two pictures, two sequences, or POV-Ray with Proxima");
    add_scene_options(*compare, texts.scene);
    add_device_options(*compare, texts.device);
    add_antialias_option(*compare, texts.antialias);
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
        "  proxima compare ball.scn --povray --size 320x240\n"
        "  proxima compare ball.ini --povray --antialias method2:0.1:4\n");
    return compare;
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

} // namespace proxima
