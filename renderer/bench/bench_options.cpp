// SPDX-License-Identifier: Apache-2.0
#include "renderer/bench/bench_options.h"
#include "renderer/errors.h"
#include "renderer/option_values.h"

#include <sstream>

namespace proxima {
namespace {

std::vector<std::string> parse_list(const std::string& text) {
    std::vector<std::string> items;
    std::istringstream list(text);
    for (std::string item; std::getline(list, item, ',');)
        items.push_back(item);
    return items;
}

} // namespace

CLI::App* add_bench(CLI::App& app, BenchTexts& texts) {
    CLI::App* bench =
        app.add_subcommand("bench", "Measure: the seed paper's experiments and ours, as tables and charts");
    bench->add_option("NAME", texts.name, "seed, sparse or scale")->required();
    bench->add_option("-o,--output", texts.output, "Write tables (text, JSON, CSV), charts (SVG) and the scenes there")
        ->type_name("DIR");
    bench->add_option("--device", texts.device, "cpu, cuda:N or a list [auto: a CUDA device or the CPU; seed: both]")
        ->type_name("DEVICE");
    bench->add_flag("--full", texts.full, "All counts and resolutions, at 1920x1080 [about a minute on two cores]");
    bench->add_option("--spheres", texts.spheres, "Other numbers of spheres, with commas [by the experiment]")
        ->type_name("N,N,...");
    bench->add_option("--only", texts.scenes, "Only these scenes or figures, with commas: planes, \"figure 5\" [all]")
        ->type_name("NAME,NAME,...");
    bench->add_option("--size", texts.size, "Width x height in pixels [320x180; --full: 1920x1080]")->type_name("WxH");
    bench
        ->add_option("--repeats", texts.repeats,
                     "Frames that a time is the median of, if they are fast [5; --full: 30]")
        ->type_name("N");
    bench->add_option("--threads", texts.threads, "CPU threads [0: all cores]")->type_name("N");
    bench->add_flag("--json", texts.json, "Print JSON instead of a table");
    bench->footer(
        "seed    Figures 2 to 9 of R. Thomas and S. K. Semwal, \"Ray Tracing using 3D Grid Simulations\", 2014, "
        "beside\n"
        "        the numbers that it states: brute force, grid, cloud, its own way to build both, and each at its "
        "best\n"
        "sparse  how much empty space there is against what leaping over it saves, at one number of spheres\n"
        "scale   10 thousand to 1 million spheres (--full: 10 million; more by --spheres), and maps of up to 512^3\n"
        "All spheres move and everything is rebuilt for every frame. Every method must make the same picture.\n"
        "Exit codes: 0 done; 2 the command line is wrong; 3 DIR cannot be written; 4 pictures differ.\n"
        "Example:\n"
        "  proxima bench seed -o seed --full\n");
    return bench;
}

BenchOptions read_bench_options(const BenchTexts& texts) {
    using Name = BenchOptions::Name;
    BenchOptions options;
    options.name = parse_choice<Name>("NAME", texts.name,
                                      {{"seed", Name::seed}, {"sparse", Name::sparse}, {"scale", Name::scale}});
    if (!texts.output.empty())
        options.output = texts.output;
    options.device = parse_device(texts.device);
    options.threads = parse_count("--threads", texts.threads, 0, 4096);
    options.full = texts.full;
    if (!texts.size.empty())
        std::tie(options.width, options.height) = parse_size(texts.size);
    if (!texts.repeats.empty())
        options.repeats = parse_count("--repeats", texts.repeats, 1, 100'000);
    for (const std::string& item : parse_list(texts.spheres))
        options.spheres.push_back(parse_count("--spheres", item, 1, 1'000'000'000));
    options.scenes = parse_list(texts.scenes);
    options.json = texts.json;
    return options;
}

} // namespace proxima
