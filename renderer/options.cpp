// SPDX-License-Identifier: Apache-2.0
#include "renderer/options.h"
#include "renderer/bench/bench_options.h"
#include "renderer/compare_options.h"
#include "renderer/errors.h"
#include "renderer/ini_options.h"
#include "renderer/option_values.h"
#include "renderer/render_options.h"
#include "renderer/tradeoff/tradeoff_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>

namespace proxima {
namespace {

/// CLI11 would only say that a command is missing.
void check_command_name(int argc, const char* const* argv) {
    static constexpr std::string_view names[] = {"render", "verify",   "compare", "check",
                                                 "plan",   "tradeoff", "bench",   "devices"};
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
               "written; 4 compare or verify found a difference; 33 out of memory; 75 a device was lost, try again "
               "elsewhere;\n"
               "128+n after signal n.\n");

    RenderTexts render_texts;
    SceneTexts check_texts;
    DevicesOptions devices_options;
    const CLI::App* render = add_render(app, render_texts);
    RenderTexts verify_texts;
    const CLI::App* verify = add_verify(app, verify_texts);
    CompareTexts compare_texts;
    const CLI::App* compare = add_compare(app, compare_texts);
    TradeoffTexts tradeoff_texts;
    const CLI::App* tradeoff = add_tradeoff(app, tradeoff_texts);
    CLI::App* check = app.add_subcommand("check", "Read a scene, report every mistake, count what is in it");
    add_scene(*check, check_texts);
    check->get_option("SCENE")->required();
    add_scene_options(*check, check_texts);
    PlanOptions plan_options;
    SceneTexts plan_texts;
    CLI::App* plan = app.add_subcommand("plan", "Tell how a scene would be rendered, and why, in numbers");
    add_scene(*plan, plan_texts);
    add_scene_options(*plan, plan_texts);
    add_choice_options(*plan, plan_texts, "plan for");
    add_shutter_options(*plan, plan_texts);
    DeviceTexts plan_device;
    add_device_options(*plan, plan_device);
    plan->add_flag("--json", plan_options.json, "As JSON");
    BenchTexts bench_texts;
    const CLI::App* bench = add_bench(app, bench_texts);
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
    if (render->parsed() && render_texts.color.list)
        return ColorChoicesOptions{read_color_options(render_texts.color, SampleType::uint8, true)};
    if (render->parsed())
        return read_render_options(*render, render_texts);
    if (verify->parsed())
        return read_verify_options(*verify, verify_texts);
    if (compare->parsed()) {
        if (compare_texts.povray) {
            const IniOptions ini = apply_ini(*compare, compare_texts.scene);
            apply_ini_rendering(*compare, ini, compare_texts.scene, compare_texts.device, compare_texts.antialias);
        }
        return read_compare_options(*compare, compare_texts);
    }
    if (tradeoff->parsed())
        return read_tradeoff_options(*tradeoff, tradeoff_texts);
    if (check->parsed()) {
        apply_ini(*check, check_texts);
        return CheckOptions{read_scene_options(check_texts)};
    }
    if (plan->parsed()) {
        apply_ini(*plan, plan_texts);
        plan_options.scene = read_scene_options(plan_texts);
        plan_options.frame = read_frame_settings(plan_options.scene, plan_device);
        plan_options.device = parse_device(plan_device.device);
        plan_options.threads = parse_count("--threads", plan_device.threads, 0, 4096);
        return plan_options;
    }
    if (bench->parsed())
        return read_bench_options(bench_texts);
    if (!devices->parsed())
        throw UsageError("no command; write `proxima render SCENE`, or see `proxima --help`");
    return devices_options;
}

} // namespace proxima
