// SPDX-License-Identifier: Apache-2.0
#include "renderer/tradeoff/tradeoff_options.h"
#include "renderer/errors.h"
#include "renderer/ini_options.h"
#include "renderer/option_values.h"

namespace proxima {

CLI::App* add_tradeoff(CLI::App& app, TradeoffTexts& texts) {
    CLI::App* tradeoff =
        app.add_subcommand("tradeoff", "Measure time against error for the settings that trade them, for a scene");
    add_scene(*tradeoff, texts.scene);
    tradeoff->get_option("SCENE")->required();
    tradeoff->add_option("-o,--output", texts.output, "Folder for the tables, the chart and the page")
        ->type_name("DIR")
        ->required();
    tradeoff->add_option("--budget", texts.budget, "Seconds that it may take, about [60]")->type_name("S");
    tradeoff->add_option("--repeats", texts.repeats, "Measurements of each setting's time [3]")->type_name("N");
    tradeoff->add_flag("--quiet", texts.quiet, "Say nothing of what is being measured");
    add_scene_options(*tradeoff, texts.scene);
    tradeoff->add_option("--subset", texts.scene.subset, "The frame of --frames to look at [the first]")
        ->type_name("RANGE");
    add_shutter_options(*tradeoff, texts.scene);
    add_override_options(*tradeoff, texts.scene);
    add_device_options(*tradeoff, texts.device);
    tradeoff->remove_option(tradeoff->get_option("--precision"));
    tradeoff->add_option("--tolerances", texts.tolerances, "exact, or povray [exact]")->type_name("T");
    tradeoff->footer(
        "Samples and antialiasing, precision, and what of trace level, bail-out, area lights and shutter the scene\n"
        "reacts to are varied, in a picture that is small enough for the budget; the trace level and its like only\n"
        "from what the scene or an option says downwards. Errors are against a picture in double with 65 samples a\n"
        "pixel (17 and twice the moments with a shutter).\n"
        "DIR gets index.html, chart.svg, table.txt, table.csv, table.json, pictures and files.\n"
        "Example:\n"
        "  proxima tradeoff ball.scn -o tradeoff --size 1920x1080 --budget 120\n");
    return tradeoff;
}

TradeoffOptions read_tradeoff_options(const CLI::App& command, TradeoffTexts& texts) {
    if (texts.scene.scene == "-")
        throw UsageError("-: tradeoff reads the scene more than once, and standard input can be read once; save the "
                         "scene in a file");
    apply_ini(command, texts.scene);
    TradeoffOptions options;
    options.scene = read_scene_options(texts.scene);
    options.frame = read_frame_settings(options.scene, texts.device);
    options.frame.tolerances = parse_choice<Tolerances>("--tolerances", texts.tolerances,
                                                        {{"exact", Tolerances::exact}, {"povray", Tolerances::povray}});
    options.device = parse_device(texts.device.device);
    options.threads = parse_count("--threads", texts.device.threads, 0, 4096);
    options.folder = texts.output;
    options.budget = parse_count("--budget", texts.budget, 1, 1'000'000);
    options.repeats = parse_count("--repeats", texts.repeats, 1, 1000);
    options.quiet = texts.quiet;
    return options;
}

} // namespace proxima
