// SPDX-License-Identifier: Apache-2.0
#include "renderer/errors.h"
#include "renderer/options.h"

#include <doctest/doctest.h>

using namespace proxima;

namespace {

Command parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "proxima");
    return parse_command_line(int(arguments.size()), arguments.data());
}

RenderOptions render(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), {"render", "folder/ball.scn"});
    return std::get<RenderOptions>(parse(arguments));
}

} // namespace

TEST_CASE("options: a scene alone is a still with every default") {
    const RenderOptions options = render({});
    CHECK(options.scene.scene == "folder/ball.scn");
    CHECK(options.output->path(0) == "ball.png");
    CHECK(options.type == SampleType::uint8);
    CHECK(options.scene.animation.is_still);
    CHECK(options.frame.width == 640);
    CHECK(options.scene.height == 480);
    CHECK(options.frame.samples == 1);
    CHECK(options.frame.precision == Precision::automatic);
    CHECK(options.frame.tolerances == Tolerances::exact);
    CHECK(options.frame.accelerator == Accelerator::automatic);
    CHECK(options.frame.grid == std::array<uint32_t, 3>{0, 0, 0});
    CHECK(options.device.is_automatic());
    CHECK_FALSE(options.color.config);
    CHECK(options.threads == 0);
}

TEST_CASE("options: every option reaches its value") {
    const RenderOptions options = render({"-o",       "out/a.####.tif", "--size",    "32x16",
                                          "--frames", "1-10",           "--subset",  "3,5",
                                          "--clock",  "-1:2.5",         "--cyclic",  "--declare",
                                          "N=2",      "--declare",      "S=\"a b\"", "--samples",
                                          "9",        "--device",       "cuda:3",    "--accel",
                                          "brute",    "--grid",         "8x9x10",    "--precision",
                                          "double",   "--tolerances",   "povray",    "--bits",
                                          "16",       "--display",      "D",         "--view",
                                          "V",        "--ocio",         "c.ocio",    "--threads",
                                          "3",        "--include-path", "i",         "--include-path",
                                          "j",        "--progress",     "json",      "--stats-json",
                                          "s.json"});
    CHECK(options.output->path(3) == "out/a.0003.tif");
    CHECK(options.frame.width == 32);
    CHECK(options.frame.height == 16);
    CHECK(options.scene.animation.frames == std::vector<int64_t>{3, 5});
    CHECK(options.scene.animation.final_frame == 10);
    CHECK(options.scene.animation.initial_clock == -1.0f);
    CHECK(options.scene.animation.final_clock == 2.5f);
    CHECK(options.scene.animation.cyclic);
    REQUIRE(options.scene.declares.size() == 2);
    CHECK(options.scene.declares[1].second == "\"a b\"");
    CHECK(options.frame.samples == 9);
    CHECK(options.device.items == std::vector<DeviceChoice::Item>{{DeviceChoice::Item::Kind::cuda, 3}});
    CHECK(options.frame.accelerator == Accelerator::brute);
    CHECK(options.frame.grid == std::array<uint32_t, 3>{8, 9, 10});
    CHECK(options.frame.precision == Precision::float64);
    CHECK(options.frame.tolerances == Tolerances::povray);
    CHECK(options.type == SampleType::uint16);
    CHECK(options.color.view == "V");
    CHECK(options.color.config == "c.ocio");
    CHECK(options.threads == 3);
    CHECK(options.scene.include_paths.size() == 2);
    CHECK(options.progress == ProgressStyle::json);
    CHECK(options.stats_json == "s.json");
}

TEST_CASE("options: an animation has numbered names") {
    CHECK(render({"--frames", "1-3"}).output->path(2) == "ball.0002.png");
    CHECK(render({"--frames", "-2-3"}).scene.animation.initial_frame == -2);
    CHECK(render({"--grid", "16"}).frame.grid == std::array<uint32_t, 3>{16, 16, 16});
    CHECK(render({"--frames", "1-9", "--shard", "2/4"}).scene.animation.frames == std::vector<int64_t>{2, 6});
    CHECK(render({"--frames", "1-9", "--subset", "1-9x2", "--shard", "2/4"}).scene.animation.frames ==
          std::vector<int64_t>{3});
    CHECK(render({"--frames", "1-9", "--shard", "2/4"}).scene.animation.final_frame == 9);
    CHECK(render({"--frames", "1-9", "-o", "a.gif", "--fps", "23.976"}).rate == FrameRate{24000, 1001});
    CHECK(render({"--frames", "1-9", "-o", "a.##.exr", "--movie", "a.webm", "--view", "V"}).movie == "a.webm");
    CHECK(render({"--dry-run"}).dry_run);
    CHECK(render({"-o", "a.exr", "--aov", "id,depth"}).frame.aovs == AovLayers{.depth = true, .id = true});
    CHECK_FALSE(render({"-o", "a.exr"}).frame.aovs.any());
    CHECK(render({"--clock", "0.25"}).scene.animation.initial_clock == 0.25f);
}

TEST_CASE("options: what cannot be is refused, and the message says what to write") {
    struct Row {
        std::vector<const char*> arguments;
        const char* message;
    };
    const Row rows[] = {
        {{"--size", "640"}, "--size 640: write width x height in pixels, like 1280x720"},
        {{"--size", "0x10"}, "--size 0x10: write width x height in pixels, like 1280x720"},
        {{"--size", "65537x1"},
         "--size 65537x1: a picture has at most 65536 pixels a side and 2147483648 in all; choose a smaller one"},
        {{"--size", "65536x65536"},
         "--size 65536x65536: a picture has at most 65536 pixels a side and 2147483648 in all; choose a smaller one"},
        {{"--size", "99999999999999999999x2"},
         "--size 99999999999999999999x2: write width x height in pixels, like 1280x720"},
        {{"--antialias", "method3"},
         "--antialias method3: write none, grid:N, method1[:THRESHOLD[:DEPTH]] or method2[:THRESHOLD[:DEPTH]]"},
        {{"--antialias", "method1:x"}, "--antialias method1:x: the threshold is a number from 0 to 3"},
        {{"--antialias", "method2:0.1:6"}, "--antialias method2:0.1:6: the last part is a whole number from 1 to 5"},
        {{"--antialias", "grid:3:3"},
         "--antialias grid:3:3: there are too many parts; write grid:N, method1:THRESHOLD:DEPTH or "
         "method2:THRESHOLD:DEPTH"},
        {{"--antialias", "grid:3", "--samples", "4"},
         "--samples, --antialias: each says where the rays go; give one of them"},
        {{"--samples", "0"}, "--samples 0: write a whole number from 1 to 65536"},
        {{"--threads", "many"}, "--threads many: write a whole number from 0 to 4096"},
        {{"--device", "gpu"},
         "--device gpu: write auto, cpu, cuda, cuda:N or a list like cuda:0,2 or cuda,cpu; `proxima devices` lists "
         "them"},
        {{"--accel", "gird"}, "--accel gird: not one of auto, brute, cloud, grid; did you mean grid?"},
        {{"--grid", "1x2"}, "--grid 1x2: write one number of voxels for all axes, or three like 64x32x64"},
        {{"--grid", "60000x60000x60000"},
         "--grid 60000x60000x60000: more than 4294967296 voxels; choose a coarser grid"},
        {{"--precision", "half"}, "--precision half: not one of auto, double, float"},
        {{"--clock", "soon"},
         "--clock soon: 'soon' is not a finite number; write 0.25 for a still, 0:1 for an animation"},
        {{"--clock", "1e40"},
         "--clock 1e40: '1e40' is not a finite number; write 0.25 for a still, 0:1 for an animation"},
        {{"--clock", "0:1"}, "--clock 0:1: a still has one clock; write --clock 0, or give --frames A-B too"},
        {{"--clock", "1", "--frames", "1-2"}, "--clock 1: an animation's clock is a range; write --clock 0:1"},
        {{"--cyclic"}, "--cyclic: only an animation goes round; give --frames A-B too"},
        {{"--subset", "1"}, "--subset: it chooses from an animation's frames; give --frames A-B too"},
        {{"--frames", "1-3", "--subset", "2-4"},
         "--subset 2-4: frame 4 is not one of --frames 1-3; --frames is the whole animation"},
        {{"--frames", "1-3", "-o", "a.png"},
         "-o a.png: an animation's frames need names of their own; write a.####.png"},
        {{"-o", "a.##.png"},
         "-o a.##.png: a still has no frame number; take '#' or '%d' out of the name, or give --frames A-B"},
        {{"-o", "a.exr", "--view", "Raw"},
         "--display, --view, --look: this file holds scene-linear light, not a view of it; write a .png, name a "
         "--colorspace, or leave them out"},
        {{"-o", "a.exr", "--dither"}, "--dither: half and float numbers are not rounded to levels; leave it out"},
        {{"--colorspace", "ACEScg", "--view", "Raw"},
         "--colorspace ACEScg: the files hold either a colour space or a view of a display; leave out --display, "
         "--view "
         "and --movie"},
        {{"--working-space", "p3"}, "--working-space p3: not one of acescg, rec709"},
        {{"-o", "a.gif", "--frames", "1-3", "--shard", "1/3"},
         "-o a.gif: a .gif holds all frames at once; render parts to -o OUT.####.png"},
        {{"-o", "a.gif", "--skip-existing"},
         "--skip-existing: a .gif does not say what it is of; leave it out, or write -o OUT.####.png"},
        {{"--frames", "1-3", "-o", "a.###.gif"},
         "-o a.###.gif: a .gif holds all frames; take the frame number out of its name"},
        {{"--movie", "a.mp4"}, "--movie a.mp4: a still does not move; give --frames A-B too"},
        {{"--movie", "a.mp4", "-o", "a.gif", "--frames", "1-3"},
         "--movie a.mp4: a film is made of picture files; write -o OUT.####.png"},
        {{"--shard", "1/2"}, "--shard: it chooses from an animation's frames; give --frames A-B too"},
        {{"--frames", "1-3", "--shard", "4/3"}, "--shard 4/3: write I/N with I from 1 to N, like 2/5, or slurm"},
        {{"--fps", "0"}, "--fps 0: write frames a second from 0.01 to 1000, like 24, 29.97 or 30000/1001"},
        {{"--declare", "2x=1"}, "--declare 2x=1: write NAME=VALUE, like Count=12"},
        {{"--declare", "Name=red"},
         "--declare Name=red: the value is neither a number nor a text in double quotes; write 'Name=\"red\"' with the "
         "quotes"},
        {{"--bits", "12"}, "--bits 12: this type of file does not hold it; it holds 8, 16"},
        {{"-o", "a.exr", "--aov", "depht"}, "--aov depht: not one of depth, id, normal, steps; did you mean depth?"},
        {{"-o", "a.exr", "--aov", "id,"}, "--aov : not one of depth, id, normal, steps"},
        {{"-o", "a.png", "--aov", "id"}, "--aov id: only .exr files hold layers; write -o OUT.exr"},
        {{"-o", "a.exr", "--aov", "id,normal", "--compression", "dwaa"},
         "--aov id,normal: dwaa takes N.Y for a luminance and loses a part of it; choose another --compression, or "
         "leave "
         "normal out"},
        {{"--progress", "loud"}, "--progress loud: not one of auto, bar, json, none, openjd, plain"},
    };
    for (const Row& row : rows) {
        CAPTURE(row.message);
        CHECK_THROWS_WITH_AS(render(row.arguments), row.message, UsageError);
    }
    CHECK_THROWS_WITH_AS(parse({}), "no command; write `proxima render SCENE`, or see `proxima --help`", UsageError);
    CHECK_THROWS_WITH_AS(
        parse({"rendr", "a.scn"}),
        "'rendr' is no command; write one of render, verify, compare, check, plan, tradeoff, bench, devices; "
        "did you mean render?",
        UsageError);
    CHECK_THROWS_AS(parse({"render"}), UsageError);
    CHECK_THROWS_AS(parse({"render", "a.scn", "--colour"}), UsageError);
    CHECK_THROWS_AS(parse({"render", "a.scn", "b.scn"}), UsageError);
}

TEST_CASE("options: help and version are text, not errors") {
    CHECK(std::get<Information>(parse({"--version"})).text == "proxima " PROXIMA_VERSION "\n");
    CHECK(std::get<Information>(parse({"--help"})).text.find("render") != std::string::npos);
    CHECK(std::get<Information>(parse({"render", "--help"})).text.find("--tolerances") != std::string::npos);
    CHECK(std::get<DevicesOptions>(parse({"devices", "--json"})).json);
    CHECK(std::get<CheckOptions>(parse({"check", "a.scn", "--size", "10x20"})).scene.height == 20);
}
